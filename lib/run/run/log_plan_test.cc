#include "lib/run/run/log_plan.h"

#include <gtest/gtest.h>

#include "lib/mission/file/load.h"

namespace shoal::log_plan_test {

/// Ten vessels in a row, 40 m apart, for `duration_s`.
Mission Fleet(double duration_s, const std::string& comms = "comms_range = 1000") {
  const std::string text = "[mission]\nduration_s = " + std::to_string(duration_s) + "\n[comms]\n" +
                           comms +
                           "\n[template.boat]\n[[fleet]]\ntemplate = \"boat\"\ncount = 10\n"
                           "name = \"v{n:02}\"\norigin = { x_m = 0, y_m = 0 }\nspacing_m = 40\n"
                           "columns = 10\n";
  LoadedMission loaded = LoadMissionText(text, "fleet.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

std::string WarningsOf(const LogPlan& plan) {
  std::string text;
  for (const std::string& warning : plan.warnings) text += warning + "\n";
  return text;
}

TEST(EstimateLog, GrowsWithTheMissionAndShrinksWithWhatIsLeftOut) {
  const double ten_s = EstimateLog_bytes(Fleet(10));
  EXPECT_GT(ten_s, 1e5);
  EXPECT_NEAR(EstimateLog_bytes(Fleet(100)) / ten_s, 10, 0.2);
  const double without_reports =
      EstimateLog_bytes(Fleet(10), {.without = {"NODE_REPORT*", "VIEW_COMMS_PULSE"}});
  EXPECT_LT(without_reports, 0.6 * ten_s);
  EXPECT_GT(without_reports, 0.1 * ten_s);
  EXPECT_EQ(EstimateLog_bytes(Fleet(10), {.only = {"MINE"}}), 0);
}

TEST(EstimateLog, CountsReportsWhereTheyCanBeReceivedAtTheStart) {
  const ChannelChoice reports = {.only = {"NODE_REPORT_V01"}};
  const double all = EstimateLog_bytes(Fleet(10), reports);
  EXPECT_NEAR(EstimateLog_bytes(Fleet(10, "comms_range = 41"), reports), all / 9, 1);
  EXPECT_EQ(EstimateLog_bytes(Fleet(10, "comms_range = 39"), reports), 0);
}

TEST(LogPlan, CompressesARecordingAboveTheLimitAlone) {
  const Mission small = Fleet(100);
  const Mission large = Fleet(10'000);
  ASSERT_LT(EstimateLog_bytes(small), kPlainLog_bytes);
  ASSERT_GT(EstimateLog_bytes(large), kPlainLog_bytes);
  EXPECT_FALSE(PlanLog(small, {}, ".").is_compressed);
  EXPECT_TRUE(PlanLog(large, {}, ".").is_compressed);
  EXPECT_TRUE(PlanLog(small, {}, ".", true).is_compressed);
  EXPECT_FALSE(PlanLog(large, {}, ".", false).is_compressed);
}

TEST(LogPlan, TakesTheFormOfALogFromItsName) {
  EXPECT_TRUE(PlanLog(Fleet(10), {}, "./a.lcm.zst").is_compressed);
  EXPECT_FALSE(PlanLog(Fleet(10'000), {}, "./a.lcm").is_compressed);
}

TEST(LogPlan, WarnsWhereTheDiskWillNotHoldIt) {
  EXPECT_EQ(WarningsOf(PlanLog(Fleet(10), {}, "no/such/folder/a.lcm")), "");
  Mission endless = Fleet(10);
  endless.duration_s = 1e15;
  const std::string warnings = WarningsOf(PlanLog(endless, {}, "no/such/folder/a.lcm"));
  EXPECT_NE(warnings.find("the log may have"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("compress it"), std::string::npos) << warnings;
}

TEST(LogPlan, WarnsOfNamesThatNoChannelHas) {
  EXPECT_EQ(WarningsOf(PlanLog(Fleet(10), {.only = {"NAV_*"}, .without = {"UNC_*"}}, ".")), "");
  const std::string warnings =
      WarningsOf(PlanLog(Fleet(10), {.only = {"NVA_*"}, .without = {"NAV_V11"}}, "."));
  EXPECT_NE(warnings.find("--channels 'NVA_*' matches none"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("--without 'NAV_V11' matches none"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("such as NAV_V01"), std::string::npos) << warnings;
}

TEST(BytesText, HasAUnitThatFits) {
  EXPECT_EQ(BytesText(0), "1 kB");
  EXPECT_EQ(BytesText(597e6), "597 MB");
  EXPECT_EQ(BytesText(8.84e9), "8.8 GB");
}

}  // namespace shoal::log_plan_test
