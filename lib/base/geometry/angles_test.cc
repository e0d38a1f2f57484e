#include "lib/base/geometry/angles.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace shoal::angles_test {

double AnyAngle() { return *rc::gen::inRange(-1'000'000, 1'000'001) / 1000.0; }

TEST(WrapTwoPi, KeepsZeroAndTakesAWholeTurnToZero) {
  EXPECT_EQ(WrapTwoPi(0), 0);
  EXPECT_EQ(WrapTwoPi(2 * kPi), 0);
  EXPECT_DOUBLE_EQ(WrapTwoPi(-kPi / 2), 3 * kPi / 2);
}

TEST(WrapTwoPi, NeverReturnsAWholeTurnForATinyNegativeAngle) {
  EXPECT_LT(WrapTwoPi(-1e-20), 2 * kPi);
  EXPECT_LT(Wrap360(-1e-20), 360);
}

TEST(WrapTwoPi, HasNoNegativeZero) {
  EXPECT_FALSE(std::signbit(WrapTwoPi(-0.0)));
  EXPECT_FALSE(std::signbit(Wrap360(-360.0)));
  EXPECT_FALSE(std::signbit(Wrap180(-0.0)));
}

TEST(WrapPi, TakesBothEndsToPlusPi) {
  EXPECT_EQ(WrapPi(kPi), kPi);
  EXPECT_EQ(WrapPi(-kPi), kPi);
  EXPECT_EQ(Wrap180(-180), 180);
  EXPECT_EQ(Wrap180(540), 180);
}

TEST(WrapPi, GivesNanForWhatIsNoAngle) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(WrapPi(bad)));
    EXPECT_TRUE(std::isnan(WrapTwoPi(bad)));
  }
}

TEST(Heading, PointsEastAtNinetyDegrees) {
  EXPECT_NEAR(UnitVector(DegToRad(90)).x(), 1, 1e-15);
  EXPECT_NEAR(UnitVector(0).y(), 1, 1e-15);
  EXPECT_NEAR(RadToDeg(HeadingOf({-3, 0})), 270, 1e-12);
  EXPECT_EQ(HeadingOf({0, 0}), 0);
}

TEST(Psi, IsZeroTowardEastAndHalfPiTowardNorth) {
  EXPECT_NEAR(PsiFromHeading(DegToRad(90)), 0, 1e-15);
  EXPECT_NEAR(PsiFromHeading(0), kPi / 2, 1e-15);
  EXPECT_NEAR(PsiFromHeading(DegToRad(270)), kPi, 1e-15);
}

RC_GTEST_PROP(Wrap, StaysInRangeAndKeepsTheDirection, ()) {
  const double angle = AnyAngle();
  RC_ASSERT(WrapTwoPi(angle) >= 0);
  RC_ASSERT(WrapTwoPi(angle) < 2 * kPi);
  RC_ASSERT(WrapPi(angle) > -kPi);
  RC_ASSERT(WrapPi(angle) <= kPi);
  RC_ASSERT((UnitVector(WrapTwoPi(angle)) - UnitVector(angle)).norm() < 1e-9);
  RC_ASSERT((UnitVector(WrapPi(angle)) - UnitVector(angle)).norm() < 1e-9);
  RC_ASSERT(std::abs(RadToDeg(WrapPi(DegToRad(Wrap180(angle)))) - Wrap180(angle)) < 1e-9);
}

RC_GTEST_PROP(Heading, IsTheInverseOfItsUnitVector, ()) {
  const double heading = WrapTwoPi(AnyAngle());
  RC_ASSERT(std::abs(WrapPi(HeadingOf(UnitVector(heading)) - heading)) < 1e-12);
}

RC_GTEST_PROP(Psi, DescribesTheSameVectorAsTheHeading, ()) {
  const double heading = AnyAngle();
  const double psi = PsiFromHeading(heading);
  const Eigen::Vector2d by_psi(std::cos(psi), std::sin(psi));
  RC_ASSERT((by_psi - UnitVector(heading)).norm() < 1e-9);
  RC_ASSERT(std::abs(WrapPi(HeadingFromPsi(psi) - heading)) < 1e-9);
}

}  // namespace shoal::angles_test
