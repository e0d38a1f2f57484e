#include "apps/helm/helm_endings.h"

#include <gtest/gtest.h>

#include <string>

#include "apps/helm/helm_states.h"
#include "lib/base/geometry/angles.h"

namespace shoal::helm_endings_test {

Fix At(const Eigen::Vector3d& position_m, double time_s = 0, double speed_mps = 0) {
  return {.position_m = position_m.head<2>(),
          .heading_rad = DegToRad(90),
          .time_s = time_s,
          .z_m = position_m.z(),
          .velocity_mps = speed_mps * Eigen::Vector2d(1, 0),
          .speed_mps = speed_mps};
}

/// An AUV that has one task, a path to the East 20 m down.
Vehicle Auv(PathTaskEnd end, const std::optional<Ending>& ending = {}) {
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = Remus100Options{.cruise_depth_m = 60};
  vehicle.helm_options = {.end_of_tasks = ending, .hold_radius_m = 45, .loiter_radius_m = 50};
  vehicle.tasks = {{"path", PathFollowTask{.points_m = {{0, 0, 20}, {100, 0, 20}}, .end = end}}};
  return vehicle;
}

HelmStates Deployed(const Vehicle& vehicle) {
  HelmStates helm(vehicle);
  EXPECT_EQ(helm.Execute({.kind = OrderKind::kDeploy}), "");
  return helm;
}

/// Returns the helm at the end of its tasks, at `place_m` and with a speed of 2 m/s.
HelmStates Ended(const Vehicle& vehicle, const Eigen::Vector3d& place_m) {
  HelmStates helm = Deployed(vehicle);
  helm.Advance(At({0, 0, 20}, 0, 2), false);
  for (int i = 1; i < 4; ++i) helm.Advance(At(place_m, 50 + i, 2), false);
  EXPECT_TRUE(helm.task() != nullptr && helm.task()->name == "end_of_tasks");
  return helm;
}

TEST(AuvAtTheEndOfItsTasks, StopsAndKeepsItsPlaceAndDepthOnceItIsAtRest) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kDone), {101, 0, 20.2});
  EXPECT_EQ(KindOf(*helm.task()), "station_keep");
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
  EXPECT_EQ(helm.guidance()->z_m, 20);
  helm.Advance(At({110, 0, 20.2}, 60, 0.2), false);
  EXPECT_EQ(helm.guidance()->waypoint_m, Eigen::Vector2d(110, 0));
  helm.Advance(At({154, 0, 20.2}, 160, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0) << "44 m from there";
  helm.Advance(At({156, 0, 20.2}, 170, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1.5);
  EXPECT_NEAR(RadToDeg(helm.guidance()->heading_rad), 270, 1e-9);
  helm.Advance(At({127, 0, 20.2}, 190, 1.5), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0) << "17 m from there";
}

TEST(AuvAtTheEndOfItsTasks, KeepsTheDepthThatItHasWhereItWasFarFromTheOneAskedFor) {
  EXPECT_EQ(Ended(Auv(PathTaskEnd::kDone), {101, 0, 12}).guidance()->z_m, 12);
}

TEST(AuvAtTheEndOfItsTasks, SwimsBackToItsDepth) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kDone), {101, 0, 20});
  helm.Advance(At({110, 0, 20}, 60, 0), false);
  helm.Advance(At({110, 0, 19.8}, 160, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
  helm.Advance(At({110, 0, 19.7}, 170, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1.5);
  EXPECT_NEAR(RadToDeg(helm.guidance()->heading_rad), 90, 1e-9) << "on its heading: it is there";
  helm.Advance(At({112, 0, 19.85}, 180, 1.5), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1.5);
  helm.Advance(At({113, 0, 19.95}, 185, 1.5), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
}

TEST(AuvAtTheEndOfItsTasks, StaysUpAfterAPathThatEndsAtTheSurface) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kSurface), {101, 0, 0.3});
  EXPECT_EQ(KindOf(*helm.task()), "surface");
  for (const double drifted_m : {0.0, 60.0, 600.0}) {
    helm.Advance(At({101 + drifted_m, 0, 0.2}, 100 + drifted_m, 0), false);
    EXPECT_EQ(helm.task()->name, "end_of_tasks");
    EXPECT_EQ(helm.guidance()->speed_mps, 0);
    EXPECT_EQ(helm.guidance()->z_m, 0);
  }
}

TEST(AuvAtTheEndOfItsTasks, ComesUpFirstWhereTheEndingIsTheSurface) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kDone, Ending::kSurface), {101, 0, 20});
  EXPECT_EQ(helm.guidance()->speed_mps, 1.5);
  EXPECT_EQ(helm.guidance()->z_m, 0);
  EXPECT_NEAR(RadToDeg(helm.guidance()->heading_rad), 90, 1e-9);
  helm.Advance(At({140, 0, 0.4}, 90, 1.5), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
  helm.Advance(At({150, 0, 1.5}, 120, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0) << "a wave";
  helm.Advance(At({150, 0, 2.5}, 130, 0), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1.5) << "it has sunk";
}

TEST(AuvAtTheEndOfItsTasks, GoesOnOnTheCourseThatItHasOverGround) {
  Vehicle vehicle = Auv(PathTaskEnd::kDone, Ending::kGoOn);
  std::get<PathFollowTask>(vehicle.tasks[0].what).propeller_rpm = 900;
  HelmStates helm = Ended(vehicle, {101, 0, 20});
  helm.Advance(At({400, 0, 20}, 300, 2), false);
  EXPECT_EQ(helm.guidance()->z_m, 20);
  EXPECT_EQ(helm.guidance()->propeller_rpm, 900);
  EXPECT_NEAR(RadToDeg(helm.guidance()->heading_rad), 90, 1);
  helm.Advance(At({3000, 0, 20}, 2000, 2), false);
  EXPECT_NEAR(RadToDeg(helm.guidance()->heading_rad), 90, 1) << "past the end of the leg";
  EXPECT_GT(helm.guidance()->speed_mps, 0);
}

TEST(AuvAtTheEndOfItsTasks, LoitersAtItsDepth) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kDone, Ending::kLoiter), {101, 0, 20});
  EXPECT_EQ(KindOf(*helm.task()), "loiter");
  EXPECT_NEAR((helm.guidance()->waypoint_m - Eigen::Vector2d(101, 0)).norm(), 50, 1e-9);
  EXPECT_EQ(helm.guidance()->z_m, 20);
  EXPECT_EQ(helm.guidance()->speed_mps, 2);
}

TEST(AuvAtTheEndOfItsTasks, WaitsForTheEndOfTheMissionAsByDefault) {
  EXPECT_EQ(KindOf(*Ended(Auv(PathTaskEnd::kDone, Ending::kEndMission), {101, 0, 20}).task()),
            "station_keep");
  EXPECT_EQ(KindOf(*Ended(Auv(PathTaskEnd::kSurface, Ending::kEndMission), {101, 0, 0}).task()),
            "surface");
}

TEST(AuvAtTheEndOfItsTasks, StartsItsListAgainWhenDeployed) {
  HelmStates helm = Ended(Auv(PathTaskEnd::kSurface), {101, 0, 0.3});
  EXPECT_EQ(helm.Execute({.kind = OrderKind::kDeploy}), "");
  helm.Advance(At({101, 0, 0.3}, 100, 0), false);
  EXPECT_EQ(helm.task()->name, "path");
  helm.Advance(At({0, 0, 0.3}, 150, 2), false);  // Back at its first point.
  for (int i = 0; i < 4; ++i) helm.Advance(At({101, 0, 0.3}, 200 + i, 0), false);
  EXPECT_EQ(helm.task()->name, "end_of_tasks") << "the list comes to its end again";
}

TEST(OrdersToAnAuv, KeepItsStationAtTheDepthWhereItIs) {
  HelmStates helm = Deployed(Auv(PathTaskEnd::kGoOn));
  helm.Advance(At({0, 0, 11}, 0, 2), false);
  EXPECT_EQ(helm.Execute({.kind = OrderKind::kStationKeep}), "");
  helm.Advance(At({10, 0, 12}, 5, 2), false);
  EXPECT_EQ(helm.guidance()->z_m, 12);
  EXPECT_EQ(helm.Execute({.kind = OrderKind::kGoto, .point_m = {50, 0}}), "");
  helm.Advance(At({10, 0, 12}, 6, 2), false);
  EXPECT_FALSE(helm.guidance()->z_m.has_value()) << "it goes there at its cruise depth";
  helm.Advance(At({50, 0, 14}, 60, 1), false);
  helm.Advance(At({50, 0, 14}, 61, 1), false);
  EXPECT_EQ(helm.guidance()->z_m, 14);
  EXPECT_EQ(helm.guidance()->waypoint_m, Eigen::Vector2d(50, 0));
}

TEST(OrdersToAnAuv, ChangeTheSpeedOfATaskThatHasRevolutions) {
  Vehicle vehicle = Auv(PathTaskEnd::kGoOn);
  std::get<PathFollowTask>(vehicle.tasks[0].what).propeller_rpm = 900;
  HelmStates helm = Deployed(vehicle);
  helm.Advance(At({0, 0, 20}, 0, 2), false);
  EXPECT_EQ(helm.guidance()->propeller_rpm, 900);
  EXPECT_EQ(helm.Execute({.kind = OrderKind::kSpeed, .speed_mps = 1.2}), "");
  helm.Advance(At({1, 0, 20}, 1, 2), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1.2);
  EXPECT_FALSE(helm.guidance()->propeller_rpm.has_value());
}

TEST(OrdersToAnAuv, DoNotChangeTheSpeedOfAFollower) {
  Vehicle vehicle = Auv(PathTaskEnd::kDone);
  TargetTrackTask track;
  track.target = "bravo";
  vehicle.tasks = {{"follow", track}};
  HelmStates helm = Deployed(vehicle);
  EXPECT_EQ(
      helm.Execute({.kind = OrderKind::kSpeed, .speed_mps = 1.2}),
      "speed: the task 'follow' takes its speed from its law; order the speed of bravo, which "
      "it follows");
}

TEST(SurfaceCraftAtTheEndOfItsTasks, KeepsStationWithinItsRadius) {
  Vehicle vehicle;
  vehicle.helm_options = {.hold_radius_m = 30};
  HelmStates helm = Deployed(vehicle);
  helm.Advance(At({0, 0, 0}), false);
  EXPECT_FALSE(helm.guidance()->z_m.has_value());
  helm.Advance(At({29, 0, 0}, 10), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
  helm.Advance(At({31, 0, 0}, 20), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 1);
  helm.Advance(At({11, 0, 0}, 50), false);
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
}

}  // namespace shoal::helm_endings_test
