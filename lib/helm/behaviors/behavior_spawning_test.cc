#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/helm_testing.h"

namespace shoal::behavior_spawning_test {

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

TEST(Spawning, PutsTheContactsNameIntoConditions) {
  TestHelm helm;
  BehaviorOptions& options = helm.Add("avd_", Avoid());
  options.templating = Templating::kSpawn;
  options.condition = {"MARKED_$[CONTACT] = true"};
  options.flags.runflag = {"RUNS = $[CONTACT]"};
  helm.contacts["henry"] = ContactAt("henry", 70, 0);
  helm.TickWith("MARKED_GILDA", "true");
  helm.TickWith("MARKED_henry", "true");
  EXPECT_TRUE(helm.Has("avd_henry"));
  EXPECT_EQ(helm.ValueOf("RUNS"), "");
  helm.TickWith("MARKED_HENRY", "true");
  EXPECT_EQ(helm.ValueOf("RUNS"), "henry");
}

TEST(Conditions, HaveANameForAContactThatIsNoneOfAVariable) {
  BehaviorOptions options{.name = "avd", .what = Avoid()};
  options.condition = {"$[CONTACT] = 1", "A = $[CONTACT]_$[CONTACT]"};
  EXPECT_EQ(ConditionsOf(options),
            (std::vector<std::string>{"CONTACT = 1", "A = CONTACT_CONTACT"}));
  std::get<AvoidCollisionOptions>(options.what).contact.contact = "to be-set";
  EXPECT_EQ(ConditionsOf(options).front(), "TO_BE_SET = 1");
  EXPECT_EQ(Problem(options), "");
  options.what = WaypointOptions();
  EXPECT_NE(Problem(options), "") << "a waypoint has no contact";
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

TEST(Spawning, MakesChasersForContactsThatComeWithinTheirAlertRange) {
  TestHelm helm;
  BehaviorOptions& options =
      helm.Add("cut_", CutRangeOptions{.contact = {.alert_range = 100}, .pwt_outer_dist = 100});
  options.templating = Templating::kSpawn;
  options.duration = 2;
  helm.contacts["henry"] = ContactAt("henry", 150, 0);
  helm.Tick();
  EXPECT_FALSE(helm.Has("cut_henry"));
  helm.contacts["henry"] = ContactAt("henry", 99, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("cut_henry"));
  // No distance ends it.
  helm.contacts["henry"] = ContactAt("henry", 300, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("cut_henry"));
  helm.TickFor(3);
  EXPECT_FALSE(helm.Has("cut_henry"));
  helm.contacts["henry"] = ContactAt("henry", 99, 0);
  helm.Tick();
  EXPECT_TRUE(helm.Has("cut_henry"));
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

}  // namespace shoal::behavior_spawning_test
