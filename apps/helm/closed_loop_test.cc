// The helm steers a vessel of lib/vehicle/vehicle: what a user sees of autopilots and guidance
// together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/helm/vessel_testing.h"
#include "lib/base/geometry/leg.h"
#include "lib/base/time/seconds.h"

namespace shoal::closed_loop_test {

const std::vector<Eigen::Vector2d> kSurvey = {{0, 150}, {60, 150}, {60, 0}, {120, 0}, {120, 150}};

Vehicle Surveyor(double speed_mps) {
  Vehicle vehicle = TestVehicle();
  vehicle.helm_options.deploy_at_start = true;
  vehicle.return_task.speed_mps = speed_mps;
  vehicle.tasks = {
      {.name = "survey", .what = WaypointsTask{.points_m = kSurvey, .speed_mps = speed_mps}},
      {.name = "home", .what = vehicle.return_task}};
  return vehicle;
}

/// What a survey looked like from outside.
struct Track {
  double overshoot_m = 0;     ///< Worst cross-track error after a leg was once within 1 m.
  double end_of_leg_m = 0;    ///< Worst cross-track error near the ends of the long legs.
  double heading_sd_deg = 0;  ///< Worst standard deviation of the heading there.
  double fastest_mps = 0;
  double home_time_s = 0;      ///< 0: never came home.
  double home_distance_m = 0;  ///< At the end.
};

/// Welford's running standard deviation.
struct MeanAndDeviation {
  double count = 0;
  double mean = 0;
  double sum_of_squares = 0;

  void Add(double value) {
    ++count;
    const double from_old_mean = value - mean;
    mean += from_old_mean / count;
    sum_of_squares += from_old_mean * (value - mean);
  }
  double Deviation() const { return std::sqrt(sum_of_squares / count); }
};

Track Sail(double speed_mps, int64_t tick_us, const Eigen::Vector2d& current_mps) {
  const Vehicle vehicle = Surveyor(speed_mps);
  HelmAndVessel loop(vehicle, tick_us);
  loop.current_mps = current_mps;
  Track track;
  MeanAndDeviation heading_deg;
  int leg_index = -1;
  bool was_on_leg = false;
  while (loop.utime < 700'000'000) {
    loop.Step();
    if (loop.state.task == "home" && loop.state.laps_done == 1 && track.home_time_s == 0) {
      track.home_time_s = Seconds(loop.utime);
    }
    if (loop.state.task != "survey" || loop.state.waypoint_index < 0) continue;
    if (loop.state.waypoint_index != leg_index) {
      leg_index = loop.state.waypoint_index;
      was_on_leg = false;
      heading_deg = {};
    }
    const auto end = static_cast<size_t>(leg_index);
    const Leg leg{.from_m = end == 0 ? Eigen::Vector2d(0, 0) : kSurvey[end - 1],
                  .to_m = kSurvey[end]};
    const TrackPosition position = Project(leg, loop.vessel.position_m);
    const double error_m = std::abs(position.cross_track_m);
    was_on_leg = was_on_leg || error_m < 1;
    if (was_on_leg) track.overshoot_m = std::max(track.overshoot_m, error_m);
    track.fastest_mps = std::max(track.fastest_mps, loop.vessel.speed_mps);
    const double to_go_m = Length(leg) - position.along_m;
    if (Length(leg) > 100 && to_go_m < 40 && to_go_m > 10) {
      track.end_of_leg_m = std::max(track.end_of_leg_m, error_m);
      heading_deg.Add(RadToDeg(WrapPi(loop.vessel.heading_rad - Course(leg))));
      track.heading_sd_deg = std::max(track.heading_sd_deg, heading_deg.Deviation());
    }
  }
  track.home_distance_m = (loop.vessel.position_m - vehicle.return_task.point_m).norm();
  return track;
}

TEST(ClosedLoop, SurveysFivePointsAndComesHomeWithoutSwinging) {
  const Track track = Sail(1.5, 100'000, {0, 0});
  EXPECT_LT(track.overshoot_m, 2);
  EXPECT_LT(track.end_of_leg_m, 0.5);
  EXPECT_LT(track.heading_sd_deg, 1);
  EXPECT_LT(track.fastest_mps, 1.6);
  EXPECT_GT(track.home_time_s, 450);
  EXPECT_LT(track.home_time_s, 550);
  EXPECT_LT(track.home_distance_m, 5);
}

TEST(ClosedLoop, DoesSoAtAQuarterOfASecondPerTick) {
  const Track track = Sail(1.5, 250'000, {0, 0});
  EXPECT_LT(track.overshoot_m, 2);
  EXPECT_LT(track.end_of_leg_m, 0.5);
  EXPECT_LT(track.heading_sd_deg, 1);
  EXPECT_LT(track.home_distance_m, 5);
}

TEST(ClosedLoop, DoesSoAtASpeedWhereTheRudderBitesFully) {
  const Track track = Sail(2.5, 100'000, {0, 0});
  EXPECT_LT(track.overshoot_m, 3);
  EXPECT_LT(track.heading_sd_deg, 1);
  EXPECT_GT(track.home_time_s, 0);
}

TEST(ClosedLoop, HoldsItsLegsInACrossCurrent) {
  const Track track = Sail(1.5, 100'000, {0.4, 0});
  EXPECT_LT(track.overshoot_m, 5);
  EXPECT_LT(track.end_of_leg_m, 0.5);
  EXPECT_LT(track.heading_sd_deg, 1);
  EXPECT_GT(track.home_time_s, 0);
  EXPECT_LT(track.home_distance_m, 13);
}

TEST(ClosedLoop, PublishesThatAllPointsOfATaskWerePassedBeforeTheNextTaskBegins) {
  HelmAndVessel loop(Surveyor(2.5));
  loop.Run(320);
  const auto lap = std::find_if(loop.states.begin(), loop.states.end(), [](const auto& state) {
    return state.task == "survey" && state.laps_done == 1;
  });
  EXPECT_NE(lap, loop.states.end());
}

TEST(ClosedLoop, GivesTheSameTrackToTheLastBitEveryTime) {
  HelmAndVessel one(Surveyor(1.5));
  HelmAndVessel other(Surveyor(1.5));
  one.Run(200);
  other.Run(200);
  EXPECT_EQ(one.vessel.position_m, other.vessel.position_m);
  EXPECT_EQ(one.vessel.heading_rad, other.vessel.heading_rad);
}

}  // namespace shoal::closed_loop_test
