#include "lib/vehicle/guidance/alos.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/leg.h"

namespace shoal::alos_test {

constexpr double kStep_s = 0.1;

// A vessel that takes the desired heading at once; returns its position after `duration_s` along
// `leg`.
Eigen::Vector2d Follow(Alos& alos, const Leg& leg, Eigen::Vector2d position_m, double speed_mps,
                       const Eigen::Vector2d& current_mps, double duration_s) {
  for (double time_s = 0; time_s < duration_s; time_s += kStep_s) {
    const double heading_rad =
        alos.Update(Course(leg), Project(leg, position_m).cross_track_m, kStep_s);
    position_m += (speed_mps * UnitVector(heading_rad) + current_mps) * kStep_s;
  }
  return position_m;
}

TEST(Alos, SteersAlongThePathWhenItIsOnIt) {
  Alos alos({.lookahead_m = 15, .crab_gain = 0.005});
  EXPECT_DOUBLE_EQ(alos.Update(1.0, 0, kStep_s), 1.0);
}

TEST(Alos, SteersToPortWhenItIsToStarboardOfThePath) {
  Alos alos({.lookahead_m = 10, .crab_gain = 0});
  EXPECT_NEAR(alos.Update(1.0, 10, kStep_s), 1.0 - kPi / 4, 1e-12);
  EXPECT_NEAR(alos.Update(1.0, -10, kStep_s), 1.0 + kPi / 4, 1e-12);
  EXPECT_NEAR(alos.Update(1.0, 1e9, kStep_s), 1.0 - kPi / 2, 1e-6);
}

TEST(Alos, AdaptsAtTheRateOfFossen) {
  Alos alos({.lookahead_m = 15, .crab_gain = 0.005});
  alos.Update(0, 8, 0.1);
  EXPECT_NEAR(alos.crab_rad(), 0.1 * 0.005 * 15 * 8 / 17, 1e-12);
}

TEST(Alos, ReturnsWrappedHeadings) {
  Alos alos({.lookahead_m = 10, .crab_gain = 0});
  EXPECT_NEAR(alos.Update(DegToRad(170), -10, kStep_s), DegToRad(-145), 1e-12);
}

TEST(Alos, LeavesNoCrossTrackErrorInACrossCurrentWherePlainLineOfSightLeavesFourMetres) {
  const Leg leg{.from_m = {0, 0}, .to_m = {0, 1000}};
  const Eigen::Vector2d current_mps(0.4, 0);
  Alos plain({.lookahead_m = 15, .crab_gain = 0});
  const double plain_error_m =
      Project(leg, Follow(plain, leg, {0, 0}, 1.5, current_mps, 300)).cross_track_m;
  EXPECT_NEAR(plain_error_m, 15 * std::tan(std::asin(0.4 / 1.5)), 0.01);

  Alos adaptive({.lookahead_m = 15, .crab_gain = 0.005});
  const double error_m =
      Project(leg, Follow(adaptive, leg, {0, 0}, 1.5, current_mps, 150)).cross_track_m;
  EXPECT_LT(std::abs(error_m), 0.1);
  EXPECT_NEAR(adaptive.crab_rad(), std::asin(0.4 / 1.5), 0.01);
}

TEST(Alos, KnowsTheCrabAngleOfTheWayBack) {
  const Eigen::Vector2d current_mps(0.4, 0);
  Alos alos({.lookahead_m = 15, .crab_gain = 0.005});
  Follow(alos, {.from_m = {0, 0}, .to_m = {0, 500}}, {0, 0}, 1.5, current_mps, 300);
  alos.TurnBy(kPi);
  EXPECT_NEAR(alos.crab_rad(), -std::asin(0.4 / 1.5), 0.01);
  alos.TurnBy(kPi / 2);
  EXPECT_NEAR(alos.crab_rad(), 0, 1e-12);
}

TEST(Alos, DoesNotWindUpOnALongApproach) {
  Alos alos({.lookahead_m = 15, .crab_gain = 0.005});
  for (int i = 0; i < 10'000; ++i) alos.Update(0, 200, kStep_s);
  EXPECT_EQ(alos.crab_rad(), 0);
  for (int i = 0; i < 10'000; ++i) alos.Update(0, 15, kStep_s);
  EXPECT_EQ(alos.crab_rad(), Alos::kMaxCrab_rad);
}

RC_GTEST_PROP(Alos, MirrorsForTheMirroredError, ()) {
  Alos one({});
  Alos other({});
  for (int i = 0; i < 20; ++i) {
    const double cross_track_m = *rc::gen::inRange(-300, 301) / 10.0;
    const double heading_rad = one.Update(0, cross_track_m, kStep_s);
    RC_ASSERT(std::abs(heading_rad + other.Update(0, -cross_track_m, kStep_s)) < 1e-12);
  }
}

// In the guidance frame (psi from East toward North) errors are positive to port; the law is the
// same, and so must be the track.
RC_GTEST_PROP(Alos, HoldsInTheGuidanceFrameAsInTheCompassFrame, ()) {
  Alos compass({});
  Alos guidance({});
  const double course_rad = *rc::gen::inRange(0, 628) / 100.0;
  for (int i = 0; i < 20; ++i) {
    const double to_starboard_m = *rc::gen::inRange(-300, 301) / 10.0;
    const double heading_rad = compass.Update(course_rad, to_starboard_m, kStep_s);
    const double psi_rad = guidance.Update(PsiFromHeading(course_rad), -to_starboard_m, kStep_s);
    RC_ASSERT(std::abs(WrapPi(HeadingFromPsi(psi_rad) - heading_rad)) < 1e-9);
  }
}

}  // namespace shoal::alos_test
