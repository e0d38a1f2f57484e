#include "lib/vehicle/guidance/path_follower.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::path_follower_test {

constexpr double kStep_s = 0.1;

// Turns, dives and speeds up at limited rates; a current carries it along.
struct KinematicVehicle {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double psi_rad = 0;
  double speed_mps = 0;
  Eigen::Vector3d current_mps = Eigen::Vector3d::Zero();

  void Step(const PathGuidance& guidance) {
    psi_rad = WrapPi(psi_rad + std::clamp(WrapPi(guidance.psi_ref_rad - psi_rad), -0.03, 0.03));
    speed_mps += std::clamp(guidance.speed_mps - speed_mps, -0.02, 0.02);
    const double climb_mps =
        std::clamp(guidance.z_m - position_m.z(), -0.3 * speed_mps, 0.3 * speed_mps);
    position_m += (current_mps + Eigen::Vector3d(speed_mps * std::cos(psi_rad),
                                                 speed_mps * std::sin(psi_rad), climb_mps)) *
                  kStep_s;
  }
};

PathGuidance Travel(
    PathFollower& follower, KinematicVehicle& vehicle, double duration_s,
    const std::function<void(const PathGuidance&)>& watch = [](const PathGuidance&) {}) {
  PathGuidance guidance;
  for (double time_s = 0; time_s < duration_s; time_s += kStep_s) {
    guidance = follower.Update(vehicle.position_m, kStep_s);
    watch(guidance);
    vehicle.Step(guidance);
  }
  return guidance;
}

WaypointPath Line(double length_m) { return {{{0, 0, 10}, {length_m, 0, 10}}}; }
const WaypointPath kSquare{{{0, 0, 10}, {200, 0, 20}, {200, 200, 30}, {0, 200, 20}}};

TEST(PathFollower, KeepsToItsPathAndKnowsTheCrabAngleInACrossCurrent) {
  for (const double current_mps : {0.5, -0.5}) {
    PathFollower follower({.path = Line(5000)}, {0, 0, 10});
    KinematicVehicle vehicle{.position_m = {0, 5, 10}, .current_mps = {0, current_mps, 0}};
    Travel(follower, vehicle, 1200);
    const double crab_rad = std::asin(current_mps / vehicle.speed_mps);
    Travel(follower, vehicle, 600, [&](const PathGuidance& guidance) {
      EXPECT_LT(std::abs(guidance.y_e_m), 1);
      EXPECT_LT(std::abs(guidance.crab_rad - crab_rad), DegToRad(1));
    });
  }
}

TEST(PathFollower, KnowsTheCrabAngleByTheBareLawToo) {
  PathFollower follower({.path = Line(5000), .guard_crab = false}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}, .current_mps = {0, 0.5, 0}};
  const PathGuidance guidance = Travel(follower, vehicle, 1500);
  EXPECT_LT(std::abs(guidance.y_e_m), 1);
  EXPECT_NEAR(guidance.crab_rad, std::asin(0.5 / 2), DegToRad(1));
}

TEST(PathFollower, PassesTheWaypointsOfASquareInTurn) {
  PathFollower follower({.path = kSquare}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}, .current_mps = {0.2, 0.3, 0}};
  std::vector<size_t> sequence;
  const PathGuidance last = Travel(follower, vehicle, 600, [&](const PathGuidance& guidance) {
    if (sequence.empty() || sequence.back() != guidance.next) sequence.push_back(guidance.next);
    EXPECT_EQ(guidance.z_m, kSquare.points_m[std::min<size_t>(guidance.next, 3)].z());
  });
  EXPECT_EQ(sequence, (std::vector<size_t>{1, 2, 3, 4}));
  EXPECT_TRUE(last.done);
}

TEST(PathFollower, GlidesDownASlopeToTheWaypointAndThenUp) {
  const WaypointPath vee{{{0, 0, 10}, {100, 0, 30}, {200, 0, 10}}};
  PathFollower follower({.path = vee, .depth_rule = DepthRule::kSlope, .depth_lead_s = 5},
                        {0, 0, 10});
  const auto at = [&](double x_m) { return follower.Update({x_m, 0, 10}, kStep_s); };
  EXPECT_DOUBLE_EQ(at(50).z_m, 20);
  EXPECT_DOUBLE_EQ(*at(50).slope, 0.2);
  EXPECT_DOUBLE_EQ(*at(89).slope, 0.2);
  EXPECT_DOUBLE_EQ(*at(91).slope, -0.2) << "five seconds from here";
  const PathGuidance left_early = at(95);
  EXPECT_EQ(left_early.next, 2U) << "within R of the waypoint";
  EXPECT_DOUBLE_EQ(left_early.z_m, 29) << "the leg before glides on to it";
  EXPECT_DOUBLE_EQ(at(150).z_m, 20);
  EXPECT_EQ(*at(195).slope, 0) << "level past the end";
}

TEST(PathFollower, KnowsNoSlopeWithTheDepthOfTheNextWaypoint) {
  PathFollower follower({.path = kSquare}, {0, 0, 10});
  EXPECT_FALSE(follower.Update({50, 0, 10}, kStep_s).slope.has_value());
}

TEST(PathFollower, FliesToItsFirstWaypointUnlessItIsNotToApproach) {
  PathFollower follower({.path = kSquare}, {0, -300, 10});
  const PathGuidance guidance = follower.Update({0, -300, 10}, kStep_s);
  EXPECT_EQ(guidance.next, 0U);
  EXPECT_NEAR(guidance.psi_ref_rad, kPi / 2, 1e-9);
  EXPECT_EQ(guidance.z_m, kSquare.points_m[0].z());
  PathFollower munet({.path = kSquare, .approach = false}, {0, -300, 10});
  EXPECT_EQ(munet.Update({0, -300, 10}, kStep_s).next, 1U);
}

TEST(PathFollower, GoesOnOnTheLastCourseAndDepth) {
  PathFollower follower({.path = kSquare, .end = PathEnd::kGoOn}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}};
  const PathGuidance guidance = Travel(follower, vehicle, 1200);
  EXPECT_TRUE(guidance.done);
  EXPECT_LT(vehicle.position_m.x(), -500);
  EXPECT_NEAR(vehicle.position_m.y(), 200, 1);
  EXPECT_NEAR(vehicle.position_m.z(), 20, 0.1);
  EXPECT_NEAR(guidance.next_m.x(), vehicle.position_m.x() - kOpenEnd_m, 1);
}

TEST(PathFollower, HoldsAtTheLastWaypointAgainstACurrent) {
  PathFollower follower({.path = kSquare, .end = PathEnd::kHold}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}, .current_mps = {0.3, 0, 0}};
  EXPECT_TRUE(Travel(follower, vehicle, 600).done);
  bool stood = false;
  bool came_back = false;
  Travel(follower, vehicle, 1200, [&](const PathGuidance& guidance) {
    stood = stood || guidance.speed_mps == 0;
    came_back = came_back || (stood && guidance.speed_mps > 0);
    EXPECT_LT((vehicle.position_m - kSquare.points_m.back()).head<2>().norm(), 45);
    EXPECT_EQ(guidance.z_m, 20);
  });
  EXPECT_TRUE(stood);
  EXPECT_TRUE(came_back);
}

TEST(PathFollower, FollowsThePathAgainWhereItReturnsToTheFirst) {
  PathFollower follower({.path = kSquare, .end = PathEnd::kReturnToFirst}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}};
  std::vector<size_t> sequence;
  const PathGuidance last = Travel(follower, vehicle, 1000, [&](const PathGuidance& guidance) {
    if (sequence.empty() || sequence.back() != guidance.next) sequence.push_back(guidance.next);
  });
  ASSERT_GE(sequence.size(), 6U);
  sequence.resize(6);
  EXPECT_EQ(sequence, (std::vector<size_t>{1, 2, 3, 0, 1, 2}));
  EXPECT_EQ(last.laps_done, 2);
  EXPECT_FALSE(last.done);
}

TEST(PathFollower, SurfacesOnTheLastCourseAndStopsThere) {
  PathFollower follower({.path = Line(100), .end = PathEnd::kSurface}, {0, 0, 10});
  KinematicVehicle vehicle{.position_m = {0, 0, 10}};
  const PathGuidance guidance = Travel(follower, vehicle, 200);
  EXPECT_TRUE(guidance.done);
  EXPECT_EQ(guidance.speed_mps, 0);
  EXPECT_EQ(guidance.z_m, 0);
  EXPECT_LT(vehicle.position_m.z(), 1);
  EXPECT_NEAR(vehicle.position_m.y(), 0, 0.1);
  EXPECT_EQ(vehicle.speed_mps, 0);
}

TEST(PathFollower, OfASingleWaypointGoesThereAndHolds) {
  for (const PathEnd end : {PathEnd::kHold, PathEnd::kReturnToFirst}) {
    PathFollower follower({.path = {{{50, 50, 15}}}, .end = end}, {0, 0, 0});
    KinematicVehicle vehicle;
    EXPECT_EQ(follower.Update(vehicle.position_m, kStep_s).next, 0U);
    EXPECT_TRUE(Travel(follower, vehicle, 120).done);
    EXPECT_LT((vehicle.position_m - Eigen::Vector3d(50, 50, 15)).norm(), 30);
  }
}

TEST(PathFollower, TurnsTheCrabAngleWithThePathOrLetsItBe) {
  for (const bool turns : {true, false}) {
    PathFollower follower({.path = {{{0, 0, 0}, {3000, 0, 0}, {3000, 900, 0}}}, .turn_crab = turns},
                          {0, 0, 0});
    KinematicVehicle vehicle{.current_mps = {0, 0.4, 0}};
    PathGuidance guidance;
    double crab_before_rad = 0;
    while (guidance.next < 2) {
      crab_before_rad = guidance.crab_rad;
      guidance = follower.Update(vehicle.position_m, kStep_s);
      vehicle.Step(guidance);
    }
    EXPECT_GT(crab_before_rad, 0.15);
    EXPECT_NEAR(guidance.crab_rad, turns ? 0 : crab_before_rad, 0.01);
  }
}

TEST(PathFollower, SharesNothingWithItsCopy) {
  PathFollower one({.path = kSquare}, {0, 0, 10});
  PathFollower other = one;
  KinematicVehicle vehicle{.current_mps = {0, 0.4, 0}};
  Travel(one, vehicle, 300);
  EXPECT_EQ(other.progress().previous, 0U);
  EXPECT_EQ(other.Update({0, 0, 0}, kStep_s).crab_rad, 0);
}

TEST(PathFollower, RefusesWhatIsNoPosition) {
  PathFollower follower({.path = kSquare}, {0, 0, 10});
  EXPECT_DEATH(follower.Update({0, std::nan(""), 0}, kStep_s), "inputs of guidance are finite");
}

RC_GTEST_PROP(PathFollower, GivesFiniteGuidanceForAnyPathAndPosition, ()) {
  PathFollowParams params{.end = *rc::gen::element(PathEnd::kGoOn, PathEnd::kHold,
                                                   PathEnd::kReturnToFirst, PathEnd::kSurface)};
  params.waypoint_switch.rule =
      *rc::gen::element(SwitchRule::kCircleOrPassedLine, SwitchRule::kCircle,
                        SwitchRule::kPassedLine, SwitchRule::kAlongTrack);
  params.guard_crab = *rc::gen::inRange(0, 2) == 0;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    params.path.points_m.push_back(AnyFiniteVector());
  }
  PathFollower follower(params, AnyFiniteVector());
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d position_m =
        i % 3 == 0 ? params.path.points_m.front() : AnyFiniteVector();
    const PathGuidance guidance = follower.Update(position_m, DrawBetween(0, 10));
    RC_ASSERT(std::isfinite(guidance.psi_ref_rad));
    RC_ASSERT(std::abs(guidance.psi_ref_rad) <= kPi);
    RC_ASSERT(std::isfinite(guidance.z_m));
    RC_ASSERT(std::isfinite(guidance.y_e_m));
    RC_ASSERT(std::isfinite(guidance.crab_rad));
    RC_ASSERT(guidance.next_m.allFinite());
    RC_ASSERT(guidance.speed_mps >= 0 && guidance.speed_mps <= params.speed_mps);
    RC_ASSERT(guidance.next <= params.path.points_m.size());
  }
}

}  // namespace shoal::path_follower_test
