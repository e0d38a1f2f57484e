// Helms and simulators of underwater vehicles together: what a user sees of model, autopilots and
// guidance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "apps/helm/helm_app.h"
#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::underwater_loop_test {

Vehicle Auv(const std::string& name, const StartPose& start, const decltype(Task::what)& what) {
  Vehicle vehicle;
  vehicle.name = name;
  vehicle.model = Remus100Options{};
  vehicle.start = start;
  vehicle.helm_options.deploy_at_start = true;
  vehicle.tasks = {{.name = "task", .what = what}};
  return vehicle;
}

/// All vehicles of a mission, each with its helm and its simulator. What they published last is
/// here.
class Loop {
 public:
  struct Seen {
    nav_t nav{};
    helm_state_t helm{};
    actuators_t actuators{};
  };

  explicit Loop(const Mission& mission)
      : mission_(mission), seen(mission.vehicles.size()), test_bus_(hub_.Join("test")) {
    for (size_t i = 0; i < mission_.vehicles.size(); ++i) {
      const Vehicle& vehicle = mission_.vehicles[i];
      apps_.push_back(
          std::make_unique<HelmApp>(mission_, vehicle, hub_.Join("helm_" + vehicle.name)));
      apps_.push_back(
          std::make_unique<VehicleSimApp>(mission_, vehicle, hub_.Join("sim_" + vehicle.name)));
      Subscribe(test_bus_, channels::Nav(vehicle.name),
                [this, i](const nav_t& nav) { seen[i].nav = nav; });
      Subscribe(test_bus_, channels::HelmState(vehicle.name),
                [this, i](const helm_state_t& helm) { seen[i].helm = helm; });
      Subscribe(test_bus_, channels::Actuators(vehicle.name),
                [this, i](const actuators_t& actuators) { seen[i].actuators = actuators; });
    }
  }

  void Step() {
    hub_.NextStep();
    hub_.HandleAll();
    for (const auto& app : apps_) app->Tick(utime_);
    utime_ += mission_.tick_us;
  }
  /// Runs until `end_s`, and calls `look` after each step.
  template <class Look>
  void RunUntil(double end_s, const Look& look) {
    while (time_s() < end_s) {
      Step();
      look();
    }
  }

  double time_s() const { return Seconds(utime_); }

 private:
  Mission mission_;

 public:
  std::vector<Seen> seen;

 private:
  MemoryBus hub_;
  Bus& test_bus_;
  std::vector<std::unique_ptr<App>> apps_;
  int64_t utime_ = 0;
};

Mission InACurrent(double speed_mps, double direction_deg) {
  Mission mission;
  mission.environment.current.speed_mps = std::to_string(speed_mps);
  mission.environment.current.direction_deg = std::to_string(direction_deg);
  return mission;
}

void Flatten(Mission* mission, double depth_m) {
  mission->environment.floor.style = "flat";
  mission->environment.floor.depth_m = depth_m;
}

class UnderwaterLoop : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Remus100, UnderwaterLoop, testing::Values("default", "munet", "fossen"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(UnderwaterLoop, HoldsTrackAndDepthInACurrentFromTheSide) {
  Mission mission = InACurrent(0.4, 0);
  PathFollowTask path;
  path.points_m = {{0, 0, 20}, {2000, 0, 30}};
  mission.vehicles = {Auv("alpha", {.heading_deg = 90, .speed_mps = 2, .depth_m = 20}, path)};
  mission.vehicles[0].model = Remus100Options{.parameters = GetParam()};
  Loop loop(mission);
  double worst_track_m = 0;
  double worst_depth_m = 0;
  loop.RunUntil(300, [&] {
    if (loop.time_s() < 200) return;
    worst_track_m = std::max(worst_track_m, std::abs(loop.seen[0].nav.y_m));
    worst_depth_m = std::max(worst_depth_m, std::abs(loop.seen[0].nav.z_m - 30));
  });
  // MuNet's gains let the rudder swing from stop to stop, and the heading by 4 degrees.
  const bool swings = std::string(GetParam()) == "munet";
  EXPECT_LT(worst_track_m, swings ? 1.5 : 1);
  EXPECT_LT(worst_depth_m, 0.5);
  EXPECT_GT(loop.seen[0].nav.x_m, 500);
  EXPECT_NEAR(loop.seen[0].nav.course_over_ground_deg, 90, swings ? 6 : 1);
  EXPECT_NEAR(loop.seen[0].nav.heading_deg, 90 + RadToDeg(std::asin(0.4 / 2)), swings ? 6 : 1)
      << "it crabs";
  EXPECT_NEAR(loop.seen[0].helm.cross_track_error_m, -loop.seen[0].nav.y_m, 0.2)
      << "to starboard of a leg to the East is South";
}

/// alpha goes ahead; bravo follows, too far away at first, and charlie, too near.
Mission Formation() {
  Mission mission = InACurrent(0.3, 30);
  Flatten(&mission, 80);
  PathFollowTask path;
  path.points_m = {{0, 0, 20}, {2000, 0, 30}};
  path.speed_mps = 1.3;
  TargetTrackTask track;
  track.target = "alpha";
  mission.vehicles = {
      Auv("alpha", {.heading_deg = 90, .speed_mps = 1.3, .depth_m = 20}, path),
      Auv("bravo", {.x_m = -200, .y_m = 60, .heading_deg = 90, .depth_m = 20}, track),
      Auv("charlie", {.x_m = -40, .y_m = -10, .heading_deg = 0, .depth_m = 25}, track)};
  return mission;
}

double Distance(const nav_t& a, const nav_t& b) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m, a.z_m - b.z_m);
}

TEST(UnderwaterSwarm, ComesNearTheBandOfItsFormationFromBothSidesAndStaysThere) {
  Loop loop(Formation());
  const FormationLayer band;
  double least_m = 1e9;
  double most_m = 0;
  double closest_m = 1e9;
  loop.RunUntil(300, [&] {
    if (loop.time_s() < 1) return;
    closest_m = std::min(closest_m, Distance(loop.seen[1].nav, loop.seen[2].nav));
    if (loop.time_s() < 200) return;
    for (const size_t follower : {1U, 2U}) {
      const double distance_m = Distance(loop.seen[0].nav, loop.seen[follower].nav);
      least_m = std::min(least_m, distance_m);
      most_m = std::max(most_m, distance_m);
    }
  });
  // The layer's pull fades with the cube of what is left to go: the band's edge is never reached.
  EXPECT_GT(least_m, band.r_inner_m - 25);
  EXPECT_LT(most_m, band.r_outer_m() + 30);
  EXPECT_GT(closest_m, SurvivalGroupLayer().r_safe_m);
  EXPECT_NEAR(loop.seen[1].nav.speed_over_ground_mps, loop.seen[0].nav.speed_over_ground_mps, 0.2);
  EXPECT_EQ(loop.seen[1].helm.task_kind, "target_track");
  EXPECT_NEAR(loop.seen[1].helm.distance_m, Distance(loop.seen[0].nav, loop.seen[1].nav), 2);
}

TEST(UnderwaterSwarm, DoesTheSameBitForBitEachTime) {
  const auto run = [] {
    std::vector<double> all;
    Loop loop(Formation());
    loop.RunUntil(60, [&] {
      for (const Loop::Seen& seen : loop.seen) {
        all.insert(all.end(), {seen.nav.x_m, seen.nav.y_m, seen.nav.z_m, seen.nav.roll_deg,
                               seen.nav.heading_deg, seen.actuators.rudder_deg,
                               seen.actuators.stern_plane_deg, seen.actuators.propeller_rpm});
      }
    });
    return all;
  };
  const std::vector<double> first = run();
  EXPECT_EQ(first.size(), 600U * 3 * 8);
  EXPECT_EQ(first, run());
}

/// A floor that rises toward the East, from 45 m at the start to 15 m at the origin.
Mission TowardTheShore() {
  Mission mission = InACurrent(0.1, 90);
  FloorOptions& floor = mission.environment.floor;
  floor.style = "linear";
  floor.depth_m = 15;
  floor.range_m = 0;
  floor.size_m = 2000;
  floor.slope_east = -0.05;
  return mission;
}

TEST(OverARisingFloor, APathIsLeftUpwardRatherThanIntoTheGround) {
  Mission mission = TowardTheShore();
  PathFollowTask path;
  path.points_m = {{-600, 0, 20}, {200, 0, 60}};
  mission.vehicles = {
      Auv("alpha", {.x_m = -600, .heading_deg = 90, .speed_mps = 2, .depth_m = 20}, path)};
  Loop loop(mission);
  double least_m = 1e9;
  loop.RunUntil(300, [&] {
    if (loop.time_s() > 1) least_m = std::min(least_m, loop.seen[0].nav.altitude_m);
  });
  EXPECT_GT(least_m, 1.5);
  EXPECT_LT(least_m, 5) << "so that it was put to the test";
  EXPECT_GT(loop.seen[0].nav.x_m, -100);
}

TEST(OverARisingFloor, AFollowerStaysOffTheGroundThatItsTargetIsNotAfraidOf) {
  Mission mission = TowardTheShore();
  PathFollowTask path;
  path.points_m = {{-500, 0, 20}, {300, 0, 5}};
  path.speed_mps = 1.3;
  TargetTrackTask track;
  track.target = "alpha";
  mission.vehicles = {
      Auv("alpha", {.x_m = -500, .heading_deg = 90, .speed_mps = 1.3, .depth_m = 20}, path),
      Auv("bravo", {.x_m = -620, .heading_deg = 90, .speed_mps = 1.3, .depth_m = 38}, track)};
  Loop loop(mission);
  double least_m = 1e9;
  loop.RunUntil(300, [&] {
    if (loop.time_s() > 1) least_m = std::min(least_m, loop.seen[1].nav.altitude_m);
  });
  EXPECT_GT(least_m, 3);
  EXPECT_LT(least_m, 5) << "so that it was put to the test";
}

}  // namespace shoal::underwater_loop_test
