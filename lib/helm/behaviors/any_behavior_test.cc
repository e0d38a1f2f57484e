#include "lib/helm/behaviors/any_behavior.h"

#include <gtest/gtest.h>

#include <set>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::any_behavior_test {

TEST(AnyBehavior, HasAWordOfItsOwnForEachKind) {
  std::set<std::string_view> kinds;
  for (const AnyBehavior& what : OneBehaviorOfEachKind()) kinds.insert(KindOf(what));
  EXPECT_EQ(kinds.size(), std::variant_size_v<AnyBehavior>);
  EXPECT_TRUE(kinds.contains("waypoint"));
  EXPECT_FALSE(kinds.contains(""));
}

TEST(AnyBehavior, ListsTheKindsInTheirOrder) {
  const std::vector<AnyBehavior> all = OneBehaviorOfEachKind();
  ASSERT_EQ(all.size(), std::variant_size_v<AnyBehavior>);
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].index(), i);
}

TEST(AnyBehavior, RunsWithTheDefaultsOfEachKind) {
  TestVessel vessel;
  const Contacts contacts;
  const std::vector<Obstacle> obstacles;
  for (const AnyBehavior& what : OneBehaviorOfEachKind()) {
    const std::unique_ptr<Behavior> behavior = MakeBehavior({.name = "it", .what = what});
    BehaviorInputs inputs = vessel.Inputs();
    inputs.contacts = &contacts;
    inputs.obstacles = &obstacles;
    const BehaviorAnswer answer = behavior->Run(inputs);
    EXPECT_EQ(answer.objective.has_value(), answer.relevance > 0) << KindOf(what);
    EXPECT_LE(answer.relevance, 1) << KindOf(what);
    Reconfigure(*behavior, what);
    (void)behavior->Idle(inputs);
  }
}

TEST(AnyBehavior, GivesNewOptionsToARunningBehavior) {
  TestVessel vessel;
  const std::unique_ptr<Behavior> behavior =
      MakeBehavior({.name = "it", .what = ConstantSpeedOptions{.speed = 1}});
  Reconfigure(*behavior, ConstantSpeedOptions{.speed = 2});
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.Run(*behavior)).speed_mps, 2);
}

TEST(AnyBehaviorDeathTest, RefusesOptionsOfAnotherKind) {
  const std::unique_ptr<Behavior> behavior =
      MakeBehavior({.name = "it", .what = ConstantSpeedOptions()});
  EXPECT_DEATH(Reconfigure(*behavior, ConstantDepthOptions()), "own kind");
}

TEST(AnyBehavior, HasAContactWhereItIsAboutOne) {
  AnyBehavior trail = TrailOptions();
  ASSERT_NE(ContactOf(trail), nullptr);
  *ContactOf(trail) = "bravo";
  EXPECT_EQ(std::get<TrailOptions>(trail).contact.contact, "bravo");
  AnyBehavior waypoint = WaypointOptions();
  EXPECT_EQ(ContactOf(waypoint), nullptr);
}

}  // namespace shoal::any_behavior_test
