#include "lib/helm/behaviors/station_keep.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/vessel_testing.h"

namespace shoal::station_keep_test {

const StationKeepOptions kAtOrigin = {.station_pt = Eigen::Vector2d(0, 0),
                                      .inner_radius = 10,
                                      .outer_radius = 30,
                                      .outer_speed = 1,
                                      .transit_speed = 2};

TEST(StationKeep, IsFasterTheFartherItIsOff) {
  TestVessel vessel;
  StationKeepBehavior station(kAtOrigin);
  const auto best_at = [&](double north_m) {
    return vessel.Best(vessel.RunAt(station, {0, north_m}));
  };
  EXPECT_DOUBLE_EQ(best_at(9).speed_mps, 0);
  EXPECT_DOUBLE_EQ(best_at(20).speed_mps, 0.5);
  EXPECT_DOUBLE_EQ(best_at(30).speed_mps, 1);
  EXPECT_DOUBLE_EQ(best_at(31).speed_mps, 2);
  EXPECT_DOUBLE_EQ(best_at(31).course_deg, 180);
}

TEST(StationKeep, KeepsWhereItBeginsWithCenterActivate) {
  TestVessel vessel;
  StationKeepOptions options = kAtOrigin;
  options.center_activate = true;
  StationKeepBehavior station(options);
  (void)vessel.RunAt(station, {100, 0});
  EXPECT_DOUBLE_EQ(vessel.Best(vessel.RunAt(station, {140, 0})).course_deg, 270);
  (void)station.Idle(vessel.Inputs());
  EXPECT_EQ(vessel.RunAt(station, {0, 7}).view.steers_for_m, Eigen::Vector2d(0, 7));
}

TEST(StationKeep, FollowsTheVesselDuringTheSwingTime) {
  TestVessel vessel;
  StationKeepBehavior station({.center_activate = true, .swing_time = 10});
  (void)vessel.RunAt(station, {0, 0});
  vessel.time_s = 9;
  EXPECT_EQ(vessel.RunAt(station, {20, 0}).view.steers_for_m, Eigen::Vector2d(20, 0));
  vessel.time_s = 10;
  EXPECT_EQ(vessel.RunAt(station, {30, 0}).view.steers_for_m, Eigen::Vector2d(20, 0));
}

TEST(StationKeep, HibernatesFromItsStationUntilItIsOutsideTheRadius) {
  TestVessel vessel;
  StationKeepOptions options = kAtOrigin;
  options.hibernation_radius = 50;
  StationKeepBehavior station(options);
  const auto is_awake_at = [&](double north_m) {
    vessel.time_s += 1;
    return vessel.RunAt(station, {0, north_m}).objective.has_value();
  };
  EXPECT_TRUE(is_awake_at(40));
  EXPECT_TRUE(is_awake_at(20));
  EXPECT_FALSE(is_awake_at(9));
  EXPECT_FALSE(is_awake_at(49));
  EXPECT_TRUE(is_awake_at(51));
  EXPECT_TRUE(is_awake_at(49));
}

TEST(StationKeep, HibernatesWhereItComesNoNearerForTenSeconds) {
  TestVessel vessel;
  StationKeepOptions options = kAtOrigin;
  options.hibernation_radius = 50;
  StationKeepBehavior station(options);
  vessel.own.motion.position_m = {0, 25};
  for (double time_s = 0; time_s < 10; ++time_s) {
    EXPECT_TRUE(vessel.RunAt(station, time_s).objective.has_value());
  }
  const BehaviorAnswer answer = vessel.RunAt(station, 10.0);
  EXPECT_FALSE(answer.objective.has_value());
  EXPECT_EQ(PostOf(answer, "PSKEEP_MODE"), VariableValue("HIBERNATING"));
}

}  // namespace shoal::station_keep_test
