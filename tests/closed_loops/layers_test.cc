// AUVs that keep clear of what is in their way and of each other, with inertia, fins, sonar and
// current.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/closed_loops/careful_auv.h"

namespace shoal::layers_test {

using Eigen::Vector3d;

constexpr double kWreck_m = 120;  ///< So far along the path.

/// As a mission has the layers of path_follow by default.
const SurvivalGroupLayer kSurvival = {.r_pass_m = 20};
const SurvivalSonarLayer kSonar = {.r_pass_m = 10, .memory_s = 20};

PathFollowTask Path(const std::vector<Vector3d>& points_m, double speed_mps,
                    const std::vector<VelocityLayer>& layers) {
  PathFollowTask task;
  task.points_m = points_m;
  task.speed_mps = speed_mps;
  task.end = PathTaskEnd::kGoOn;
  task.cascade.layers = layers;
  return task;
}

struct Passage {
  double nearest_m = 1e9;  ///< From the vehicle's centre to that of the wreck.
  double back_m = 0;       ///< So far behind the wreck it is less than 2 m off its path for good.
  double widest_m = 0;     ///< Off its path.
  double off_depth_m = 0;
};

/// Passes a wreck that lies `off_m` to port of a path to the East, 20 m down.
Passage PassWreck(double off_m, double speed_mps = 1.5, const Vector3d& current_mps = {0, 0, 0},
                  const std::vector<VelocityLayer>& layers = {kSonar}) {
  SeaAround sea = {.current_mps = current_mps};
  sea.wrecks = {{.position_m = {kWreck_m, off_m, 20}}};
  CarefulAuv auv(1, Path({{0, 0, 20}, {600, 0, 20}}, speed_mps, layers), {0, 0, 20}, kPi / 2,
                 speed_mps, sea);
  Passage passage;
  while (auv.neighbour().position_m.x() < kWreck_m + 150) {
    auv.Step({});
    const Vector3d at_m = auv.neighbour().position_m;
    passage.nearest_m = std::min(passage.nearest_m, (at_m - sea.wrecks[0].position_m).norm());
    if (at_m.x() > kWreck_m && std::abs(at_m.y()) > 2) passage.back_m = at_m.x() - kWreck_m;
    passage.widest_m = std::max(passage.widest_m, std::abs(at_m.y()));
    passage.off_depth_m = std::max(passage.off_depth_m, std::abs(at_m.z() - 20));
  }
  return passage;
}

// 6.2 m at 1.5 m/s; by repulsion alone 1.2 m, where a hull of 1.6 m touches.
TEST(AWreck, DeadAheadIsPassedAtMoreThanThreeMetresAndHitWithoutTheSidestep) {
  const Passage passage = PassWreck(0);
  EXPECT_GT(passage.nearest_m, 5);
  EXPECT_LT(passage.off_depth_m, 1);
  EXPECT_GT(PassWreck(0, 2).nearest_m, 5);
  EXPECT_LT(PassWreck(0, 1.5, {0, 0, 0}, {SurvivalSonarLayer{}}).nearest_m, 1.6);
}

TEST(AWreck, AFewMetresOffIsPassedAtMoreThanThreeMetres) {
  for (const double off_m : {2.0, -2.0, 5.0, 10.0}) {
    EXPECT_GT(PassWreck(off_m).nearest_m, 8) << off_m;
  }
}

TEST(AWreck, IsPassedOnTheOtherSideInAMirror) {
  const Passage port = PassWreck(2);
  const Passage starboard = PassWreck(-2);
  // The propeller's torque heels the hull a little, always to the same side.
  EXPECT_NEAR(port.nearest_m, starboard.nearest_m, 0.3);
  EXPECT_NEAR(port.widest_m, starboard.widest_m, 0.3);
}

// Least 2 m off and against the current: so slow over ground, its echoes are forgotten before it is
// abeam.
TEST(AWreck, IsPassedInACurrentFromAnySide) {
  for (const Vector3d& current_mps :
       {Vector3d(0.4, 0, 0), Vector3d(-0.4, 0, 0), Vector3d(0, 0.4, 0), Vector3d(0, -0.4, 0)}) {
    for (const double off_m : {0.0, 2.0, -2.0, 10.0}) {
      EXPECT_GT(PassWreck(off_m, 1.5, current_mps).nearest_m, 3.5)
          << off_m << " m off, current " << current_mps.transpose();
    }
  }
}

TEST(AWreck, IsFollowedByTheTrackAgain) {
  for (const double off_m : {0.0, 2.0, -2.0, 10.0}) {
    const Passage passage = PassWreck(off_m);
    EXPECT_LT(passage.back_m, 60) << off_m;
    EXPECT_LT(passage.widest_m, 15) << off_m;
  }
}

TEST(AWreck, FarBesideIsNoReasonToLeaveTheTrack) { EXPECT_LT(PassWreck(25).widest_m, 1.5); }

TEST(AWall, ThatItsPathLeadsIntoIsGoneRound) {
  for (const double middle_m : {0.0, 5.0, -5.0}) {
    SeaAround sea;
    sea.walls_m = {
        {{150, middle_m - 20}, {160, middle_m - 20}, {160, middle_m + 20}, {150, middle_m + 20}}};
    CarefulAuv auv(1, Path({{0, 0, 20}, {600, 0, 20}}, 1.5, {kSonar}), {0, 0, 20}, kPi / 2, 1.5,
                   sea);
    double nearest_m = 1e9;
    for (int i = 0; i < 8000 && auv.neighbour().position_m.x() < 300; ++i) {
      auv.Step({});
      nearest_m =
          std::min(nearest_m, SignedDistance(sea.walls_m[0], auv.neighbour().position_m.head<2>()));
    }
    EXPECT_GT(auv.neighbour().position_m.x(), 299) << middle_m;
    EXPECT_GT(nearest_m, 5) << middle_m;
    EXPECT_LT(std::abs(auv.neighbour().position_m.y()), 2) << "back on its track";
  }
}

/// Returns how near two vehicles come whose paths cross 150 m ahead of both, the second at
/// `course_rad` clockwise from North.
double Meet(double course_rad, double off_m, double speed_mps, double r_pass_m = 20) {
  const SeaAround sea;
  const std::vector<VelocityLayer> layers = {SurvivalGroupLayer{.r_pass_m = r_pass_m}};
  const Vector3d along(std::sin(course_rad), std::cos(course_rad), 0);
  const Vector3d crossing_m(150, off_m, 20);
  const Vector3d start_m = crossing_m - 150 * along;
  CarefulAuv one(1, Path({{0, 0, 20}, {600, 0, 20}}, speed_mps, layers), {0, 0, 20}, kPi / 2,
                 speed_mps, sea);
  CarefulAuv other(2, Path({start_m, crossing_m + 450 * along}, speed_mps, layers), start_m,
                   course_rad, speed_mps, sea);
  double nearest_m = 1e9;
  for (int i = 0; i < 2600; ++i) {
    const Neighbour a = one.neighbour(), b = other.neighbour();
    nearest_m = std::min(nearest_m, (a.position_m - b.position_m).norm());
    one.Step({b});
    other.Step({a});
  }
  return nearest_m;
}

TEST(TwoPathFollowers, HeadOnKeepTheirSafeDistance) {
  for (const double off_m : {0.0, 4.0, -4.0}) {
    EXPECT_GT(Meet(DegToRad(270), off_m, 2), kSurvival.r_safe_m) << off_m;
  }
  EXPECT_GT(Meet(DegToRad(270), 0, 1.5), kSurvival.r_safe_m);
  EXPECT_LT(Meet(DegToRad(270), 0, 2, 0), 3) << "by repulsion alone they collide, nearly";
}

TEST(TwoPathFollowers, OnCrossingPathsKeepTheirSafeDistance) {
  for (const double course_deg : {0.0, 180.0, 300.0, 225.0, 200.0}) {
    EXPECT_GT(Meet(DegToRad(course_deg), 0, 2), kSurvival.r_safe_m) << course_deg;
  }
}

struct Followed {
  double nearest_m = 1e9;
  double x_m = 0;  ///< At the end.
};

/// A follower whose leader goes straight over the wreck.
Followed FollowPastWreck(double off_m, double current_mps, const SurvivalSonarLayer& sonar,
                         bool speed_along_bow = true) {
  SeaAround sea = {.current_mps = {0, current_mps, 0}};
  sea.wrecks = {{.position_m = {kWreck_m, off_m, 20}}};
  TargetTrackTask task;
  task.track.law = VelocityCascade{
      {sonar, FormationLayer{.r_inner_m = 30, .r_follow_m = 50}, FeedForwardLayer{}}};
  task.speed_along_bow = speed_along_bow;
  CarefulAuv auv(1, task, {0, 0, 20}, kPi / 2, 1.5, sea);
  Followed followed;
  for (int i = 0; i < 4000; ++i) {
    const double lead_m = 60 + 1.5 * i * CarefulAuv::kStep_s;
    auv.Step({{.id = 0, .position_m = {lead_m, 0, 20}, .velocity_mps = {1.5, 0, 0}}}, true);
    followed.nearest_m = std::min(followed.nearest_m,
                                  (auv.neighbour().position_m - sea.wrecks[0].position_m).norm());
  }
  followed.x_m = auv.neighbour().position_m.x();
  return followed;
}

TEST(AFollower, PassesAWreckAtMoreThanThreeMetres) {
  for (const double off_m : {0.0, 2.0, 10.0}) {
    for (const double current_mps : {0.0, 0.4}) {
      const Followed followed = FollowPastWreck(off_m, current_mps, kSonar);
      EXPECT_GT(followed.nearest_m, 5) << off_m << " " << current_mps;
      EXPECT_GT(followed.x_m, 270) << "it has gone on after its leader";
    }
  }
}

TEST(AFollower, WithoutTheSidestepWaitsBeforeAWreckThatItWouldElseHit) {
  EXPECT_GT(FollowPastWreck(0, 0, SurvivalSonarLayer{}).nearest_m, 5);
  EXPECT_LT(FollowPastWreck(0, 0, SurvivalSonarLayer{}, /*speed_along_bow=*/false).nearest_m, 1.6);
}

// Weights again, from what the vehicle knows and not from the cascade.
TEST(Weights, AreThoseOfTheSpecificationAllTheWayPastAWreck) {
  SeaAround sea;
  sea.wrecks = {{.position_m = {kWreck_m, 0, 20}}};
  PathFollowTask task = Path({{0, 0, 20}, {600, 0, 20}}, 1.5, {kSurvival, kSonar});
  task.cascade.alpha = 0.8;
  CarefulAuv auv(1, task, {0, 0, 20}, kPi / 2, 1.5, sea);
  const std::vector<Neighbour> others = {{.id = 2, .position_m = {100, 30, 20}}};
  double least = 1;
  while (auv.neighbour().position_m.x() < kWreck_m + 50) {
    auv.Step(others);
    const auto& layers = auv.guidance().layers;
    ASSERT_EQ(layers.size(), 3u);
    const double u_max_mps = task.u_max_mps;
    const double s_0 = LayerVelocity(kSurvival, u_max_mps, auv.surroundings()).norm() / u_max_mps;
    const double s_1 = LayerVelocity(kSonar, u_max_mps, auv.surroundings()).norm() / u_max_mps;
    EXPECT_NEAR(layers[0].weight, 0.8, 1e-12);
    EXPECT_NEAR(layers[1].weight, 1 - 0.8 * s_0, 1e-12);
    EXPECT_NEAR(layers[2].weight, (1 - 0.8 * s_0) * (1 - s_1), 1e-12);
    least = std::min(least, layers[2].weight);
  }
  EXPECT_LT(least, 0.7) << "the layers were at work";
}

}  // namespace shoal::layers_test
