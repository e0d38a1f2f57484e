#include "lib/sea/rays/ray_step.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/sea/rays/atanh_over_x.h"

namespace shoal {

namespace {

struct SincAndCosine {
  double sinc = 1;
  double cosine = 1;
};

/// Returns sin(x) / x and cos(x).
SincAndCosine SincAndCos(double x) {
  const double square = x * x;
  if (square < 4e-4) {
    constexpr double k3 = 1.0 / 6, k5 = 1.0 / 120, k7 = 1.0 / 5040;
    constexpr double k2 = 1.0 / 2, k4 = 1.0 / 24, k6 = 1.0 / 720, k8 = 1.0 / 40320;
    return {1 - square * (k3 - square * (k5 - square * k7)),
            1 - square * (k2 - square * (k4 - square * (k6 - square * k8)))};
  }
  const auto [sine, cosine] = SinCos(x);
  return {sine / x, cosine};
}

/// A step in water whose speed changes with depth alone: an arc of a circle, in closed form. With
/// the angle of the ray th = th0 - g xi s, chords are s sinc(turn / 2), the time is (atanh(sin th0)
/// - atanh(sin th1)) / g, and what the launch angle changes is integrated along the arc likewise.
RayState ArcOf(const RayState& ray, const SpeedCell& cell, double step_m) {
  const double c = cell.At(ray.at);
  const double g = cell.by_depth;
  const double xi = ray.slowness.x();
  const double cos0 = xi * c;
  const double sin0 = ray.slowness.y() * c;
  const double half_turn = g * xi * step_m / 2;
  const auto [sinc, cos_half] = SincAndCos(half_turn);
  const double sin_half = sinc * half_turn;
  const double cos_middle = cos0 * cos_half + sin0 * sin_half;
  const double sin_middle = sin0 * cos_half - cos0 * sin_half;
  const double cos1 = cos_middle * cos_half + sin_middle * sin_half;
  const double sin1 = sin_middle * cos_half - cos_middle * sin_half;
  const Eigen::Vector2d chord = step_m * sinc * Eigen::Vector2d(cos_middle, sin_middle);
  RayState next = ray;
  next.at += chord;
  const double c1 = cell.At(next.at);
  next.slowness = {xi, sin1 / c1};
  const double product = sin0 * sin1;
  const double rest = product > 0
                          ? (cos0 * cos0 + cos1 * cos1 - cos0 * cos0 * cos1 * cos1) / (1 + product)
                          : 1 - product;
  const double u = xi * chord.x() / rest;
  next.time_s += u * AtanhOverX(g * u);
  const double xi_slope = ray.slowness_slope.x();
  const double angle_slope = c * c * (xi * ray.slowness_slope.y() - ray.slowness.y() * xi_slope);
  const double relative = xi_slope / xi;
  next.at_slope.x() += -angle_slope * chord.y() + (step_m * cos1 - chord.x()) * relative;
  next.at_slope.y() += angle_slope * chord.x() - (chord.y() - step_m * sin1) * relative;
  const double angle_slope1 = angle_slope - g * step_m * xi_slope;
  next.slowness_slope.y() = (cos1 * angle_slope1 - sin1 * g * next.at_slope.y() / c1) / c1;
  return next;
}

}  // namespace

RayState RateOf(const RayState& ray, const SpeedCell& cell) {
  const double c = cell.At(ray.at);
  const Eigen::Vector2d gradient = cell.GradientAt(ray.at);
  const double inverse = 1 / c;
  const double square = inverse * inverse;
  const double c_slope = gradient.dot(ray.at_slope);
  const Eigen::Vector2d gradient_slope = {cell.by_both * ray.at_slope.y(),
                                          cell.by_both * ray.at_slope.x()};
  return {c * ray.slowness, -square * gradient, c_slope * ray.slowness + c * ray.slowness_slope,
          -square * gradient_slope + 2 * square * inverse * c_slope * gradient, inverse};
}

/// Butcher, J. C. (1964), On Runge-Kutta processes of high order, J. Austral. Math. Soc. 4,
/// 179-194: seven stages, sixth order.
RayState StepOf(const RayState& ray, const SpeedCell& cell, double step_m) {
  if (cell.IsLayered()) return ArcOf(ray, cell, step_m);
  const RayState a = RateOf(ray, cell);
  const double h = step_m;
  const auto rate_at = [&](const RayState& at) { return RateOf(at, cell); };
  const RayState b = rate_at(ray.Plus(a, h / 3));
  const RayState c = rate_at(ray.Plus(b, h * 2 / 3));
  const RayState d = rate_at(ray.Plus(a, h / 12).Plus(b, h / 3).Plus(c, -h / 12));
  const RayState e =
      rate_at(ray.Plus(a, -h / 16).Plus(b, h * 9 / 8).Plus(c, -h * 3 / 16).Plus(d, -h * 3 / 8));
  const RayState f =
      rate_at(ray.Plus(b, h * 9 / 8).Plus(c, -h * 3 / 8).Plus(d, -h * 3 / 4).Plus(e, h / 2));
  const RayState g = rate_at(ray.Plus(a, h * 9 / 44)
                                 .Plus(b, -h * 9 / 11)
                                 .Plus(c, h * 63 / 44)
                                 .Plus(d, h * 18 / 11)
                                 .Plus(f, -h * 16 / 11));
  return ray.Plus(a, h * 11 / 120)
      .Plus(c, h * 27 / 40)
      .Plus(d, h * 27 / 40)
      .Plus(e, -h * 4 / 15)
      .Plus(f, -h * 4 / 15)
      .Plus(g, h * 11 / 120);
}

}  // namespace shoal
