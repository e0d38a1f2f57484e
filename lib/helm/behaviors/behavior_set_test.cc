#include "lib/helm/behaviors/behavior_set.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/helm/behaviors/helm_testing.h"

namespace shoal::behavior_set_test {

TEST(RunStates, FollowTheConditions) {
  TestHelm helm;
  helm.Add("survey").condition = {"DEPLOY = true"};
  helm.answers["survey"] = Wants90;
  HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(HasEvent(outcome, "state", "survey: new -> idle"));
  EXPECT_FALSE(outcome.has_decision);
  EXPECT_TRUE(outcome.aims.empty());
  outcome = helm.TickWith("DEPLOY", "true");
  EXPECT_TRUE(HasEvent(outcome, "state", "survey: idle -> active"));
  ASSERT_TRUE(outcome.has_decision);
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 2}));
  ASSERT_EQ(outcome.aims.size(), 1U);
  EXPECT_EQ(outcome.aims[0].weight, 100);
  EXPECT_EQ(outcome.aims[0].value, 100);
  EXPECT_EQ(outcome.aims[0].loss, 0);
  outcome = helm.TickWith("DEPLOY", "false");
  EXPECT_TRUE(HasEvent(outcome, "state", "survey: active -> idle"));
}

TEST(RunStates, FollowConditionsAboutTheVesselItself) {
  TestHelm helm;
  helm.Add("deep").condition = {"NAV_DEPTH > 5"};
  helm.Add("fast").condition = {"(NAV_SPEED > 1) and (NAV_X < 20)"};
  EXPECT_TRUE(HasEvent(helm.Tick(), "state", "deep: new -> idle"));
  helm.own.depth_m = 6;
  helm.own.motion.speed_mps = 2;
  helm.own.motion.position_m.x() = 19;
  const HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(HasEvent(outcome, "state", "deep: idle -> running"));
  EXPECT_TRUE(HasEvent(outcome, "state", "fast: idle -> running"));
  EXPECT_EQ(helm.ValueOf("NAV_Y"), "") << "no condition names it";
  helm.own.motion.position_m.x() = 20;
  EXPECT_TRUE(HasEvent(helm.Tick(), "state", "fast: running -> idle"));
}

TEST(RunStates, KnowRunningWithoutPreferenceFromActive) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("avoid");
  options.flags.activeflag = {"N_ACTIVE = $[CTR]"};
  options.flags.inactiveflag = {"N_INACTIVE = $[CTR1]"};
  options.flags.runflag = {"N_RUN = $[CTR2]"};
  options.flags.runxflag = {"N_RUNX = $[CTR3]"};
  double relevance = 0;
  helm.answers["avoid"] = [&](const BehaviorInputs&) { return Wants(90, 2, relevance); };
  HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.aims.at(0).state, "running");
  EXPECT_EQ(outcome.aims.at(0).weight, 0);
  relevance = 0.5;
  outcome = helm.Tick();
  EXPECT_EQ(outcome.aims.at(0).state, "active");
  EXPECT_EQ(outcome.aims.at(0).weight, 50);
  helm.Tick();
  relevance = 0;
  helm.Tick();
  relevance = 1;
  helm.Tick();
  EXPECT_EQ(helm.ValueOf("N_ACTIVE"), "2");
  EXPECT_EQ(helm.ValueOf("N_INACTIVE"), "1");
  EXPECT_EQ(helm.ValueOf("N_RUN"), "1");
  EXPECT_EQ(helm.ValueOf("N_RUNX"), "5");
}

TEST(RunStates, FireIdleFlagsOnEntryOnly) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("survey");
  options.condition = {"DEPLOY = true"};
  options.flags.idleflag = {"N_IDLE = $[CTR]"};
  helm.TickFor(2);
  EXPECT_EQ(helm.ValueOf("N_IDLE"), "1");
  helm.TickWith("DEPLOY", "true");
  helm.TickWith("DEPLOY", "false");
  helm.TickFor(2);
  EXPECT_EQ(helm.ValueOf("N_IDLE"), "2");
}

TEST(Flags, AreSeenByConditionsOneIterationLater) {
  TestHelm helm;
  helm.Add("survey").flags.endflag = {"RETURN = true"};
  helm.Add("home").condition = {"RETURN = true"};
  bool completes = false;
  helm.answers["survey"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.completes = completes;
    return answer;
  };
  helm.answers["home"] = [](const BehaviorInputs&) { return Wants(180, 1); };
  helm.Tick();
  completes = true;
  HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(HasEvent(outcome, "end", "survey: completed"));
  EXPECT_TRUE(HasEvent(outcome, "flag", "survey: RETURN = true"));
  EXPECT_FALSE(outcome.has_decision);
  EXPECT_EQ(outcome.all_stop, "NothingToDo");
  EXPECT_TRUE(outcome.keeps_last);
  EXPECT_FALSE(helm.Has("survey"));
  outcome = helm.Tick();
  EXPECT_EQ(outcome.commands.course_deg, 180);
  EXPECT_EQ(outcome.all_stop, "clear");
}

TEST(Flags, KeepAPerpetualBehaviorAlive) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("survey");
  options.perpetual = true;
  options.condition = {"GO = true"};
  options.flags.endflag = {"GO = false", "N = $[CTR]"};
  helm.setup.variables = {{"GO", std::string("true")}};
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.completes = true;
    return answer;
  };
  helm.TickFor(2);
  EXPECT_TRUE(helm.Has("survey"));
  EXPECT_EQ(helm.ValueOf("N"), "1");
  helm.TickWith("GO", "true");
  EXPECT_EQ(helm.ValueOf("N"), "2");
}

TEST(Flags, GoToOthersWithTheirDestination) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("survey");
  options.flags.runflag = {"LOITER = true [to] all+", "SECRET = 3 [to] group:BLUE"};
  const HelmOutcome outcome = helm.Tick();
  const std::vector<VariablePost> expected = {{"LOITER", std::string("true")},
                                              {"LOITER", std::string("true"), "all"},
                                              {"SECRET", 3.0, "group:BLUE"}};
  EXPECT_EQ(outcome.posts, expected);
  EXPECT_EQ(helm.ValueOf("LOITER"), "true");
  EXPECT_EQ(helm.ValueOf("SECRET"), "");
}

TEST(Flags, OfItsOwnKindAreFiredByName) {
  TestHelm helm;
  WaypointOptions waypoint;
  waypoint.wptflag = {"POINT = $[OSX],$[OSY] of $[BHVNAME]"};
  helm.Add("survey", waypoint);
  helm.own.motion.position_m = {1.25, -3};
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.flags = {"wptflag"};
    return answer;
  };
  helm.Tick();
  EXPECT_EQ(helm.ValueOf("POINT"), "1.25,-3 of survey");
}

TEST(Flags, ThatDoNotFitAVariableAreWarnedOf) {
  TestHelm helm;
  helm.setup.variables = {{"DEPTH", 3.0}};
  helm.Add("survey").flags.runflag = {"DEPTH = deep"};
  const HelmOutcome outcome = helm.Tick();
  ASSERT_EQ(outcome.warnings.size(), 1U);
  EXPECT_EQ(outcome.warnings[0], "the flag DEPTH = deep was refused: the variable is a number");
  EXPECT_EQ(helm.ValueOf("DEPTH"), "3");
}

TEST(Flags, OfSpawningAndConfigurationFireOnce) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  BehaviorOptions& options = helm.Add("survey");
  options.updates = "UPDATE";
  options.flags.spawnflag = {"N_SPAWN = $[CTR]"};
  options.flags.spawnxflag = {"N_SPAWNX = $[CTR1]"};
  options.flags.configflag = {"N_CONFIG = $[CTR2]"};
  helm.TickFor(2);
  EXPECT_EQ(helm.ValueOf("N_SPAWN"), "1");
  EXPECT_EQ(helm.ValueOf("N_SPAWNX"), "1");
  EXPECT_EQ(helm.ValueOf("N_CONFIG"), "1");
  helm.TickWith("UPDATE", "speed = 2");
  EXPECT_EQ(helm.ValueOf("N_CONFIG"), "2");
}

TEST(Reports, ArePostedWhenTheyChange) {
  TestHelm helm;
  helm.Add("survey");
  double index = 0;
  helm.answers["survey"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.posts = {{"WPT_INDEX", index}};
    return answer;
  };
  EXPECT_EQ(helm.Tick().posts.size(), 1U);
  EXPECT_EQ(helm.Tick().posts.size(), 0U);
  index = 1;
  EXPECT_EQ(helm.Tick().posts.size(), 1U);
  EXPECT_EQ(helm.ValueOf("WPT_INDEX"), "1");
}

TEST(Duration, CompletesABehaviorThatRuns) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("timer", TimerOptions());
  options.duration = 5;
  options.duration_status = "LEFT";
  options.flags.endflag = {"DONE = true"};
  helm.Tick();
  EXPECT_EQ(helm.ValueOf("LEFT"), "5");
  helm.TickFor(4.75);
  EXPECT_EQ(helm.ValueOf("LEFT"), "0.3");
  EXPECT_TRUE(helm.Has("timer"));
  const HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(HasEvent(outcome, "end", "timer: completed, its duration is over"));
  EXPECT_EQ(helm.ValueOf("DONE"), "true");
  EXPECT_FALSE(helm.Has("timer"));
  EXPECT_EQ(helm.num_completed["timer"], 1);
}

/// Runs 2 s, is idle 4 s, runs; returns how long after that it completes.
double SecondsUntilEnd(bool idle_decay) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("timer", TimerOptions());
  options.duration = 8;
  options.duration_idle_decay = idle_decay;
  options.condition = {"GO = true"};
  helm.TickWith("GO", "true");
  helm.TickFor(1.75);
  helm.TickWith("GO", "false");
  helm.TickFor(3.75);
  helm.TickWith("GO", "true");
  double seconds = 0;
  while (helm.Has("timer") && seconds < 100) {
    helm.Tick();
    seconds += 0.25;
  }
  return seconds;
}

TEST(Duration, CountsIdleTimeOnlyWhereItIsToDecay) {
  EXPECT_NEAR(SecondsUntilEnd(true), 2, 0.25);
  EXPECT_NEAR(SecondsUntilEnd(false), 6, 0.25);
}

TEST(Duration, BeginsAnewByItsResetVariable) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("timer", TimerOptions());
  options.duration = 5;
  options.duration_reset = "AGAIN = yes";
  helm.TickFor(4.5);
  helm.TickWith("AGAIN", "no");
  helm.TickWith("AGAIN", "yes");
  helm.TickFor(4.5);
  EXPECT_TRUE(helm.Has("timer"));
  helm.TickFor(1);
  EXPECT_FALSE(helm.Has("timer"));
}

TEST(Nostarve, MakesABehaviorIdleWhileAVariableIsOldOrUnknown) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("survey");
  options.nostarve = {"FIX"};
  options.nostarve_s = 2;
  helm.answers["survey"] = Wants90;
  EXPECT_FALSE(helm.Tick().has_decision);
  EXPECT_TRUE(helm.TickWith("FIX", "1").has_decision);
  EXPECT_TRUE(helm.TickFor(2).has_decision);
  EXPECT_FALSE(helm.Tick().has_decision);
  EXPECT_TRUE(helm.TickWith("FIX", "1").has_decision);
}

TEST(Modes, DecideWhichBehaviorRuns) {
  TestHelm helm;
  helm.setup.variables = {{"DEPLOY", std::string("false")}, {"RETURN", std::string("false")}};
  helm.setup.modes = {{"MODE = ACTIVE", {"DEPLOY = true"}, "INACTIVE"},
                      {"MODE = RETURNING", {"MODE = ACTIVE", "RETURN = true"}, "SURVEYING"}};
  helm.Add("survey").condition = {"MODE == SURVEYING"};
  helm.Add("home").condition = {"MODE == RETURNING"};
  helm.answers["survey"] = Wants90;
  helm.answers["home"] = [](const BehaviorInputs&) { return Wants(180, 1); };
  EXPECT_EQ(helm.Tick().mode, "INACTIVE");
  HelmOutcome outcome = helm.TickWith("DEPLOY", "true");
  EXPECT_EQ(outcome.mode, "ACTIVE:SURVEYING");
  EXPECT_TRUE(HasEvent(outcome, "mode", "MODE = ACTIVE:SURVEYING"));
  EXPECT_EQ(outcome.commands.course_deg, 90);
  outcome = helm.TickWith("RETURN", "true");
  EXPECT_EQ(outcome.mode, "ACTIVE:RETURNING");
  EXPECT_EQ(outcome.commands.course_deg, 180);
}

TEST(Navigation, IsWaitedForAndMissed) {
  TestHelm helm;
  helm.Add("survey").flags.runflag = {"RAN = true"};
  helm.answers["survey"] = Wants90;
  helm.has_nav = false;
  const HelmOutcome outcome = helm.TickFor(1);
  EXPECT_FALSE(outcome.has_decision);
  EXPECT_TRUE(outcome.keeps_last);
  EXPECT_EQ(helm.ValueOf("RAN"), "");
  helm.has_nav = true;
  EXPECT_TRUE(helm.Tick().has_decision);
}

TEST(Settings, OfTheWrongKindAreWarnedOf) {
  TestHelm helm;
  helm.setup.variables = {{"DEPLOY", std::string("true")}};
  helm.Add("survey");
  const HelmOutcome outcome = helm.Tick({{"DEPLOY", 1.0, "henry"}});
  EXPECT_EQ(outcome.warnings,
            std::vector<std::string>{
                "the setting DEPLOY = 1 of henry was refused: the variable is text"});
}

}  // namespace shoal::behavior_set_test
