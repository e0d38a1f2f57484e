#include "lib/base/geometry/angles.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"

namespace shoal {

namespace {

// Returns `angle` modulo `turn` in [0, turn). Adding a turn to a tiny negative angle rounds to a
// whole turn, and -0.0 would print as "-0": both become 0.
double WrapPositive(double angle, double turn) {
  double wrapped = std::fmod(angle, turn);
  if (wrapped < 0) wrapped += turn;
  return wrapped >= turn ? 0.0 : wrapped + 0.0;
}

// Returns `angle` modulo `turn` in (-turn / 2, turn / 2].
double WrapSymmetric(double angle, double turn) {
  const double wrapped = std::remainder(angle, turn);
  return wrapped <= -turn / 2 ? turn / 2 : wrapped + 0.0;
}

}  // namespace

double WrapTwoPi(double angle_rad) { return WrapPositive(angle_rad, 2 * kPi); }
double WrapPi(double angle_rad) { return WrapSymmetric(angle_rad, 2 * kPi); }
double Wrap360(double angle_deg) { return WrapPositive(angle_deg, 360); }
double Wrap180(double angle_deg) { return WrapSymmetric(angle_deg, 360); }

Eigen::Vector2d UnitVector(double heading_rad) {
  const auto [sine, cosine] = SinCos(heading_rad);
  return {sine, cosine};
}

double HeadingOf(const Eigen::Vector2d& vector) {
  if (vector.x() == 0 && vector.y() == 0) return 0;
  return WrapTwoPi(Atan2(vector.x(), vector.y()));
}

double PsiFromHeading(double heading_rad) { return WrapPi(kPi / 2 - heading_rad); }
double HeadingFromPsi(double psi_rad) { return WrapTwoPi(kPi / 2 - psi_rad); }

}  // namespace shoal
