#include "lib/behaviors/behavior_set.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "lib/behaviors/test_helm.h"
#include "lib/decision/decide.h"

namespace shoal::behavior_set_test {

/// Reads "speed = 2" and "fails = ..." of a waypoint; others are refused.
Result<BehaviorOptions> ReadSpeed(const BehaviorOptions& options, std::span<const UpdateItem> items,
                                  const Eigen::Vector2d&) {
  BehaviorOptions updated = options;
  for (const UpdateItem& item : items) {
    if (item.key == "speed") {
      std::get<WaypointOptions>(updated.what).speed = NumberIn(item.value).value_or(-1);
    } else if (item.key == "pwt") {
      updated.pwt = NumberIn(item.value).value_or(-1);
    } else if (item.key == "condition") {
      updated.condition = {item.value};
    } else {
      return Error{"unknown key '" + item.key + "'"};
    }
  }
  return updated;
}

BehaviorAnswer Wants90(const BehaviorInputs&) { return Wants(90, 2); }

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

TEST(Updates, CountAsAWholeOrNotAtAll) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  helm.Add("survey").updates = "UPDATE";
  HelmOutcome outcome = helm.TickWith("UPDATE", "speed = 3 # colour = red");
  EXPECT_EQ(outcome.warnings,
            std::vector<std::string>{"survey: update 'speed = 3 # colour = red' changes nothing: "
                                     "unknown key 'colour'"});
  EXPECT_EQ(helm.reconfigured["survey"], 0);
  outcome = helm.TickWith("UPDATE", "speed = 3 # condition = DEPLOY");
  EXPECT_EQ(outcome.warnings.size(), 1U);
  EXPECT_EQ(helm.reconfigured["survey"], 0);
  outcome = helm.TickWith("UPDATE", "speed = 3 # pwt = 50");
  EXPECT_TRUE(HasEvent(outcome, "update", "survey: speed = 3 # pwt = 50"));
  EXPECT_EQ(helm.reconfigured["survey"], 1);
}

TEST(Updates, OfTheSameTextAreOne) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  helm.Add("survey").updates = "UPDATE";
  helm.TickWith("UPDATE", "speed = 3");
  EXPECT_TRUE(helm.TickWith("UPDATE", "speed = 3").events.empty());
  EXPECT_FALSE(helm.TickWith("UPDATE", "speed = 2").events.empty());
  EXPECT_FALSE(helm.TickWith("UPDATE", "speed = 3").events.empty());
  EXPECT_EQ(helm.reconfigured["survey"], 3);
}

TEST(Updates, ChangeTheWeight) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  helm.Add("survey").updates = "UPDATE";
  helm.answers["survey"] = Wants90;
  EXPECT_EQ(helm.Tick().aims.at(0).weight, 100);
  EXPECT_EQ(helm.TickWith("UPDATE", "pwt = 30").aims.at(0).weight, 30);
  EXPECT_EQ(helm.reconfigured["survey"], 0);
}

TEST(Updates, ReachTheBehaviorThatTheyName) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  helm.Add("east").updates = "UPDATE";
  helm.Add("west").updates = "UPDATE";
  helm.TickWith("UPDATE", "name = west # speed = 3");
  EXPECT_EQ(helm.reconfigured["east"], 0);
  EXPECT_EQ(helm.reconfigured["west"], 1);
  helm.TickWith("UPDATE", "speed = 2");
  EXPECT_EQ(helm.reconfigured["east"], 1);
  EXPECT_EQ(helm.reconfigured["west"], 2);
  const HelmOutcome outcome = helm.TickWith("UPDATE", "name = north # speed = 3");
  EXPECT_EQ(outcome.warnings,
            std::vector<std::string>{"update of UPDATE: no behavior is called north"});
}

TEST(Updates, SpawnBehaviorsOfARecipe) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  BehaviorOptions& options = helm.Add("leg_");
  options.updates = "UPDATE";
  options.templating = Templating::kSpawn;
  options.max_spawnings = 2;
  helm.Tick();
  EXPECT_TRUE(helm.set->Names().empty());
  EXPECT_TRUE(HasEvent(helm.TickWith("UPDATE", "name = a # speed = 2"), "spawn", "leg_a"));
  EXPECT_TRUE(helm.Has("leg_a"));
  helm.TickWith("UPDATE", "name = a # speed = 3");
  EXPECT_EQ(helm.reconfigured["leg_a"], 1);
  EXPECT_EQ(helm.TickWith("UPDATE", "name = b # colour = red").warnings,
            std::vector<std::string>{"leg_b does not begin: unknown key 'colour'"});
  helm.TickWith("UPDATE", "name = b # speed = 2");
  EXPECT_EQ(helm.set->Names(), (std::vector<std::string>{"leg_a", "leg_b"}));
  EXPECT_EQ(helm.TickWith("UPDATE", "name = c # speed = 2").warnings.size(), 1U);
  EXPECT_FALSE(helm.Has("leg_c"));
}

TEST(Updates, WaitWhileTheHelmIsParked) {
  TestHelm helm;
  helm.setup.read_update = ReadSpeed;
  BehaviorOptions& options = helm.Add("survey");
  options.updates = "UPDATE";
  options.flags.idleflag = {"IDLE = true"};
  options.condition = {"DEPLOY = true"};
  helm.drives = false;
  const HelmOutcome outcome = helm.TickWith("UPDATE", "speed = 2");
  EXPECT_TRUE(outcome.events.empty());
  EXPECT_TRUE(outcome.posts.empty());
  EXPECT_FALSE(outcome.has_decision);
  helm.drives = true;
  EXPECT_TRUE(HasEvent(helm.Tick(), "update", "survey: speed = 2"));
}

AvoidCollisionOptions Avoid() {
  return {.pwt_outer_dist = 80, .pwt_inner_dist = 20, .completed_dist = 100};
}

TEST(Spawning, MakesOneBehaviorForEachContactInRange) {
  TestHelm helm;
  helm.Add("avd_", Avoid()).templating = Templating::kSpawn;
  helm.contacts["henry"] = ContactAt("henry", 200, 0);
  helm.contacts["gilda"] = ContactAt("gilda", 70, 0);
  helm.TickFor(1);
  EXPECT_EQ(helm.set->Names(), std::vector<std::string>{"avd_gilda"});
  helm.contacts["henry"] = ContactAt("henry", 0, 50);
  helm.TickFor(1);
  EXPECT_EQ(helm.set->Names(), (std::vector<std::string>{"avd_gilda", "avd_henry"}));
}

TEST(Spawning, EndsATenthBeyondTheCompletedDistanceAndBeginsAnew) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("avd_", Avoid());
  options.templating = Templating::kSpawn;
  options.flags.endflag = {"CLEAR_OF = $[CONTACT]"};
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.Tick();
  helm.contacts["henry"] = ContactAt("henry", 109, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("avd_henry"));
  helm.contacts["henry"] = ContactAt("henry", 111, 0);
  EXPECT_TRUE(HasEvent(helm.Tick(), "end", "avd_henry: completed, its contact is far away"));
  EXPECT_FALSE(helm.Has("avd_henry"));
  EXPECT_EQ(helm.ValueOf("CLEAR_OF"), "henry");
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("avd_henry"));
}

TEST(Spawning, EndsWithAContactThatIsNoLongerKnown) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("avd_", Avoid());
  options.templating = Templating::kSpawn;
  options.perpetual = true;
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.Tick();
  helm.contacts.clear();
  EXPECT_TRUE(HasEvent(helm.Tick(), "end", "avd_henry: completed, its contact is no longer known"));
  EXPECT_FALSE(helm.Has("avd_henry"));
  EXPECT_EQ(helm.num_completed["avd_henry"], 1);
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("avd_henry"));
}

TEST(Spawning, HappensOncePerAlertWhereABehaviorEndsByItself) {
  TestHelm helm;
  helm.Add("avd_", Avoid()).templating = Templating::kSpawn;
  int num_runs = 0;
  helm.answers["avd_henry"] = [&](const BehaviorInputs&) {
    ++num_runs;
    BehaviorAnswer answer;
    answer.completes = true;
    return answer;
  };
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.TickFor(2);
  EXPECT_EQ(num_runs, 1);
}

TEST(Spawning, PassesOverContactsThatAreFilteredOut) {
  TestHelm helm;
  AvoidCollisionOptions avoid = Avoid();
  avoid.contact.ignore_group = {"Blue"};
  avoid.contact.exit_on_filter_group = true;
  helm.Add("avd_", avoid).templating = Templating::kSpawn;
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.contacts["gilda"] = ContactAt("gilda", 70, 0);
  helm.contacts["gilda"].group = "BLUE";
  helm.Tick();
  EXPECT_EQ(helm.set->Names(), std::vector<std::string>{"avd_henry"});
  helm.contacts["henry"].group = "blue";
  EXPECT_TRUE(HasEvent(helm.Tick(), "end", "avd_henry: completed, its contact has left the group"));
}

TEST(Spawning, StopsAtItsGreatestNumber) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("avd_", Avoid());
  options.templating = Templating::kSpawn;
  options.max_spawnings = 1;
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.contacts["gilda"] = ContactAt("gilda", 70, 0);
  EXPECT_EQ(
      helm.Tick().warnings,
      std::vector<std::string>{"avd_: max_spawnings = 1 is reached; avd_henry does not begin"});
  EXPECT_EQ(helm.set->Names(), std::vector<std::string>{"avd_gilda"});
}

TEST(Spawning, KeepsTheOrderOfTheFile) {
  TestHelm helm;
  helm.Add("first");
  helm.Add("avd_", Avoid()).templating = Templating::kSpawn;
  BehaviorOptions& clone = helm.Add("copy_", Avoid());
  clone.templating = Templating::kClone;
  helm.Add("last");
  helm.Tick();
  EXPECT_EQ(helm.set->Names(), (std::vector<std::string>{"first", "copy_", "last"}));
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.Tick();
  EXPECT_EQ(helm.set->Names(),
            (std::vector<std::string>{"first", "avd_henry", "copy_", "copy_henry", "last"}));
}

TEST(Spawning, MakesOneBehaviorForEachObstacleInRange) {
  TestHelm helm;
  helm.Add("obs_", AvoidObstacleOptions()).templating = Templating::kSpawn;
  helm.obstacles = {{"rock", {{100, -5}, {110, -5}, {110, 5}, {100, 5}}},
                    {"buoy", {{0, 300}, {1, 300}, {1, 301}}}};
  helm.Tick();
  EXPECT_TRUE(helm.set->Names().empty());
  helm.own.motion.position_m = {60, 0};
  helm.Tick();
  EXPECT_EQ(helm.set->Names(), std::vector<std::string>{"obs_rock"});
  helm.own.motion.position_m = {46, 0};
  helm.Tick();
  EXPECT_TRUE(helm.Has("obs_rock"));
  helm.own.motion.position_m = {44, 0};
  EXPECT_TRUE(HasEvent(helm.Tick(), "end", "obs_rock: completed, the obstacle is passed"));
}

TEST(AbleFilter, DisablesABehaviorThatAllowsItForItsContact) {
  TestHelm helm;
  for (const bool can_disable : {true, false}) {
    ColregsOptions colregs = {.pwt_outer_dist = 80, .completed_dist = 100};
    colregs.can_disable = can_disable;
    helm.Add(can_disable ? "may_" : "must_", colregs).templating = Templating::kSpawn;
  }
  helm.answers["may_henry"] = Wants90;
  helm.answers["must_henry"] = Wants90;
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  EXPECT_EQ(helm.Tick().aims.size(), 2U);
  HelmOutcome outcome = helm.TickWith("BHV_ABLE_FILTER", "contact=henry, action=disable");
  ASSERT_EQ(outcome.aims.size(), 1U);
  EXPECT_EQ(outcome.aims[0].name, "must_henry");
  // It lasts for behaviors that are spawned later.
  helm.contacts.clear();
  helm.Tick();
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  EXPECT_EQ(helm.Tick().aims.size(), 1U);
  EXPECT_EQ(helm.TickWith("BHV_ABLE_FILTER", "contact=henry # action=enable").aims.size(), 2U);
  EXPECT_EQ(helm.TickWith("BHV_ABLE_FILTER", "action=disable").warnings.size(), 1U);
}

TEST(ContactFlags, AreSetAtTheirMoments) {
  TestHelm helm;
  AvoidCollisionOptions avoid = Avoid();
  avoid.contact.cnflag = {"@<50 NEAR = $[CONTACT] at $[RANGE]"};
  helm.Add("avd_", avoid).templating = Templating::kSpawn;
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.TickFor(1);
  EXPECT_EQ(helm.ValueOf("NEAR"), "");
  helm.contacts["henry"] = ContactAt("henry", 49, 0);
  helm.TickFor(1);
  EXPECT_EQ(helm.ValueOf("NEAR"), "henry at 49");
}

TEST(AllStop, ForWantOfADecisionWaitsOneIteration) {
  TestHelm helm;
  helm.Add("survey").condition = {"GO = true"};
  helm.answers["survey"] = Wants90;
  EXPECT_TRUE(helm.TickWith("GO", "true").has_decision);
  HelmOutcome outcome = helm.TickWith("GO", "false");
  EXPECT_EQ(outcome.all_stop, "NothingToDo");
  EXPECT_TRUE(outcome.keeps_last);
  EXPECT_TRUE(HasEvent(outcome, "all_stop", "NothingToDo"));
  outcome = helm.Tick();
  EXPECT_FALSE(outcome.keeps_last);
  EXPECT_FALSE(HasEvent(outcome, "all_stop", "NothingToDo"));
  outcome = helm.TickWith("GO", "true");
  EXPECT_TRUE(HasEvent(outcome, "all_stop", "clear"));
}

TEST(AllStop, IsNotPutOffByAReasonThatChanges) {
  TestHelm helm;
  helm.Add("survey");
  bool has_course = true;
  helm.answers["survey"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer;
    if (!has_course) return answer;
    answer.objective = Objective{.course = PeakOverCourse(45, 10, 170)};
    answer.relevance = 1;
    return answer;
  };
  HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "MissingDecVars:speed");
  EXPECT_TRUE(outcome.keeps_last);
  has_course = false;
  outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "NothingToDo");
  EXPECT_FALSE(outcome.keeps_last);
}

TEST(AllStop, ByAnErrorIsAtOnceAndLastsAsLongAsTheError) {
  TestHelm helm;
  helm.Add("region");
  helm.Add("survey");
  helm.answers["survey"] = Wants90;
  bool is_outside = true;
  helm.answers["region"] = [&](const BehaviorInputs&) {
    BehaviorAnswer answer;
    if (is_outside) answer.error = "outside";
    return answer;
  };
  HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "BehaviorError:region: outside");
  EXPECT_FALSE(outcome.keeps_last);
  EXPECT_FALSE(outcome.has_decision);
  EXPECT_EQ(outcome.commands, HelmPoint());
  is_outside = false;
  outcome = helm.Tick();
  EXPECT_EQ(outcome.all_stop, "clear");
  EXPECT_TRUE(outcome.has_decision);
}

TEST(AllStop, ByABehaviorThatEndsWithItsErrorLastsUntilTheOperatorClearsIt) {
  TestHelm helm;
  helm.Add("crash");
  helm.Add("survey");
  helm.answers["survey"] = Wants90;
  helm.answers["crash"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.error = "crashed";
    answer.completes = true;
    return answer;
  };
  helm.Tick();
  HelmOutcome outcome = helm.TickFor(5);
  EXPECT_EQ(outcome.all_stop, "BehaviorError:crash: crashed");
  EXPECT_FALSE(outcome.has_decision);
  helm.set->Clear();
  EXPECT_TRUE(helm.Tick().has_decision);
}

TEST(AllStop, MeetsPreferencesThatAreNoNumbers) {
  TestHelm helm;
  helm.Add("survey");
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.objective->course.at(17) = std::numeric_limits<double>::quiet_NaN();
    return answer;
  };
  EXPECT_EQ(helm.Tick().all_stop, "BehaviorError:survey: its preferences are not finite numbers");
  helm.answers["survey"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer = Wants(90, 2);
    answer.objective->speed.pop_back();
    return answer;
  };
  EXPECT_FALSE(helm.Tick().has_decision);
}

TEST(AllStop, MeetsConstraintsWithoutAGoalWhereGoalsAreMandatory) {
  for (const bool mandatory : {true, false}) {
    TestHelm helm;
    helm.setup.goals_mandatory = mandatory;
    helm.Add("limit");
    helm.answers["limit"] = Wants90;
    EXPECT_EQ(helm.Tick().all_stop, mandatory ? "NoGoalBehavior" : "clear");
    helm.task = TaskAim{.name = "home", .kind = "return", .course_deg = 10, .speed_mps = 1};
    EXPECT_EQ(helm.Tick().all_stop, "clear");
  }
}

TEST(Decision, DoesNotDependOnTheOrderOfTheFile) {
  std::vector<HelmPoint> points;
  for (const bool reversed : {false, true}) {
    TestHelm helm;
    std::vector<std::string> names = {"a", "b", "c"};
    if (reversed) names = {"c", "b", "a"};
    for (const std::string& name : names) helm.Add(name).pwt = name == "a" ? 100 : 73;
    helm.answers["a"] = [](const BehaviorInputs&) { return Wants(20, 1); };
    helm.answers["b"] = [](const BehaviorInputs&) { return Wants(100, 2.5); };
    helm.answers["c"] = [](const BehaviorInputs&) { return Wants(300, 4); };
    points.push_back(helm.Tick().commands);
  }
  EXPECT_EQ(points[0], points[1]);
}

TEST(Decision, IgnoresABehaviorWithoutWeight) {
  TestHelm helm;
  helm.Add("survey");
  helm.Add("other").pwt = 0;
  helm.answers["survey"] = Wants90;
  helm.answers["other"] = [](const BehaviorInputs&) { return Wants(270, 0.5); };
  const HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 2}));
  EXPECT_EQ(outcome.aims.at(1).weight, 0);
  EXPECT_EQ(outcome.aims.at(1).state, "running");
}

TEST(Decision, StatesWhatEachLost) {
  TestHelm helm;
  helm.Add("east").pwt = 200;
  helm.Add("west");
  helm.answers["east"] = Wants90;
  helm.answers["west"] = [](const BehaviorInputs&) { return Wants(270, 2); };
  const HelmOutcome outcome = helm.Tick();
  EXPECT_EQ(outcome.commands.course_deg, 90);
  EXPECT_EQ(outcome.aims.at(1).best.course_deg, 270);
  EXPECT_NEAR(outcome.aims[1].value, 50, 1e-9);
  EXPECT_NEAR(outcome.aims[1].loss, 5000, 1e-6);
  EXPECT_NEAR(outcome.utility, 200 * 100 + 100 * 50, 1e-6);
}

TEST(Decision, OfTheTaskAloneIsTheTasksOwn) {
  TestHelm helm;
  BehaviorOptions& survey = helm.Add("survey");
  survey.condition = {"GO = true"};
  survey.pwt = 300;
  helm.answers["survey"] = Wants90;
  helm.task = TaskAim{.name = "legs", .kind = "waypoints", .course_deg = 33.4, .speed_mps = 1.23};
  HelmOutcome outcome = helm.Tick();
  EXPECT_TRUE(outcome.only_task);
  EXPECT_TRUE(outcome.is_task_point);
  EXPECT_EQ(outcome.commands.course_deg, 33);
  EXPECT_NEAR(*outcome.commands.speed_mps, 1.2, 1e-9);
  EXPECT_EQ(outcome.aims.at(0).name, "legs");
  outcome = helm.TickWith("GO", "true");
  EXPECT_FALSE(outcome.only_task);
  EXPECT_FALSE(outcome.is_task_point);
}

TEST(Decision, LetsATaskWithoutWeightLeadOnlyWhereNothingElseDoes) {
  TestHelm helm;
  helm.Add("survey").condition = {"GO = true"};
  helm.answers["survey"] = Wants90;
  helm.task =
      TaskAim{.name = "legs", .kind = "waypoints", .pwt = 0, .course_deg = 33, .speed_mps = 1};
  EXPECT_TRUE(helm.Tick().only_task);
  const HelmOutcome outcome = helm.TickWith("GO", "true");
  EXPECT_FALSE(outcome.only_task);
  EXPECT_EQ(outcome.commands, (HelmPoint{.course_deg = 90, .speed_mps = 2}));
}

TEST(Decision, AgreesWithATaskBesideABehaviorThatDoesNotMind) {
  TestHelm helm;
  helm.Add("limit");
  helm.answers["limit"] = [](const BehaviorInputs&) {
    BehaviorAnswer answer;
    answer.objective = Objective{.speed = AtMost(Domain().speed_mps, 2, 0.5)};
    answer.relevance = 1;
    return answer;
  };
  helm.task = TaskAim{.name = "legs", .kind = "waypoints", .course_deg = 359.7, .speed_mps = 1.23};
  const HelmOutcome outcome = helm.Tick();
  EXPECT_FALSE(outcome.only_task);
  EXPECT_TRUE(outcome.is_task_point);
  EXPECT_EQ(outcome.commands.course_deg, 0);
}

TEST(ObjectiveOfATask, IsGreatestAtTheGridPointNearestToItsCommands) {
  const Domain domain = {.depth_m = {.first = 0, .step = 1, .count = 101}};
  for (const double course_deg : {0.0, 0.4, 90.6, 179.5, 359.6}) {
    for (const double speed_mps : {0.0, 0.04, 0.26, 1.5, 3.97, 9.0}) {
      const TaskAim task = {.name = "",
                            .kind = "",
                            .course_deg = course_deg,
                            .speed_mps = speed_mps,
                            .depth_m = 12.3};
      const std::vector<WeightedObjective> alone = {{1, ObjectiveOf(task, domain)}};
      const GridDecision decision = Decide(domain, alone);
      EXPECT_EQ(decision.point.speed, domain.speed_mps.Nearest(speed_mps));
      EXPECT_EQ(decision.point.depth, 12);
      EXPECT_NEAR(decision.utility, 100, 1e-6);
      if (speed_mps == 0) {
        EXPECT_FALSE(decision.point.course.has_value());
      } else {
        const int nearest = static_cast<int>(std::ceil(course_deg - 0.5)) % 360;
        EXPECT_EQ(decision.point.course, nearest) << course_deg << " " << speed_mps;
      }
    }
  }
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

TEST(UpdateText, IsSplitAtNumberSignsOutsideQuotes) {
  const auto items = ParseUpdate(" points = 0,0:1,1 # name=henry # wptflag = \"A = #1\" ");
  ASSERT_TRUE(items.ok());
  EXPECT_EQ(*items, (std::vector<UpdateItem>{
                        {"points", "0,0:1,1"}, {"name", "henry"}, {"wptflag", "\"A = #1\""}}));
  EXPECT_FALSE(ParseUpdate("points").ok());
  EXPECT_FALSE(ParseUpdate("speed = 2 # ").ok());
  EXPECT_FALSE(ParseUpdate("").ok());
  EXPECT_FALSE(ParseUpdate("= 2").ok());
}

}  // namespace shoal::behavior_set_test
