#include "lib/vehicle/guidance/target_tracker.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::target_tracker_test {

using Eigen::Vector3d;

TEST(TargetTracker, TurnsAVelocityIntoCoursePitchAndSpeed) {
  const TrackCommand command = CommandOf({0, 1, -1}, 0, kPi / 2);
  EXPECT_NEAR(command.psi_d_rad, kPi / 2, 1e-15);
  EXPECT_NEAR(command.theta_d_rad, kPi / 4, 1e-15);
  EXPECT_NEAR(command.speed_mps, std::sqrt(2), 1e-15);
  EXPECT_EQ(command.Rpm([](double speed_mps) { return 100 * speed_mps; }), 100 * command.speed_mps);
}

TEST(TargetTracker, BoundsThePitch) { EXPECT_EQ(CommandOf({0.1, 0, 2}, 0, 0.5).theta_d_rad, -0.5); }

TEST(TargetTracker, HoldsItsCourseWhenNothingIsWanted) {
  TargetTracker tracker({.law = VelocityCascade{{FeedForwardLayer{}}}}, 0.4);
  EXPECT_EQ(tracker.Update({}).psi_d_rad, 0.4);
  TargetScene scene;
  scene.own.position_m.z() = 50;
  scene.target.velocity_mps = {-1, 1, 0};
  EXPECT_NEAR(tracker.Update(scene.Seen()).psi_d_rad, 0.75 * kPi, 1e-15);
  scene.target.velocity_mps = {0, 0, 0};
  const TrackCommand still = tracker.Update(scene.Seen());
  EXPECT_NEAR(still.psi_d_rad, 0.75 * kPi, 1e-15);
  EXPECT_EQ(still.speed_mps, 0);
  EXPECT_EQ(still.theta_d_rad, 0);
}

TEST(TargetTracker, HoldsItsCourseOnTheWayStraightDown) {
  const TrackCommand command = CommandOf({0, 0, 1}, -2, kPi / 4);
  EXPECT_EQ(command.psi_d_rad, -2);
  EXPECT_EQ(command.theta_d_rad, -kPi / 4);
}

TEST(TargetTracker, KeepsOffTheFloorByEitherLaw) {
  TargetScene scene;
  scene.own.position_m = {0, 0, 98};
  scene.target = {.id = 0, .position_m = {100, 0, 150}, .velocity_mps = {1, 0, 0.5}};
  scene.seabed_z_m = 100;
  const std::vector<VelocityLaw> laws = {VelocityCascade{}, ConstantBearingLaw{}};
  for (const VelocityLaw& law : laws) {
    TargetScene deep_water = scene;
    deep_water.seabed_z_m = 6000;
    const TargetTrackParams params{.law = law, .depth = {.z_max_m = 200}};
    const double wanted_mps = TargetTracker(params, 0).Update(deep_water.Seen()).velocity_mps.z();
    EXPECT_GT(wanted_mps, 0.4);
    // Three of the five metres of z_safe are used up.
    EXPECT_NEAR(TargetTracker(params, 0).Update(scene.Seen()).velocity_mps.z(), 0.4 * wanted_mps,
                1e-12);
  }
}

TEST(TargetTracker, SharesNothingWithItsCopy) {
  TargetTracker one({.law = VelocityCascade{{FeedForwardLayer{}}}}, 0);
  TargetTracker other = one;
  TargetScene scene;
  scene.target.velocity_mps = {0, 1, 0};
  (void)one.Update(scene.Seen());
  EXPECT_EQ(other.Update({}).psi_d_rad, 0);
}

// Followers that follow their guidance exactly, behind a leader on a straight course. Attraction
// dies out with the third power of the distance to r_outer = 120 m, which is neared and not
// reached.
TEST(TargetTracker, FormsUpBehindALeaderAndKeepsEveryDistance) {
  constexpr int kFollowers = 6;
  constexpr double kStep_s = 0.5;
  Neighbour leader{.id = 0, .position_m = {0, 0, 50}, .velocity_mps = {1.5, 0, 0}};
  std::vector<Neighbour> followers;
  for (int i = 0; i < kFollowers; ++i) {
    followers.push_back(
        {.id = 1 + i, .position_m = {-120.0 - 48 * (i / 3), 48.0 * (i % 3 - 1), 50}});
  }
  std::vector<TargetTracker> trackers(kFollowers, TargetTracker({.law = VelocityCascade{}}, 0));
  double nearest_m = 1e9;
  std::vector<double> farthest_m;  // From the leader, step by step.
  for (double time_s = 0; time_s < 1800; time_s += kStep_s) {
    std::vector<Neighbour> next = followers;
    for (size_t i = 0; i < followers.size(); ++i) {
      std::vector<Neighbour> group = followers;
      group.erase(group.begin() + static_cast<std::ptrdiff_t>(i));
      const Surroundings around{.own = followers[i], .target = leader, .group = group};
      next[i].velocity_mps = trackers[i].Update(around).velocity_mps;
      next[i].position_m += next[i].velocity_mps * kStep_s;
    }
    followers = next;
    leader.position_m += leader.velocity_mps * kStep_s;
    for (size_t i = 0; i < followers.size(); ++i) {
      const double range_m = (followers[i].position_m - leader.position_m).norm();
      if (i == 0) farthest_m.push_back(0);
      farthest_m.back() = std::max(farthest_m.back(), range_m);
      for (size_t j = 0; j < i; ++j) {
        nearest_m = std::min(nearest_m, (followers[i].position_m - followers[j].position_m).norm());
      }
    }
  }
  EXPECT_GT(nearest_m, 30);
  EXPECT_TRUE(std::is_sorted(farthest_m.rbegin(), farthest_m.rend()));
  EXPECT_NEAR(farthest_m.front(), 175, 1);
  EXPECT_LT(farthest_m.back(), 145);
}

RC_GTEST_PROP(TargetTracker, CommandsWhatAnAutopilotCanTakeForAnyFiniteScene, ()) {
  const VelocityLaw law = *rc::gen::inRange(0, 2) == 0 ? VelocityLaw(VelocityCascade{})
                                                       : VelocityLaw(ConstantBearingLaw{});
  const TargetTrackParams params{.law = law};
  TargetTracker tracker(params, AnyFinite());
  for (int i = 0; i < 4; ++i) {
    const TrackCommand command = tracker.Update(AnyFiniteTargetScene().Seen());
    RC_ASSERT(std::abs(command.psi_d_rad) <= kPi);
    RC_ASSERT(std::abs(command.theta_d_rad) <= params.max_pitch_rad);
    RC_ASSERT(std::isfinite(command.speed_mps) && command.speed_mps >= 0);
    RC_ASSERT(command.velocity_mps.allFinite());
    RC_ASSERT(command.velocity_mps.head<2>().norm() <= params.u_max_mps * (1 + 1e-12));
  }
}

}  // namespace shoal::target_tracker_test
