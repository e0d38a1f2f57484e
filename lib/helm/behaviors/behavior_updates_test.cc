#include <gtest/gtest.h>

#include <string>

#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/helm_testing.h"

namespace shoal::behavior_updates_test {

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

}  // namespace shoal::behavior_updates_test
