#include "apps/shoal_log/log_encounters.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_encounters_test {

class LogEncountersCommand : public ::testing::Test {
 protected:
  int Run() {
    out_.str("");
    err_.str("");
    return LogEncounters(options_, out_, err_);
  }

  static TestEvent Nav(const std::string& vehicle, double time_s, double y_m, double heading_deg) {
    nav_t nav{};
    nav.utime = static_cast<int64_t>(time_s * 1e6 + 0.5);
    nav.x_m = heading_deg > 90 ? 10 : 0;
    nav.y_m = y_m;
    nav.heading_deg = heading_deg;
    nav.speed_mps = 3;
    return {.utime = nav.utime, .channel = "NAV_" + vehicle, .data = Encoded(nav)};
  }

  /// Two vessels that meet head-on after 40 s.
  static std::vector<TestEvent> HeadOn() {
    std::vector<TestEvent> events;
    for (int time_s = 0; time_s <= 80; ++time_s) {
      events.push_back(Nav("ALPHA", time_s, 3.0 * time_s, 0));
      events.push_back(Nav("BRAVO", time_s, 240 - 3.0 * time_s, 180));
    }
    return events;
  }

  TestDirectory directory_;
  LogEncountersOptions options_{.path = directory_.File("mission.lcm")};
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(LogEncountersCommand, ShowsEachVesselsPart) {
  WriteLog(options_.path, HeadOn());
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_EQ(err_.str(), "");
  EXPECT_NE(out_.str().find("alpha        bravo        head-on"), std::string::npos) << out_.str();
  EXPECT_NE(out_.str().find("bravo        alpha        head-on"), std::string::npos) << out_.str();
}

TEST_F(LogEncountersCommand, PrintsCsvOrAnExplanation) {
  WriteLog(options_.path, HeadOn());
  options_.csv = true;
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_TRUE(out_.str().starts_with("begin_s,end_s,")) << out_.str();
  options_.csv = false;
  options_.explain = true;
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(out_.str().find("alpha toward bravo"), std::string::npos) << out_.str();
}

TEST_F(LogEncountersCommand, StatesThatThereWasNoEncounter) {
  WriteLog(options_.path, {Nav("ALPHA", 0, 0, 0), Nav("BRAVO", 0, 500, 180)});
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(out_.str().find("No encounters"), std::string::npos);
}

TEST_F(LogEncountersCommand, RefusesALogWithoutNavAndDistancesThatDoNotGrow) {
  WriteLog(options_.path, {{.utime = 0, .channel = "OTHER", .data = {1, 2, 3}}});
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("holds no NAV_*"), std::string::npos);
  options_.encounter.near_miss_m = 100;
  EXPECT_EQ(Run(), kExitUsage);
}

TEST_F(LogEncountersCommand, SurvivesAHostileLog) {
  std::vector<TestEvent> events = HeadOn();
  nav_t nav{};
  nav.x_m = std::numeric_limits<double>::infinity();
  events.push_back({.utime = 81'000'000, .channel = "NAV_ALPHA", .data = Encoded(nav)});
  events.push_back({.utime = 81'000'000, .channel = "NAV_ALPHA", .data = {1, 2}});
  events.push_back({.utime = 81'000'000, .channel = "HELM_DECISION_ALPHA", .data = {9}});
  events.push_back({.utime = 81'000'000, .channel = "NODE_REPORT_LOCAL", .data = {}});
  node_report_t report{};
  report.name = "al\npha\x1b";
  report.length_m = -1e300;
  events.push_back({.utime = 81'000'000, .channel = "NODE_REPORT_LOCAL", .data = Encoded(report)});
  WriteLog(options_.path, events);
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(err_.str().find("1 NAV with impossible numbers"), std::string::npos) << err_.str();
  EXPECT_NE(err_.str().find("3 messages do not decode"), std::string::npos) << err_.str();
  EXPECT_EQ(out_.str().find('\x1b'), std::string::npos);
}

}  // namespace shoal::log_encounters_test
