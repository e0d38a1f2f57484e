#include "lib/helm/decision/cpa_function.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

using Directions = std::array<Eigen::Vector2d, 720>;

/// Boxes that are wider are not looked at: the tangents of a wide arc meet far outside.
constexpr int kWidestBox_deg = 60;

/// Of the range: far more than CPA can be off by rounding.
constexpr double kRounding = 1e-13;

/// No speed; keeps a quotient finite.
constexpr double kTiny_m2ps2 = 1e-300;

/// Returns the sine of a number of half degrees, 0 to 180 (90 degrees), the same for angles that
/// mirror each other.
double SineOfQuadrant(int half_deg) {
  return half_deg <= 90 ? Sin(DegToRad(half_deg / 2.0)) : Cos(DegToRad((180 - half_deg) / 2.0));
}

Directions MakeDirections() {
  Directions directions;
  for (int i = 0; i < 720; ++i) {
    const int quadrant = i / 180;
    const double rising = SineOfQuadrant(i % 180);
    const double falling = SineOfQuadrant(180 - i % 180);
    const double sine = quadrant % 2 == 0 ? rising : falling;
    const double cosine = quadrant % 2 == 0 ? falling : rising;
    directions[static_cast<size_t>(i)] = {quadrant < 2 ? sine : -sine,
                                          quadrant % 3 == 0 ? cosine : -cosine};
  }
  return directions;
}

const Directions& HalfDegreeDirections() {
  static const Directions directions = MakeDirections();
  return directions;
}

}  // namespace

double UtilityOfCpa(double cpa_m, const CpaUtility& utility) {
  if (cpa_m < utility.lo_m) return 0;
  if (cpa_m > utility.hi_m) return 100;
  const double span_m = utility.hi_m - utility.lo_m;
  if (span_m <= 0) return utility.at_lo;
  return std::min(utility.at_lo + (100 - utility.at_lo) * ((cpa_m - utility.lo_m) / span_m), 100.0);
}

CourseSpeedFunction::Range UtilityOfCpa(const CourseSpeedFunction::Range& cpa_m,
                                        const CpaUtility& utility) {
  return {.min = UtilityOfCpa(cpa_m.min, utility), .max = UtilityOfCpa(cpa_m.max, utility)};
}

CpaGrid::CpaGrid(const Eigen::Vector2d& offset_m, const Eigen::Vector2d& contact_velocity_mps,
                 double horizon_s, const Domain& domain)
    : offset_x_m_(offset_m.x()),
      offset_y_m_(offset_m.y()),
      contact_x_mps_(contact_velocity_mps.x()),
      contact_y_mps_(contact_velocity_mps.y()),
      horizon_s_(horizon_s),
      first_mps_(domain.speed_mps.first),
      step_mps_(domain.speed_mps.step),
      range2_m2_(offset_x_m_ * offset_x_m_ + offset_y_m_ * offset_y_m_),
      range_m_(std::sqrt(range2_m2_)),
      directions_(&HalfDegreeDirections()) {}

double CpaGrid::At(int course, int speed) const {
  const Eigen::Vector2d& direction = DirectionOf(2 * course);
  const double own_mps = SpeedAt(speed);
  const double x_mps = contact_x_mps_ - own_mps * direction.x();
  const double y_mps = contact_y_mps_ - own_mps * direction.y();
  const double approach = -(offset_x_m_ * x_mps + offset_y_m_ * y_mps);
  const double speed2 = std::max(x_mps * x_mps + y_mps * y_mps, kTiny_m2ps2);
  const double time_s = std::min(std::max(approach / speed2, 0.0), horizon_s_);
  const double x_m = offset_x_m_ + x_mps * time_s;
  const double y_m = offset_y_m_ + y_mps * time_s;
  return std::sqrt(std::min(x_m * x_m + y_m * y_m, range2_m2_));
}

CourseSpeedFunction::Range CpaGrid::Bound(const GridBox& box) const {
  const int width_deg = box.last_course - box.first_course;
  if (width_deg > kWidestBox_deg) return {.min = 0, .max = range_m_};

  // Corners come in pairs, inner and outer; they are equal where the box has one speed.
  using Pair = Eigen::Array2d;
  const double slow_mps = SpeedAt(box.first_speed);
  const double fast_mps = SpeedAt(box.last_speed);
  const double tangent_mps = fast_mps / DirectionOf(width_deg).y();
  const Pair speeds_mps[3] = {{slow_mps, fast_mps}, {slow_mps, fast_mps}, {slow_mps, tangent_mps}};
  const int half_degrees[3] = {2 * box.first_course, 2 * box.last_course,
                               box.first_course + box.last_course};
  // Without grid points between its ends the arc has no tangents; one course has one pair.
  const int num_pairs = std::min(width_deg, 2) + 1;

  Pair most_approach = Pair::Constant(-kInfinity);
  Pair leftmost = Pair::Constant(kInfinity);  // Twice the areas that offset and velocity span.
  Pair rightmost = Pair::Constant(-kInfinity);
  Pair fastest2_m2ps2 = Pair::Zero();
  Pair greatest2_m2 = Pair::Zero();
  Pair least2_m2 = Pair::Constant(range2_m2_);  // Without horizon.
  for (int i = 0; i < num_pairs; ++i) {
    const Eigen::Vector2d& direction = DirectionOf(half_degrees[i]);
    const Pair x_mps = contact_x_mps_ - speeds_mps[i] * direction.x();
    const Pair y_mps = contact_y_mps_ - speeds_mps[i] * direction.y();
    const Pair approach = -(offset_x_m_ * x_mps + offset_y_m_ * y_mps);
    const Pair area = offset_x_m_ * y_mps - offset_y_m_ * x_mps;
    const Pair speed2 = (x_mps * x_mps + y_mps * y_mps).max(kTiny_m2ps2);
    const Pair closest_s = (approach / speed2).max(0.0);
    const Pair time_s = closest_s.min(horizon_s_);
    const Pair x_m = offset_x_m_ + x_mps * time_s;
    const Pair y_m = offset_y_m_ + y_mps * time_s;
    const Pair closest_x_m = offset_x_m_ + x_mps * closest_s;
    const Pair closest_y_m = offset_y_m_ + y_mps * closest_s;
    most_approach = most_approach.max(approach);
    leftmost = leftmost.min(area);
    rightmost = rightmost.max(area);
    fastest2_m2ps2 = fastest2_m2ps2.max(speed2);
    greatest2_m2 = greatest2_m2.max(x_m * x_m + y_m * y_m);
    least2_m2 = least2_m2.min(closest_x_m * closest_x_m + closest_y_m * closest_y_m);
  }
  if (most_approach.maxCoeff() <= 0) return {.min = range_m_, .max = range_m_};

  const double margin_m = kRounding * range_m_;
  const double least_m = leftmost.minCoeff() > 0 || rightmost.maxCoeff() < 0
                             ? std::sqrt(least2_m2.minCoeff())
                             : range_m_ - horizon_s_ * std::sqrt(fastest2_m2ps2.maxCoeff());
  return {.min = std::max(least_m - margin_m, 0.0),
          .max = std::min(std::sqrt(greatest2_m2.maxCoeff()) + margin_m, range_m_)};
}

double CpaFunction::At(int course, int speed) const {
  return UtilityOfCpa(cpa_.At(course, speed), utility_);
}

CourseSpeedFunction::Range CpaFunction::Bound(const GridBox& box) const {
  return UtilityOfCpa(cpa_.Bound(box), utility_);
}

}  // namespace shoal
