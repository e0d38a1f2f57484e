#include "apps/shoal_log/log_helm.h"

#include <gtest/gtest.h>

#include <sstream>

#include "lib/base/check/result.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_testing.h"

namespace shoal::log_helm_test {

TestEvent DecisionAt(int64_t utime, const char* vehicle, double course_deg) {
  helm_decision_t decision{};
  decision.utime = utime;
  decision.vehicle = vehicle;
  decision.course_deg = course_deg;
  decision.speed_mps = 2;
  decision.depth_m = -1;
  decision.all_stop = "clear";
  return {
      .utime = utime, .channel = channels::HelmDecision(vehicle).name, .data = Encoded(decision)};
}

class LogHelmCommand : public ::testing::Test {
 protected:
  int Run() {
    out_.str("");
    err_.str("");
    return LogHelm(options_, out_, err_);
  }

  TestDirectory directory_;
  LogHelmOptions options_{.path = directory_.File("mission.lcm")};
  std::ostringstream out_;
  std::ostringstream err_;
};

TEST_F(LogHelmCommand, ShowsTheDecisionThatCountedAtATime) {
  WriteLog(options_.path,
           {DecisionAt(1'000'000, "alpha", 90), DecisionAt(2'000'000, "alpha", 70),
            DecisionAt(2'000'000, "bravo", 200), DecisionAt(3'000'000, "alpha", 60)});
  options_.vehicle = "Alpha";
  options_.at_s = 2.9;
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_EQ(out_.str(),
            "alpha at 2.000 s: course 70 deg, speed 2.0 m/s\n"
            "Every behavior got what it wanted most.\n");
}

TEST_F(LogHelmCommand, ListsOneLineForEachDecisionOfAllVehicles) {
  WriteLog(options_.path,
           {DecisionAt(1'000'000, "alpha", 90), DecisionAt(2'000'000, "bravo", 200)});
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find("1.000  alpha        course 90 deg, speed 2.0 m/s"), std::string::npos)
      << out_.str();
  EXPECT_NE(out_.str().find("2.000  bravo        course 200 deg"), std::string::npos) << out_.str();
}

TEST_F(LogHelmCommand, NamesTheVehiclesThatALogHasWhereAnotherIsAskedFor) {
  WriteLog(options_.path, {DecisionAt(1'000'000, "alpha", 90)});
  options_.vehicle = "charlie";
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_EQ(err_.str(), "shoal: " + options_.path +
                            ": holds no decision of 'charlie'; it has those of ALPHA\n");
}

TEST_F(LogHelmCommand, StatesThatALogHasNoDecisions) {
  WriteLog(options_.path, {{.utime = 1, .channel = "NAV_ALPHA", .data = Encoded(nav_t{})}});
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("holds no HELM_DECISION_*"), std::string::npos) << err_.str();
}

TestEvent StateAt(int64_t utime, int waypoint) {
  helm_state_t state{};
  state.utime = utime;
  state.vehicle = "alpha";
  state.state = "DRIVE";
  state.task = "survey";
  state.waypoint_index = waypoint;
  return {.utime = utime, .channel = channels::HelmState("alpha").name, .data = Encoded(state)};
}

TEST_F(LogHelmCommand, ListsWaypointsThatWereReachedWithAndWithoutDecisions) {
  WriteLog(options_.path, {StateAt(1'000'000, 0), StateAt(2'000'000, 0), StateAt(3'500'000, 1)});
  EXPECT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_EQ(out_.str(), "     3.500  alpha        waypoint 1 of survey reached\n");
  options_.vehicle = "bravo";
  EXPECT_EQ(Run(), kExitUsage);
}

TEST_F(LogHelmCommand, CountsWhatDoesNotDecode) {
  WriteLog(options_.path, {DecisionAt(1'000'000, "alpha", 90),
                           {.utime = 2, .channel = "HELM_DECISION_ALPHA", .data = {1, 2, 3}}});
  EXPECT_EQ(Run(), kExitOk);
  EXPECT_NE(err_.str().find("1 messages do not decode"), std::string::npos) << err_.str();
}

}  // namespace shoal::log_helm_test
