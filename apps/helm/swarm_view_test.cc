#include "apps/helm/swarm_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "apps/helm/swarm_testing.h"
#include "lib/base/geometry/angles.h"

namespace shoal::swarm_view_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::vector<int> IdsOf(const Surroundings& surroundings) {
  std::vector<int> ids;
  for (const Neighbour& neighbour : surroundings.group) ids.push_back(neighbour.id);
  return ids;
}

using Names = std::vector<std::string>;

TEST(SwarmView, SubscribesToTheTargetAndToAllThatFollowItByDefault) {
  const Mission mission = Swarm();
  EXPECT_EQ(SwarmView(mission, mission.vehicles[1]).names(), (Names{"alpha", "charlie", "delta"}));
}

TEST(SwarmView, SubscribesToTheGroupThatTheTaskNames) {
  Mission mission = Swarm();
  mission.vehicles[1].tasks = {Following("alpha", {"echo", "bravo", "alpha"})};
  EXPECT_EQ(SwarmView(mission, mission.vehicles[1]).names(), (Names{"alpha", "echo"}));
}

TEST(SwarmView, SubscribesToEveryTargetOfItsTasksOnce) {
  Mission mission = Swarm();
  mission.vehicles[4].tasks = {Following("bravo"), Following("alpha"), Following("bravo")};
  EXPECT_EQ(SwarmView(mission, mission.vehicles[4]).names(),
            (Names{"alpha", "bravo", "charlie", "delta"}));
}

TEST(SwarmView, SubscribesToNoVehicleWithoutATaskThatFollows) {
  const Mission mission = Swarm();
  EXPECT_EQ(SwarmView(mission, mission.vehicles[0]).names(), Names{});
}

TEST(SwarmView, HasNothingToShowForTasksThatFollowNoVehicle) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  const Task task = {.name = "path", .what = PathFollowTask{.points_m = {{0, 0, 10}}}};
  EXPECT_EQ(swarm.Look(&task, At(0, 0)), nullptr);
  EXPECT_EQ(swarm.Look(nullptr, At(0, 0)), nullptr);
}

/// A path that keeps clear of others.
Task AmongOthers(const std::vector<VelocityLayer>& layers,
                 const std::vector<std::string>& group = {}) {
  PathFollowTask path = {.points_m = {{0, 0, 10}}};
  path.cascade.layers = layers;
  path.group = group;
  return {.name = "path", .what = path};
}

/// The swarm, with alpha, bravo and echo under water.
Mission SwarmWithDivers() {
  Mission mission = Swarm();
  for (const size_t place : {0, 1, 4}) mission.vehicles[place].model = Remus100Options{};
  return mission;
}

TEST(SwarmView, OfAPathWithSurvivalKnowsTheOtherUnderwaterVehicles) {
  Mission mission = SwarmWithDivers();
  mission.vehicles[0].tasks = {AmongOthers({SurvivalGroupLayer{}})};
  SwarmView swarm(mission, mission.vehicles[0]);
  EXPECT_EQ(swarm.names(), (Names{"bravo", "echo"}));
  for (const char* name : {"bravo", "echo"}) TakeNav(&swarm, name, At(1, 2));
  const Surroundings* seen = swarm.Look(&mission.vehicles[0].tasks[0], At(0, 0));
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(IdsOf(*seen), (std::vector<int>{1, 4}));
  EXPECT_FALSE(seen->target.has_value());
}

TEST(SwarmView, OfAPathKnowsTheGroupThatTheTaskNames) {
  Mission mission = SwarmWithDivers();
  mission.vehicles[0].tasks = {AmongOthers({SurvivalGroupLayer{}}, {"delta", "alpha"})};
  EXPECT_EQ(SwarmView(mission, mission.vehicles[0]).names(), Names{"delta"});
}

TEST(SwarmView, OfAPathWithASonarAloneKnowsNoVehicle) {
  Mission mission = SwarmWithDivers();
  mission.vehicles[0].tasks = {AmongOthers({SurvivalSonarLayer{}})};
  SwarmView swarm(mission, mission.vehicles[0]);
  EXPECT_EQ(swarm.names(), Names{});
  const Surroundings* seen = swarm.Look(&mission.vehicles[0].tasks[0], At(0, 0));
  ASSERT_NE(seen, nullptr);
  EXPECT_TRUE(seen->group.empty());
}

sonar_t PingOf(int64_t utime, double range_m) {
  sonar_t ping{};
  ping.utime = utime;
  ping.beams = {{.azimuth_deg = 0, .elevation_deg = 0, .range_m = range_m}};
  ping.num_beams = 1;
  return ping;
}

TEST(SwarmView, RemembersEchoesForAsLongAsALayerWants) {
  Mission mission = SwarmWithDivers();
  mission.vehicles[0].tasks = {AmongOthers({SurvivalSonarLayer{.memory_s = 20}}),
                               AmongOthers({SurvivalSonarLayer{}})};
  SwarmView swarm(mission, mission.vehicles[0]);
  nav_t own = At(0, 0);
  swarm.OnSonar(PingOf(0, 30));
  const Task& remembers = mission.vehicles[0].tasks[0];
  EXPECT_FALSE(swarm.Look(&remembers, own)->sonar.empty());
  own.utime = 10'000'000;
  own.y_m = 10;
  own.heading_deg = 90;
  const Surroundings* later = swarm.Look(&remembers, own);
  ASSERT_EQ(later->sonar.size(), 1u);
  EXPECT_NEAR(later->sonar[0].range_m, 20, 1e-9);
  EXPECT_LT((later->sonar[0].direction - Eigen::Vector3d::UnitY()).norm(), 1e-9)
      << "it was seen ahead, to the North, and lies there still";
  EXPECT_TRUE(swarm.Look(&mission.vehicles[0].tasks[1], own)->sonar.empty());
  own.utime = 21'000'000;
  EXPECT_TRUE(swarm.Look(&remembers, own)->sonar.empty());
}

TEST(SwarmView, KnowsNoTargetBeforeItsFirstNav) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  const Surroundings* seen = swarm.Look(&mission.vehicles[1].tasks[0], At(5, 6, 7));
  ASSERT_NE(seen, nullptr);
  EXPECT_FALSE(seen->target.has_value());
  EXPECT_TRUE(seen->group.empty());
  EXPECT_EQ(seen->own.id, 1);
  EXPECT_EQ(seen->own.position_m, Eigen::Vector3d(5, 6, 7));
}

TEST(SwarmView, SeesTheTargetApartFromTheOthersAndNeverItself) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  for (const char* name : {"alpha", "bravo", "charlie", "delta"}) TakeNav(&swarm, name, At(1, 2));
  const Surroundings* seen = swarm.Look(&mission.vehicles[1].tasks[0], At(0, 0));
  ASSERT_NE(seen, nullptr);
  ASSERT_TRUE(seen->target.has_value());
  EXPECT_EQ(seen->target->id, 0);
  EXPECT_EQ(IdsOf(*seen), (std::vector<int>{2, 3}));
}

TEST(SwarmView, KeepsClearOfANamedGroupOnly) {
  Mission mission = Swarm();
  mission.vehicles[1].tasks = {Following("alpha", {"echo", "bravo", "alpha"})};
  SwarmView swarm(mission, mission.vehicles[1]);
  for (const char* name : {"alpha", "charlie", "delta", "echo"}) TakeNav(&swarm, name, At(1, 2));
  const Surroundings* seen = swarm.Look(&mission.vehicles[1].tasks[0], At(0, 0));
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(IdsOf(*seen), std::vector<int>{4});
}

TEST(SwarmView, LooksAtTheTargetOfTheTaskThatRuns) {
  Mission mission = Swarm();
  mission.vehicles[4].tasks = {Following("alpha"), Following("bravo")};
  SwarmView swarm(mission, mission.vehicles[4]);
  for (const char* name : {"alpha", "bravo", "charlie", "delta"}) TakeNav(&swarm, name, At(1, 2));
  EXPECT_EQ(swarm.Look(&mission.vehicles[4].tasks[0], At(0, 0))->target->id, 0);
  const Surroundings* seen = swarm.Look(&mission.vehicles[4].tasks[1], At(0, 0));
  EXPECT_EQ(seen->target->id, 1);
  EXPECT_TRUE(seen->group.empty()) << "no other vehicle follows bravo";
}

TEST(SwarmView, TurnsSpeedAndCourseOverGroundIntoVelocities) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  nav_t nav = At(0, 0);
  nav.heading_deg = 10;
  nav.speed_mps = 9;
  nav.course_over_ground_deg = 120;
  nav.speed_over_ground_mps = 2;
  nav.descent_mps = 0.3;
  TakeNav(&swarm, "alpha", nav);
  const Surroundings* seen = swarm.Look(&mission.vehicles[1].tasks[0], nav);
  const Eigen::Vector3d expected(2 * std::cos(DegToRad(30)), -1, 0.3);
  EXPECT_LT((seen->target->velocity_mps - expected).norm(), 1e-12);
  EXPECT_LT((seen->own.velocity_mps - expected).norm(), 1e-12);
}

TEST(SwarmView, KnowsTheFloorByItsOwnAltitude) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  const Task& task = mission.vehicles[1].tasks[0];
  const double deep_m = Surroundings().seabed_z_m;
  nav_t nav = At(0, 0, 20);
  EXPECT_EQ(swarm.Look(&task, nav)->seabed_z_m, deep_m) << "not known";
  nav.altitude_m = 15;
  EXPECT_EQ(swarm.Look(&task, nav)->seabed_z_m, 35);
  nav.altitude_m = -1;
  EXPECT_EQ(swarm.Look(&task, nav)->seabed_z_m, deep_m) << "not known any more";
  nav.altitude_m = kNan;
  EXPECT_EQ(swarm.Look(&task, nav)->seabed_z_m, deep_m);
}

TEST(SwarmView, PassesOverInvalidNav) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  const Task& task = mission.vehicles[1].tasks[0];
  TakeNav(&swarm, "alpha", At(1, 2, 3));
  for (const double bad : {kNan, 1e300, -1e300, 1.1e6, std::numeric_limits<double>::infinity()}) {
    for (double nav_t::*field : {&nav_t::x_m, &nav_t::y_m, &nav_t::z_m, &nav_t::descent_mps,
                                 &nav_t::speed_over_ground_mps}) {
      nav_t nav = At(50, 60, 70);
      nav.*field = bad;
      TakeNav(&swarm, "alpha", nav);
      EXPECT_EQ(swarm.Look(&task, At(0, 0))->target->position_m, Eigen::Vector3d(1, 2, 3)) << bad;
      EXPECT_EQ(swarm.Look(&task, nav), nullptr) << "nor does it trust its own";
    }
  }
  nav_t nav = At(50, 60, 70);
  nav.course_over_ground_deg = kNan;
  nav.speed_over_ground_mps = 1;
  TakeNav(&swarm, "alpha", nav);
  EXPECT_EQ(swarm.Look(&task, At(0, 0))->target->position_m, Eigen::Vector3d(1, 2, 3));
}

/// NAV of a vehicle that moves relative to the water at its own velocity, in a current.
nav_t InACurrent(const Eigen::Vector2d& current_mps) {
  nav_t nav = At(0, 0);
  nav.heading_deg = 30;
  nav.pitch_deg = 10;
  nav.surge_mps = 2;
  nav.sway_mps = 0.1;
  nav.heave_mps = -0.2;
  const double ahead_mps = 2 * std::cos(DegToRad(10)) - 0.2 * std::sin(DegToRad(10));
  const Eigen::Vector2d over_ground_mps =
      ahead_mps * UnitVector(DegToRad(30)) + 0.1 * UnitVector(DegToRad(120)) + current_mps;
  nav.speed_over_ground_mps = over_ground_mps.norm();
  nav.course_over_ground_deg = RadToDeg(HeadingOf(over_ground_mps));
  return nav;
}

TEST(SwarmView, DerivesTheCurrentFromBothVelocities) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  const Task& task = mission.vehicles[1].tasks[0];
  for (const Eigen::Vector2d& current_mps :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.3, -0.4), Eigen::Vector2d(-1, 0)}) {
    const Surroundings* seen = swarm.Look(&task, InACurrent(current_mps));
    ASSERT_NE(seen, nullptr);
    EXPECT_LT((seen->current_mps.head<2>() - current_mps).norm(), 1e-9);
    EXPECT_EQ(seen->current_mps.z(), 0);
  }
}

TEST(SwarmView, IgnoresAnInvalidCurrent) {
  const Mission mission = Swarm();
  SwarmView swarm(mission, mission.vehicles[1]);
  for (const double bad : {kNan, 1e300, -1e300, std::numeric_limits<double>::infinity()}) {
    for (double nav_t::*field : {&nav_t::surge_mps, &nav_t::sway_mps, &nav_t::heave_mps}) {
      nav_t nav = InACurrent({0.3, 0});
      nav.*field = bad;
      const Surroundings* seen = swarm.Look(&mission.vehicles[1].tasks[0], nav);
      ASSERT_NE(seen, nullptr);
      EXPECT_EQ(seen->current_mps, Eigen::Vector3d(0, 0, 0)) << bad;
    }
  }
}

/// A ping of two beams: an echo 20 m ahead, 30 degrees to starboard, and one that saw nothing.
sonar_t PingAt(int64_t utime) {
  sonar_t ping{};
  ping.utime = utime;
  ping.num_beams = 2;
  ping.beams.resize(2);
  ping.beams[0] = {.azimuth_deg = 30, .elevation_deg = 0, .range_m = 20};
  ping.beams[1] = {.azimuth_deg = 0, .elevation_deg = 10, .range_m = -1};
  return ping;
}

TEST(SwarmView, TurnsSonarEchoesIntoDirectionsOfTheWorld) {
  const Mission mission = Swarm();
  SwarmView view(mission, mission.vehicles[1]);
  view.OnSonar(PingAt(500'000));
  nav_t own = At(0, 0);
  own.utime = 600'000;
  own.heading_deg = 60;
  const Surroundings* surroundings = view.Look(&mission.vehicles[1].tasks[0], own);
  ASSERT_NE(surroundings, nullptr);
  ASSERT_EQ(surroundings->sonar.size(), 1U) << "what saw nothing is not an echo";
  EXPECT_EQ(surroundings->sonar[0].range_m, 20);
  // 60 degrees and 30 more clockwise is East.
  EXPECT_LT((surroundings->sonar[0].direction - Eigen::Vector3d::UnitX()).norm(), 1e-12);

  own.heading_deg = 330;
  own.pitch_deg = 90;
  surroundings = view.Look(&mission.vehicles[1].tasks[0], own);
  EXPECT_NEAR(surroundings->sonar[0].direction.z(), -std::cos(DegToRad(30)), 1e-12)
      << "with the bow up, ahead is up";
}

TEST(SwarmView, ForgetsEchoesAfterASecond) {
  const Mission mission = Swarm();
  SwarmView view(mission, mission.vehicles[1]);
  view.OnSonar(PingAt(500'000));
  nav_t own = At(0, 0);
  own.utime = 1'500'000;
  EXPECT_EQ(view.Look(&mission.vehicles[1].tasks[0], own)->sonar.size(), 1U);
  own.utime = 1'500'001;
  EXPECT_TRUE(view.Look(&mission.vehicles[1].tasks[0], own)->sonar.empty());
}

TEST(SwarmView, PassesOverEchoesThatAreNoNumbers) {
  const Mission mission = Swarm();
  SwarmView view(mission, mission.vehicles[1]);
  sonar_t ping = PingAt(0);
  ping.beams[0].azimuth_deg = kNan;
  ping.beams[1].range_m = std::numeric_limits<double>::infinity();
  view.OnSonar(ping);
  EXPECT_TRUE(view.Look(&mission.vehicles[1].tasks[0], At(0, 0))->sonar.empty());
}

}  // namespace shoal::swarm_view_test
