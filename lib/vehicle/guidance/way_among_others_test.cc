#include "lib/vehicle/guidance/way_among_others.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::way_among_others_test {

using Eigen::Vector3d;

/// To the East along y = 0 at 20 m, for ever.
PathFollowTask East(const std::vector<VelocityLayer>& layers) {
  PathFollowTask task;
  task.points_m = {{0, 0, 20}, {1000, 0, 20}};
  task.end = PathTaskEnd::kGoOn;
  task.approach = false;  // At once on the leg, wherever it is.
  task.cascade.layers = layers;
  return task;
}

Fix At(const Vector3d& position_m, const Surroundings* around) {
  return {.position_m = position_m.head<2>(),
          .heading_rad = kPi / 2,
          .z_m = position_m.z(),
          .surroundings = around};
}

Guidance FirstOf(const PathFollowTask& task, const Vector3d& position_m,
                 const Surroundings* around) {
  PathFollowRunner runner(task, At(position_m, around));
  return runner.Update(At(position_m, around));
}

Surroundings Alone() { return {.own = {.id = 1, .velocity_mps = {2, 0, 0}}}; }

TEST(PathFollowAmongOthers, FollowsItsPathExactlyWhereNothingIsNear) {
  const Surroundings alone = Alone();
  const Vector3d off_m(100, 3, 15);
  const Guidance with = FirstOf(East({SurvivalGroupLayer{}, SurvivalSonarLayer{}}), off_m, &alone);
  const Guidance without = FirstOf(East({}), off_m, nullptr);
  EXPECT_EQ(with.heading_rad, without.heading_rad);
  EXPECT_EQ(with.speed_mps, without.speed_mps);
  EXPECT_EQ(with.z_m, without.z_m);
  EXPECT_FALSE(with.pitch_rad.has_value()) << "the depth is kept by depth";
  ASSERT_EQ(with.layers.size(), 3u);
  EXPECT_EQ(with.layers.back().name, "waypoint");
  EXPECT_EQ(with.layers.back().weight, 1);
  EXPECT_TRUE(without.layers.empty());
}

TEST(PathFollowAmongOthers, KnowsNothingOfOthersWithoutSurroundings) {
  const Guidance guidance = FirstOf(East({SurvivalGroupLayer{}}), {100, 0, 20}, nullptr);
  EXPECT_NEAR(guidance.heading_rad, kPi / 2, 1e-12);
  EXPECT_TRUE(guidance.layers.empty());
}

TEST(PathFollowAmongOthers, SwimsAwayFromAVehicleThatIsTooNear) {
  Surroundings around = Alone();
  around.own.position_m = {100, 0, 20};
  const std::vector<Neighbour> group = {{.id = 2, .position_m = {100, 8, 20}}};
  around.group = group;
  const Guidance guidance = FirstOf(East({SurvivalGroupLayer{}}), {100, 0, 20}, &around);
  EXPECT_NEAR(guidance.heading_rad, kPi, 1e-9) << "South, for the other lies in the North";
  EXPECT_NEAR(guidance.speed_mps, 2.5, 1e-12);
  EXPECT_EQ(guidance.layers.back().weight, 0) << "nothing is left for the way";
}

// The way is 2 m/s relative to the water; what stands is kept clear of over ground.
TEST(PathFollowAmongOthers, TakesTheCurrentOffTheSumOfVelocitiesOverGround) {
  Surroundings around = Alone();
  around.current_mps = {0, 0.4, 0};
  const std::vector<SonarEcho> echoes = {{.direction = {1, 0, 0}, .range_m = 20}};
  around.sonar = echoes;
  const SurvivalSonarLayer sonar = {.r_avoid_m = 40, .r_pass_m = 10};
  const Guidance guidance = FirstOf(East({sonar}), {100, 0, 20}, &around);
  const Vector3d away_mps(-2.5 / 8, -2.5 * 0.75, 0);
  const double left = 1 - away_mps.norm() / 2.5;
  const Vector3d over_ground_mps = away_mps + left * Vector3d(2, 0.4, 0);
  const Vector3d in_water_mps = over_ground_mps - around.current_mps;
  EXPECT_NEAR(guidance.speed_mps, in_water_mps.norm(), 1e-9);
  EXPECT_NEAR(guidance.heading_rad, HeadingOf(in_water_mps.head<2>()), 1e-9);
  ASSERT_EQ(guidance.layers.size(), 2u);
  EXPECT_NEAR(guidance.layers[1].weight, left, 1e-12);
}

TEST(PathFollowAmongOthers, GoesOnTowardItsDepthWhileItKeepsClear) {
  Surroundings around = Alone();
  around.own.position_m = {100, 0, 15};
  const std::vector<Neighbour> group = {{.id = 2, .position_m = {100, 20, 15}}};
  around.group = group;
  const Guidance guidance = FirstOf(East({SurvivalGroupLayer{}}), {100, 0, 15}, &around);
  ASSERT_TRUE(guidance.pitch_rad.has_value());
  EXPECT_LT(*guidance.pitch_rad, DegToRad(-5)) << "5 m too high: bow down";
  EXPECT_GT(*guidance.pitch_rad, DegToRad(-21));
}

TEST(PathFollowAmongOthers, LearnsNoCrabAngleFromADetour) {
  Surroundings around = Alone();
  const std::vector<SonarEcho> echoes = {{.direction = {1, 0, 0}, .range_m = 20}};
  PathFollowRunner runner(East({SurvivalSonarLayer{.r_pass_m = 10}}), At({100, 5, 20}, &around));
  const auto crab_after = [&](double time_s) {
    Fix fix = At({100, 5, 20}, &around);
    fix.time_s = time_s;
    return runner.Update(fix).crab_rad;
  };
  const double first_rad = crab_after(1);
  const double learnt_rad = crab_after(2);
  EXPECT_NE(learnt_rad, first_rad);
  around.sonar = echoes;
  const double begun_rad = crab_after(3);
  EXPECT_EQ(crab_after(4), begun_rad);
  EXPECT_EQ(crab_after(9), begun_rad);
}

TEST(PathFollowAmongOthers, GivesUpTheRevolutionsOfTheTaskWhileItKeepsClear) {
  Surroundings around = Alone();
  PathFollowTask task = East({SurvivalGroupLayer{}});
  task.propeller_rpm = 1000;
  EXPECT_EQ(FirstOf(task, {100, 0, 20}, &around).propeller_rpm, 1000);
  around.own.position_m = {100, 0, 20};
  const std::vector<Neighbour> group = {{.id = 2, .position_m = {100, 8, 20}}};
  around.group = group;
  EXPECT_FALSE(FirstOf(task, {100, 0, 20}, &around).propeller_rpm.has_value());
}

}  // namespace shoal::way_among_others_test
