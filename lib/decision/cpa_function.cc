#include "lib/decision/cpa_function.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/check/bounds.h"
#include "lib/geometry/angles.h"

namespace shoal {

namespace {

using Directions = std::array<double, 1440>;

/// Boxes that are wider are bounded in halves: the tangents of a wide arc meet far outside.
constexpr int kWidestBox_deg = 40;

/// Of the range: far more than CPA can be off by rounding.
constexpr double kRounding = 1e-13;

/// No speed; keeps a quotient finite.
constexpr double kTiny_m2ps2 = 1e-300;

/// Returns the sine of a number of half degrees, 0 to 180 (90 degrees), the same for angles that
/// mirror each other.
double SineOfQuadrant(int half_deg) {
  return half_deg <= 90 ? std::sin(DegToRad(half_deg / 2.0))
                        : std::cos(DegToRad((180 - half_deg) / 2.0));
}

Directions MakeDirections() {
  Directions directions = {};
  for (int i = 0; i < 720; ++i) {
    const int quadrant = i / 180;
    const double rising = SineOfQuadrant(i % 180);
    const double falling = SineOfQuadrant(180 - i % 180);
    const double sine = quadrant % 2 == 0 ? rising : falling;
    const double cosine = quadrant % 2 == 0 ? falling : rising;
    directions[static_cast<size_t>(2 * i)] = quadrant < 2 ? sine : -sine;
    directions[static_cast<size_t>(2 * i + 1)] = quadrant % 3 == 0 ? cosine : -cosine;
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
  const double* direction = directions_->data() + 4 * static_cast<ptrdiff_t>(course);
  const double own_mps = SpeedAt(speed);
  const double x_mps = contact_x_mps_ - own_mps * direction[0];
  const double y_mps = contact_y_mps_ - own_mps * direction[1];
  const double approach = -(offset_x_m_ * x_mps + offset_y_m_ * y_mps);
  const double speed2 = std::max(x_mps * x_mps + y_mps * y_mps, kTiny_m2ps2);
  const double time_s = std::min(std::max(approach / speed2, 0.0), horizon_s_);
  const double x_m = offset_x_m_ + x_mps * time_s;
  const double y_m = offset_y_m_ + y_mps * time_s;
  return std::sqrt(std::min(x_m * x_m + y_m * y_m, range2_m2_));
}

CourseSpeedFunction::Range CpaGrid::Bound(const GridBox& box) const {
  const int width_deg = box.last_course - box.first_course;
  if (width_deg > kWidestBox_deg) {
    GridBox left = box;
    GridBox right = box;
    left.last_course = box.first_course + width_deg / 2;
    right.first_course = left.last_course + 1;
    const auto a = Bound(left);
    const auto b = Bound(right);
    return {.min = std::min(a.min, b.min), .max = std::max(a.max, b.max)};
  }

  double greatest2_m2 = 0;
  double least2_m2 = range2_m2_;  // Without horizon.
  double fastest2_m2ps2 = 0;
  double leftmost = kInfinity;  // Twice the areas that offset and velocity span.
  double rightmost = -kInfinity;
  bool closing = false;
  const auto count_corner = [&](int half_deg, double own_mps) {
    const double* direction = directions_->data() + 2 * static_cast<ptrdiff_t>(half_deg);
    const double x_mps = contact_x_mps_ - own_mps * direction[0];
    const double y_mps = contact_y_mps_ - own_mps * direction[1];
    const double approach = -(offset_x_m_ * x_mps + offset_y_m_ * y_mps);
    const double area = offset_x_m_ * y_mps - offset_y_m_ * x_mps;
    const double speed2 = std::max(x_mps * x_mps + y_mps * y_mps, kTiny_m2ps2);
    leftmost = std::min(leftmost, area);
    rightmost = std::max(rightmost, area);
    fastest2_m2ps2 = std::max(fastest2_m2ps2, speed2);
    if (approach <= 0) {
      greatest2_m2 = range2_m2_;
      return;
    }
    closing = true;
    const double time_s = std::min(approach / speed2, horizon_s_);
    const double x_m = offset_x_m_ + x_mps * time_s;
    const double y_m = offset_y_m_ + y_mps * time_s;
    greatest2_m2 = std::max(greatest2_m2, x_m * x_m + y_m * y_m);
    least2_m2 = std::min(least2_m2, area * area / speed2);
  };
  const double slow_mps = SpeedAt(box.first_speed);
  const double fast_mps = SpeedAt(box.last_speed);
  count_corner(2 * box.first_course, fast_mps);
  if (box.last_speed > box.first_speed) count_corner(2 * box.first_course, slow_mps);
  if (width_deg > 0) {
    count_corner(2 * box.last_course, fast_mps);
    if (box.last_speed > box.first_speed && slow_mps > 0) {
      count_corner(2 * box.last_course, slow_mps);
    }
    if (width_deg > 1) {
      const double cosine = (*directions_)[static_cast<size_t>(2 * width_deg + 1)];
      count_corner(box.first_course + box.last_course, fast_mps / cosine);
    }
  }
  if (!closing) return {.min = range_m_, .max = range_m_};

  const double margin_m = kRounding * range_m_;
  double least_m = 0;
  if (leftmost > 0 || rightmost < 0) {
    least_m = std::sqrt(least2_m2);
  } else {
    least_m = range_m_ - horizon_s_ * std::sqrt(fastest2_m2ps2);
  }
  return {.min = std::max(least_m - margin_m, 0.0),
          .max = std::min(std::sqrt(greatest2_m2) + margin_m, range_m_)};
}

double CpaFunction::At(int course, int speed) const {
  return UtilityOfCpa(cpa_.At(course, speed), utility_);
}

CourseSpeedFunction::Range CpaFunction::Bound(const GridBox& box) const {
  return UtilityOfCpa(cpa_.Bound(box), utility_);
}

}  // namespace shoal
