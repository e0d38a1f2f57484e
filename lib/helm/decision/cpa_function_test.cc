#include "lib/helm/decision/cpa_function.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/helm/colregs/encounter_geometry.h"
#include "lib/helm/decision/decision_testing.h"

namespace shoal::cpa_function_test {

TEST(UtilityOfCpa, StepsUpAtTheLowerDistanceAndGrowsToTheUpper) {
  const CpaUtility utility{.lo_m = 10, .hi_m = 60, .at_lo = 25};
  EXPECT_EQ(UtilityOfCpa(9.999, utility), 0);
  EXPECT_EQ(UtilityOfCpa(10, utility), 25);
  EXPECT_DOUBLE_EQ(UtilityOfCpa(30, utility), 55);
  EXPECT_EQ(UtilityOfCpa(60, utility), 100);
  EXPECT_EQ(UtilityOfCpa(1e9, utility), 100);
}

TEST(UtilityOfCpa, IsAStepWithoutASlope) {
  const CpaUtility step{.lo_m = 10, .hi_m = 10, .at_lo = 25};
  EXPECT_EQ(UtilityOfCpa(9.9, step), 0);
  EXPECT_EQ(UtilityOfCpa(10, step), 25);
  EXPECT_EQ(UtilityOfCpa(10.1, step), 100);
}

TEST(CpaGrid, HasTheDistancesOfACrossing) {
  // The contact is 100 m North and stands still; own ship at 2 m/s passes it at 100 sin(30).
  const CpaGrid still({0, 100}, {0, 0}, 120, {});
  EXPECT_NEAR(still.At(0, 20), 0, 1e-12);
  EXPECT_NEAR(still.At(30, 20), 50, 1e-12);
  EXPECT_NEAR(still.At(330, 20), 50, 1e-12);
  EXPECT_EQ(still.At(180, 20), 100);
  EXPECT_EQ(still.At(77, 0), 100);
  // 0.5 m/s toward it for 120 s: 40 m are left.
  EXPECT_NEAR(still.At(0, 5), 40, 1e-12);
  // The contact runs away as fast as own ship follows.
  EXPECT_EQ(CpaGrid({0, 100}, {0, 2}, 120, {}).At(0, 20), 100);
}

TEST(CpaGrid, MirrorsToTheLastBit) {
  const CpaGrid ahead({0, 60}, {0, -1.3}, 120, {});
  for (int course = 1; course < 180; ++course) {
    for (int speed = 0; speed <= 40; speed += 4) {
      ASSERT_EQ(ahead.At(course, speed), ahead.At(360 - course, speed)) << course;
    }
  }
}

RC_GTEST_PROP(CpaGrid, AgreesWithTheClosestApproachOfTwoVessels, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const TestContact contact = DrawContact(stream);
  const CpaGrid cpa = CpaOf(contact, domain);
  for (int i = 0; i < 50; ++i) {
    const int course = IntBetween(stream, 0, 359);
    const int speed = IntBetween(stream, 0, domain.speed_mps.count - 1);
    const Eigen::Vector2d own_mps =
        domain.speed_mps.At(speed) * UnitVector(DegToRad(static_cast<double>(course)));
    const double expected_m =
        ClosestApproach(contact.offset_m, contact.velocity_mps - own_mps, contact.horizon_s);
    RC_ASSERT(std::abs(cpa.At(course, speed) - expected_m) < 1e-9 * (1 + cpa.range_m()));
  }
}

RC_GTEST_PROP(CpaGrid, BoundsHoldEveryPointOfABox, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const CpaGrid cpa = CpaOf(DrawContact(stream), domain);
  for (int i = 0; i < 30; ++i) {
    const GridBox box = DrawBox(stream, domain);
    const auto bound = cpa.Bound(box);
    for (int course = box.first_course; course <= box.last_course; ++course) {
      for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
        RC_ASSERT(cpa.At(course, speed) >= bound.min);
        RC_ASSERT(cpa.At(course, speed) <= bound.max);
      }
    }
  }
}

RC_GTEST_PROP(CpaGrid, UpperBoundOfANarrowBoxIsThatOfACorner, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const CpaGrid cpa = CpaOf(DrawContact(stream), domain);
  GridBox box = DrawBox(stream, domain);
  box.last_course = std::min(box.first_course + 1, 359);
  double greatest_m = 0;
  for (const int course : {box.first_course, box.last_course}) {
    for (const int speed : {box.first_speed, box.last_speed}) {
      greatest_m = std::max(greatest_m, cpa.At(course, speed));
    }
  }
  RC_ASSERT(std::abs(cpa.Bound(box).max - greatest_m) < 1e-12 * (1 + cpa.range_m()));
}

TEST(CpaGrid, LowerBoundIsThatOfACornerBesideTheContact) {
  // Courses 30..34 at 2 m/s all pass a contact at rest in the North on one side.
  const CpaGrid cpa({0, 100}, {0, 0}, 120, {});
  const auto bound =
      cpa.Bound({.first_course = 30, .last_course = 34, .first_speed = 20, .last_speed = 20});
  EXPECT_NEAR(bound.min, 50, 1e-9);
  EXPECT_NEAR(bound.max, 100 * std::sin(DegToRad(34)), 0.05);
}

TEST(CpaGrid, LowerBoundKnowsThatTheTimeIsTooShort) {
  const CpaGrid cpa({0, 100}, {0, 0}, 10, {});
  const auto bound =
      cpa.Bound({.first_course = 10, .last_course = 12, .first_speed = 0, .last_speed = 20});
  EXPECT_GT(bound.min, 17);  // On one side: sin(10) of 100 m.
  const auto around =
      cpa.Bound({.first_course = 0, .last_course = 10, .first_speed = 0, .last_speed = 20});
  EXPECT_GE(around.min, 0);
  EXPECT_LE(around.min, 80);
}

RC_GTEST_PROP(CpaFunction, BoundsHoldEveryPointOfABox, ()) {
  Stream stream = AnyStream();
  const Domain domain = SmallDomain(stream);
  const CpaFunction function(CpaOf(DrawContact(stream), domain), DrawUtility(stream));
  for (int i = 0; i < 30; ++i) {
    const GridBox box = DrawBox(stream, domain);
    const auto bound = function.Bound(box);
    for (int course = box.first_course; course <= box.last_course; ++course) {
      for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
        RC_ASSERT(function.At(course, speed) >= bound.min);
        RC_ASSERT(function.At(course, speed) <= bound.max);
      }
    }
  }
}

}  // namespace shoal::cpa_function_test
