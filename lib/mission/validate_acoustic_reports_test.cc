// Acoustic node reports that collide: the warnings, with their exact texts.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/load_testing.h"

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
