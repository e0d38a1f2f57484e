#include "lib/vehicle/guidance/path_progress.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::path_progress_test {

const WaypointPath kPath{{{0, 0, 10}, {100, 0, 20}, {100, 80, 30}}};
const WaypointSwitch kDefault;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

PathLeg FirstLeg(const Eigen::Vector3d& position_m = Eigen::Vector3d::Zero()) {
  return CurrentLeg(kPath, PathEnd::kGoOn, {}, position_m);
}

TEST(WaypointSwitch, HappensInsideTheCircle) {
  EXPECT_FALSE(IsReached(kDefault, FirstLeg(), {89.9, 0, 0}));
  EXPECT_TRUE(IsReached(kDefault, FirstLeg(), {90.1, 0, 0}));
  EXPECT_TRUE(IsReached(kDefault, FirstLeg(), {94, 7, 99}));
  EXPECT_FALSE(IsReached(kDefault, FirstLeg(), {94, 9, 20}));
}

TEST(WaypointSwitch, HappensPastTheLineThroughTheWaypoint) {
  EXPECT_FALSE(IsReached(kDefault, FirstLeg(), {99.9, 40, 20}));
  EXPECT_TRUE(IsReached(kDefault, FirstLeg(), {100.1, 40, 20}));
}

TEST(WaypointSwitch, HappensPastTheLineOnlyNearTheLeg) {
  EXPECT_TRUE(IsReached(kDefault, FirstLeg(), {101, 49.9, 20}));
  EXPECT_FALSE(IsReached(kDefault, FirstLeg(), {101, 50.1, 20}));
  EXPECT_FALSE(IsReached({.rule = SwitchRule::kPassedLine, .passed_line_within_m = 5}, FirstLeg(),
                         {101, -5.1, 20}));
  EXPECT_TRUE(IsReached({.rule = SwitchRule::kAlongTrack}, FirstLeg(), {101, 300, 20}));
}

TEST(WaypointSwitch, HappensAtHalfOfAShortLegOfACurve) {
  const PathLeg chord{.from_m = {0, 0, 0}, .to_m = {8, 0, 0}, .length_m = 8};
  const WaypointSwitch curve{.is_within_leg = true};
  EXPECT_FALSE(IsReached(curve, chord, {3.9, 0, 0}));
  EXPECT_TRUE(IsReached(curve, chord, {4.1, 0, 0}));
  EXPECT_TRUE(IsReached(kDefault, chord, {0, 0, 0}));
  EXPECT_TRUE(IsReached({.rule = SwitchRule::kCircle, .is_within_leg = true}, chord, {0, 0, 0}));
}

TEST(PathProgress, BeginsWithAnApproachWhereTheFirstWaypointIsFar) {
  PathProgress progress = BeginPath(kPath, {0, -40, 5}, 10);
  EXPECT_TRUE(progress.approaches);
  const PathLeg approach = CurrentLeg(kPath, PathEnd::kGoOn, progress, {0, -40, 5});
  EXPECT_EQ(approach.from_m, Eigen::Vector3d(0, -40, 5));
  EXPECT_EQ(approach.to_m, kPath.points_m[0]);
  EXPECT_NEAR(approach.psi_rad, kPi / 2, 1e-15);
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {0, -11, 5});
  EXPECT_TRUE(progress.approaches);
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {0, -9, 5});
  EXPECT_FALSE(progress.approaches);
  EXPECT_EQ(progress.previous, 0U);
  EXPECT_FALSE(BeginPath(kPath, {0, -9, 99}, 10).approaches) << "depth does not count";
}

TEST(PathLeg, HasADepthAbeamOfTheVehicleAndASlope) {
  EXPECT_EQ(DepthOn(FirstLeg(), {50, 30, 99}), 15);
  EXPECT_EQ(DepthOn(FirstLeg(), {-20, 0, 0}), 10);
  EXPECT_EQ(DepthOn(FirstLeg(), {120, 0, 0}), 20);
  EXPECT_DOUBLE_EQ(SlopeOf(FirstLeg()), 0.1);
  EXPECT_EQ(SlopeOf({.from_m = {0, 0, 5}, .to_m = {0, 0, 9}}), 0);
  EXPECT_EQ(DepthOn({.from_m = {0, 0, 5}, .to_m = {0, 0, 9}}, {3, 0, 0}), 9);
}

TEST(WaypointSwitch, KeepsToTheOneCriterionThatARuleNames) {
  const auto reached = [](SwitchRule rule, const Eigen::Vector3d& position_m) {
    return IsReached({.rule = rule, .acceptance_radius_m = 10}, FirstLeg(), position_m);
  };
  EXPECT_TRUE(reached(SwitchRule::kCircle, {95, 0, 0}));
  EXPECT_FALSE(reached(SwitchRule::kCircle, {120, 40, 0}));
  EXPECT_FALSE(reached(SwitchRule::kPassedLine, {95, 0, 0}));
  EXPECT_TRUE(reached(SwitchRule::kPassedLine, {120, 40, 0}));
  EXPECT_TRUE(reached(SwitchRule::kAlongTrack, {91, 200, 0}));
  EXPECT_FALSE(reached(SwitchRule::kAlongTrack, {89, 0, 0}));
}

TEST(PathProgress, GoesFromLegToLegAndEnds) {
  PathProgress progress;
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {50, 0, 10});
  EXPECT_EQ(progress.previous, 0U);
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {95, 0, 10});
  EXPECT_EQ(progress.previous, 1U);
  EXPECT_FALSE(progress.ended);
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {100, 75, 10});
  EXPECT_EQ(progress.previous, 2U);
  EXPECT_TRUE(progress.ended);
  progress = Advance(kPath, kDefault, PathEnd::kGoOn, progress, {0, 0, 10});
  EXPECT_EQ(progress.previous, 2U);
}

TEST(PathProgress, GoesRoundWhereItReturnsToTheFirst) {
  PathProgress progress{.previous = 1};
  const auto advance = [&](const Eigen::Vector3d& position_m) {
    progress = Advance(kPath, kDefault, PathEnd::kReturnToFirst, progress, position_m);
  };
  advance({100, 80, 30});
  EXPECT_FALSE(progress.ended);
  const PathLeg home = CurrentLeg(kPath, PathEnd::kReturnToFirst, progress, {100, 80, 30});
  EXPECT_EQ(home.to_m, kPath.points_m[0]);
  EXPECT_NEAR(home.psi_rad, std::atan2(-80, -100), 1e-15);
  advance({0, 0, 30});
  EXPECT_EQ(progress.previous, 0U);
  EXPECT_EQ(progress.laps_done, 1);
}

TEST(PathLeg, GoesOnAheadOfTheVehiclePastTheEnd) {
  const PathProgress ended{.previous = 2, .ended = true};
  const PathLeg leg = CurrentLeg(kPath, PathEnd::kGoOn, ended, {103, 5080, 30});
  EXPECT_NEAR(leg.psi_rad, kPi / 2, 1e-15);
  EXPECT_NEAR((leg.to_m - Eigen::Vector3d(100, 6080, 30)).norm(), 0, 1e-9);
  EXPECT_NEAR(ErrorsOn(leg, {103, 5080, 30}).y_e_m, -3, 1e-12);
}

TEST(PathLeg, OfASingleWaypointBeginsAtTheStart) {
  const WaypointPath path{{{30, 40, 5}}};
  PathProgress progress{.start_m = {0, 40, 0}};
  const PathLeg leg = CurrentLeg(path, PathEnd::kGoOn, progress, {0, 40, 0});
  EXPECT_EQ(leg.length_m, 30);
  EXPECT_EQ(leg.psi_rad, 0);
  progress = Advance(path, kDefault, PathEnd::kGoOn, progress, {25, 40, 5});
  EXPECT_TRUE(progress.ended);
  EXPECT_EQ(CurrentLeg(path, PathEnd::kGoOn, progress, {25, 40, 5}).psi_rad, 0);
}

TEST(PathLeg, OfASingleWaypointAtTheStartPointsEast) {
  const WaypointPath path{{{30, 40, 5}}};
  const PathProgress progress{.start_m = {30, 40, 0}};
  EXPECT_EQ(CurrentLeg(path, PathEnd::kGoOn, progress, {30, 40, 0}).psi_rad, 0);
  EXPECT_TRUE(Advance(path, kDefault, PathEnd::kGoOn, progress, {30, 40, 0}).ended);
}

TEST(PathLeg, WithoutHorizontalLengthKeepsTheCourseAndIsReachedAtItsPoint) {
  const WaypointPath dive{{{0, 0, 0}, {0, 60, 0}, {0, 60, 40}, {0, 60, 40}}};
  PathProgress progress{.previous = 1};
  const PathLeg vertical = CurrentLeg(dive, PathEnd::kGoOn, progress, {0, 55, 0});
  EXPECT_NEAR(vertical.psi_rad, kPi / 2, 1e-15);
  EXPECT_EQ(vertical.length_m, 0);
  EXPECT_FALSE(IsReached(kDefault, vertical, {40, 50, 0}));
  progress = Advance(dive, kDefault, PathEnd::kGoOn, progress, {0, 55, 0});
  EXPECT_EQ(progress.previous, 2U);
  EXPECT_NEAR(CurrentLeg(dive, PathEnd::kGoOn, progress, {0, 55, 0}).psi_rad, kPi / 2, 1e-15);
}

TEST(PathLeg, AtTheBeginningWithoutHorizontalLengthLooksAhead) {
  const WaypointPath dive{{{0, 0, 0}, {0, 0, 20}, {0, 60, 20}}};
  EXPECT_NEAR(CurrentLeg(dive, PathEnd::kGoOn, {}, {0, 0, 0}).psi_rad, kPi / 2, 1e-15);
}

TEST(PathLeg, RefusesAnEmptyPathAndWhatIsNoNumber) {
  EXPECT_DEATH((void)CurrentLeg({}, PathEnd::kGoOn, {}, {0, 0, 0}),
               "a path has at least one waypoint");
  EXPECT_DEATH((void)ErrorsOn(FirstLeg(), {kNan, 0, 0}), "inputs of guidance are finite");
  EXPECT_DEATH((void)CurrentLeg({{{kNan, 0, 0}}}, PathEnd::kGoOn, {}, {0, 0, 0}),
               "inputs of guidance are finite");
}

RC_GTEST_PROP(TrackErrors, AreThoseOfTheTurnedPath, ()) {
  const WaypointPath path{{VectorWithin(500), VectorWithin(500)}};
  const Eigen::Vector3d position_m = VectorWithin(500);
  const Eigen::Matrix3d turn = AboutZ(DrawBetween(-3, 3));
  const WaypointPath turned{{turn * path.points_m[0], turn * path.points_m[1]}};
  const TrackErrors errors = ErrorsOn(CurrentLeg(path, PathEnd::kGoOn, {}, position_m), position_m);
  const TrackErrors again =
      ErrorsOn(CurrentLeg(turned, PathEnd::kGoOn, {}, position_m), turn * position_m);
  RC_PRE((path.points_m[1] - path.points_m[0]).head<2>().norm() > 1);
  RC_ASSERT(std::abs(errors.x_e_m - again.x_e_m) < 1e-6);
  RC_ASSERT(std::abs(errors.y_e_m - again.y_e_m) < 1e-6);
}

}  // namespace shoal::path_progress_test
