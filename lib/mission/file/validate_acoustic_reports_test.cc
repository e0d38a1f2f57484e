// Acoustic node reports that collide: the warnings, with their exact texts.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/file/load_testing.h"

namespace shoal::validate_acoustic_reports_test {

const std::vector<std::string> kThree = {"alpha", "bravo", "charlie"};

/// Returns the warnings of a mission whose vehicles report over the acoustic network; `leader`
/// leads.
std::vector<std::string> Warnings(const std::vector<std::string>& vehicles,
                                  const std::string& acoustics, const std::string& reporter,
                                  std::string_view leader = "") {
  std::string text =
      "[mission]\nduration_s = 60\n[comms]\nreports_over = \"acoustic\"\n[acoustics]\n" +
      acoustics + "\n[template.t]\nreporter = {" + reporter + "}\n";
  for (const std::string& name : vehicles) {
    text += "[[vehicle]]\nname = \"" + name + "\"\ntemplate = \"t\"\n";
    if (name == leader) text += "acoustic_leader = true\n";
  }
  const LoadedMission loaded = LoadMissionText(text, "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return WarningsBesideConduct(loaded);
}

TEST(LoadWarnings, ReportReportsThatAreSentAllAtOnce) {
  const std::string slow = "rate_hz = 0.1";
  EXPECT_EQ(Warnings(kThree, "access_mode = \"tdma\"", slow),
            std::vector<std::string>{
                "m.toml:4:16: warning: alpha and bravo report at the same moments, every 10 s, and "
                "send on one channel: many will not be received; write rate_hz = 10, "
                "blackout_interval_s = 10 and blackout_variance_s = 8 in [vehicle.reporter], so "
                "that chance parts them, or "
                "access_mode = \"fdma\" in [acoustics]"});
  EXPECT_EQ(Warnings(kThree, "modem = \"nanomodem_v3\"", slow),
            std::vector<std::string>{
                "m.toml:4:16: warning: alpha and bravo report at the same moments, every 10 s, and "
                "do not receive while they send (half_duplex): many will not be received; write "
                "rate_hz = 10, blackout_interval_s = 10 and blackout_variance_s = 8 in "
                "[vehicle.reporter], so "
                "that chance parts them"});
  const auto of_followers = Warnings(kThree, "access_mode = \"tdma_lf\"", slow, "alpha");
  ASSERT_EQ(of_followers.size(), 1U);
  EXPECT_NE(of_followers[0].find("bravo and charlie"), std::string::npos)
      << "the leader has the other channel";
}

TEST(LoadWarnings, ReportJitterThatIsFinerThanThePaceOfReports) {
  EXPECT_EQ(Warnings(kThree, "access_mode = \"shared\"",
                     "rate_hz = 0.1, blackout_interval_s = 10, blackout_variance_s = 8")
                .size(),
            1U);
}

/// Returns the warnings of a mission with one vehicle of shoal's and one that reports its position
/// over netsim's interface.
std::vector<std::string> WarningsWithOutsider(const std::string& acoustics,
                                              const std::string& reports_over) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n[comms]\ncomms_range = 5000\nreports_over = \"" + reports_over +
          "\"\n[acoustics]\n" + acoustics +
          "\n[[vehicle]]\nname = \"alpha\"\nreporter = {rate_hz = 0.01}\n"
          "[[vehicle]]\nname = \"outsider\"\noutside = true\n[netsim]\nport = 62500\n"
          "[[netsim.environment]]\nname = \"bay\"\nlat_min_deg = 43\nlat_max_deg = 44\n"
          "lon_min_deg = -71\nlon_max_deg = -70\ndepth_max_m = 100\n"
          "[[netsim.vehicle]]\nname = \"outsider\"\nmodem_tcp_port = 62000\n"
          "environment = \"bay\"\nmodem = \"micromodem\"\n",
      "m.toml");
  EXPECT_EQ(loaded.errors, std::vector<std::string>{});
  return WarningsBesideConduct(loaded);
}

TEST(LoadWarnings, ReportPositionsOfClientsThatFillTheNetwork) {
  EXPECT_EQ(WarningsWithOutsider("modem = \"whoi_micromodem\"", "acoustic"),
            std::vector<std::string>{
                "m.toml:5:16: warning: each position that outsider sends over netsim's interface "
                "becomes a node report, at most one every 0.1 s, which takes 0.0618868 s at 5300 "
                "bit/s: reports fill the network; write reports_over = \"direct\" (what modems and "
                "messages_over = \"acoustic\" send stays acoustic), or let the client send a "
                "position every 0.12 s or more seldom"});
  EXPECT_EQ(WarningsWithOutsider("modem = \"whoi_micromodem\"", "direct"),
            std::vector<std::string>{});
  EXPECT_EQ(WarningsWithOutsider("access_mode = \"shared\"\ndata_rate_bps = 1e6", "acoustic"),
            std::vector<std::string>{});
}

TEST(LoadWarnings, AreNoneForReportsThatDoNotCollide) {
  const std::string slow = "rate_hz = 0.1";
  EXPECT_EQ(Warnings(kThree, "access_mode = \"fdma\"", slow).size(), 0U);
  EXPECT_EQ(Warnings(kThree, "access_mode = \"shared\"\ncollisions = \"off\"", slow).size(), 0U);
  EXPECT_EQ(Warnings(kThree, "access_mode = \"shared\"",
                     "rate_hz = 10, blackout_interval_s = 10, blackout_variance_s = 8")
                .size(),
            0U);
  EXPECT_EQ(Warnings({"alpha", "bravo"}, "access_mode = \"shared\"", slow).size(), 0U)
      << "no third node receives the collision";
}

}  // namespace shoal::validate_acoustic_reports_test
