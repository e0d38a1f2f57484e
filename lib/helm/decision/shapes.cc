#include "lib/helm/decision/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"
#include "lib/helm/decision/best_point.h"

namespace shoal {

namespace {

/// Distances that differ by less are the same: grid points are multiples of steps such as 0.1.
constexpr double kSame = 1e-9;

/// A function whose spread is less is flat; beyond, rounding would be normalised to 0..100.
constexpr double kFlat = 1e-9;

struct Peak {
  double peak = 0;
  double base = 0;
  double delta = 0;
  double lo = 0;
  double hi = 100;
};

double ValueAt(const Peak& shape, double distance) {
  if (distance <= shape.peak + kSame) {
    return shape.peak > 0 ? shape.hi - shape.delta * std::min(distance / shape.peak, 1.0)
                          : shape.hi;
  }
  const double shoulder = shape.peak > 0 ? shape.hi - shape.delta : shape.hi;
  if (distance >= shape.peak + shape.base) return shape.lo;
  return shape.lo + (shoulder - shape.lo) * (1 - (distance - shape.peak) / shape.base);
}

/// Gives the point `nearest` to the summit the value hi where nothing is above lo.
void InsistOnSummit(const Peak& shape, size_t nearest, std::vector<double>* values) {
  const bool lost =
      std::all_of(values->begin(), values->end(), [&](double value) { return value <= shape.lo; });
  if (lost) (*values)[nearest] = shape.hi;
}

struct Knot {
  int index = 0;
  double value = 0;
};

/// Adds what lies between two knots, the second one included. @pre from.index <= to.index
void AppendLine(const Knot& from, const Knot& to, std::vector<double>* values) {
  for (int i = from.index + 1; i <= to.index; ++i) {
    const double share = static_cast<double>(i - from.index) / (to.index - from.index);
    values->push_back(from.value + share * (to.value - from.value));
  }
}

struct Extent {
  double min = 0;
  double max = 0;
};

Extent ExtentOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return {.min = *min, .max = *max};
}

/// Returns `values` spanning 0..share; flat ones at their value, clipped to 0..100, of the share.
std::vector<double> Spanning(const std::vector<double>& values, double share) {
  const Extent extent = ExtentOf(values);
  const double spread = extent.max - extent.min;
  if (spread < kFlat) {
    return std::vector<double>(values.size(), share * std::clamp(extent.max, 0.0, 100.0) / 100);
  }
  std::vector<double> spanning;
  spanning.reserve(values.size());
  for (const double value : values) spanning.push_back(share * (value - extent.min) / spread);
  return spanning;
}

Objective Rescaled(Objective objective, const Extent& parts) {
  const double factor = objective.scale;
  const double low = objective.offset + factor * (factor < 0 ? parts.max : parts.min);
  const double high = objective.offset + factor * (factor < 0 ? parts.min : parts.max);
  if (high - low < kFlat) {
    objective.offset = std::clamp(high, 0.0, 100.0);
    objective.scale = 0;
    return objective;
  }
  const double to_100 = 100 / (high - low);
  objective.offset = (objective.offset - low) * to_100;
  objective.scale = factor * to_100;
  return objective;
}

/// The parts over course and speed of an objective, or their negative, without offset and scale.
class SignedParts {
 public:
  using Number = double;
  struct Bounds {};
  static constexpr bool kAnyOfEquals = true;

  SignedParts(const Objective& objective, double sign, const Domain& domain)
      : objective_(objective), sign_(sign) {
    const int fastest = domain.speed_mps.count - 1;
    for (size_t i = 0; i < first_guesses_.size(); ++i) {
      first_guesses_[i] = {.course = 45 * static_cast<int>(i), .speed = fastest};
    }
  }

  double Value(const GridPoint& point) const {
    double value = 0;
    if (!objective_.course.empty()) value += objective_.course[static_cast<size_t>(point.course)];
    if (!objective_.speed.empty()) value += objective_.speed[static_cast<size_t>(point.speed)];
    return sign_ * (value + objective_.coupled->At(point.course, point.speed));
  }

  double Upper(const GridBox& box, const Bounds&, double, Bounds*) const {
    const CourseSpeedFunction::Range range = objective_.coupled->Bound(box);
    double value = Extreme(objective_.course, box.first_course, box.last_course);
    value += Extreme(objective_.speed, box.first_speed, box.last_speed);
    return sign_ * (value + (sign_ < 0 ? range.min : range.max));
  }

  bool Worthwhile(const GridPoint&, const Bounds&, double) const { return true; }

  const std::array<GridPoint, 8>& first_guesses() const { return first_guesses_; }

 private:
  double Extreme(const std::vector<double>& values, int first, int last) const {
    if (values.empty()) return 0;
    const auto [min, max] = std::minmax_element(values.begin() + first, values.begin() + last + 1);
    return sign_ < 0 ? *min : *max;
  }

  const Objective& objective_;
  double sign_;
  std::array<GridPoint, 8> first_guesses_;
};

/// Returns the index of the value nearest to `value`, the upper one of two, as the original rounds.
int NearestHalfUp(const Axis& axis, double value) {
  constexpr double kTie = 1e-9;
  const double place = std::floor((value - axis.first) / axis.step + 0.5 + kTie);
  return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(axis.count - 1)));
}

}  // namespace

std::vector<double> PeakOverCourse(double summit_deg, double peak_deg, double base_deg,
                                   double delta, double lo, double hi) {
  const Peak shape{.peak = peak_deg, .base = base_deg, .delta = delta, .lo = lo, .hi = hi};
  std::vector<double> values;
  values.reserve(Domain::kNumCourses);
  const double summit = Wrap360(summit_deg);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    const double apart = std::abs(course - summit);
    values.push_back(ValueAt(shape, std::min(apart, 360 - apart)));
  }
  const auto nearest = static_cast<size_t>(std::ceil(summit - 0.5));
  InsistOnSummit(shape, nearest % Domain::kNumCourses, &values);
  return values;
}

std::vector<double> PeakOverAxis(const Axis& axis, double summit, double peak, double base,
                                 double delta, double lo, double hi) {
  const Peak shape{.peak = peak, .base = base, .delta = delta, .lo = lo, .hi = hi};
  std::vector<double> values;
  values.reserve(static_cast<size_t>(axis.count));
  for (int i = 0; i < axis.count; ++i) {
    values.push_back(ValueAt(shape, std::abs(axis.At(i) - summit)));
  }
  InsistOnSummit(shape, static_cast<size_t>(axis.Nearest(summit)), &values);
  return values;
}

std::vector<double> SpeedPolyline(const Axis& axis, double med, double low, double high,
                                  double u_low, double u_high) {
  const int last = axis.count - 1;
  const Knot middle{.index = NearestHalfUp(axis, med), .value = 100};
  // On each side the knot nearer to the middle is written later, and so prevails.
  Knot rising{.index = std::min(NearestHalfUp(axis, low), middle.index), .value = u_low};
  if (rising.index == middle.index) rising = middle;
  Knot falling{.index = std::max(NearestHalfUp(axis, high), middle.index), .value = u_high};
  if (falling.index == middle.index) falling = middle;
  const Knot begin = rising.index == 0 ? rising : Knot{.index = 0, .value = 0};
  const Knot end = falling.index == last ? falling : Knot{.index = last, .value = 0};

  std::vector<double> values = {begin.value};
  values.reserve(static_cast<size_t>(axis.count));
  AppendLine(begin, rising, &values);
  AppendLine(rising, middle, &values);
  AppendLine(middle, falling, &values);
  AppendLine(falling, end, &values);
  return values;
}

std::vector<double> HeadingPolyline(double summit_deg, double dl, double dh, double u_l,
                                    double u_h) {
  std::vector<double> values;
  values.reserve(Domain::kNumCourses);
  for (int course = 0; course < Domain::kNumCourses; ++course) {
    const double turn = Wrap180(course - summit_deg);
    const double distance = std::abs(turn);
    const double knee = turn < 0 ? dl : dh;
    const double u = turn < 0 ? u_l : u_h;
    values.push_back(distance <= knee ? 100 + (u - 100) * distance / knee
                                      : u * (180 - distance) / (180 - knee));
  }
  return values;
}

std::vector<double> AtMost(const Axis& axis, double summit, double base) {
  const Peak shape{.base = base};
  const double edge = std::max(summit, axis.first);
  std::vector<double> values;
  values.reserve(static_cast<size_t>(axis.count));
  for (int i = 0; i < axis.count; ++i) {
    values.push_back(ValueAt(shape, std::max(axis.At(i) - edge, 0.0)));
  }
  return values;
}

std::vector<double> AtLeast(const Axis& axis, double summit, double base) {
  const Peak shape{.base = base};
  const double edge = std::min(summit, axis.Last());
  std::vector<double> values;
  values.reserve(static_cast<size_t>(axis.count));
  for (int i = 0; i < axis.count; ++i) {
    values.push_back(ValueAt(shape, std::max(edge - axis.At(i), 0.0)));
  }
  return values;
}

std::vector<double> SumOf(const std::vector<double>& a, const std::vector<double>& b) {
  SHOAL_CHECK(a.size() == b.size(), "parts of a sum are over the same axis");
  std::vector<double> sum = a;
  for (size_t i = 0; i < sum.size(); ++i) sum[i] += b[i];
  return sum;
}

Objective Couple(const std::vector<double>& course, const std::vector<double>& speed,
                 double course_share, double speed_share) {
  SHOAL_CHECK(!course.empty() && !speed.empty(), "both parts have values");
  const double shares = course_share + speed_share;
  Objective objective{.course = Spanning(course, 100 * course_share / shares),
                      .speed = Spanning(speed, 100 * speed_share / shares)};
  const Extent of_course = ExtentOf(objective.course);
  const Extent of_speed = ExtentOf(objective.speed);
  return Rescaled(std::move(objective),
                  {.min = of_course.min + of_speed.min, .max = of_course.max + of_speed.max});
}

Objective NormaliseTo100(Objective objective, const Domain& domain) {
  const Extent depth = ExtentOf(objective.depth);
  Extent level;
  if (objective.coupled == nullptr) {
    const Extent course = ExtentOf(objective.course);
    const Extent speed = ExtentOf(objective.speed);
    level = {.min = course.min + speed.min, .max = course.max + speed.max};
  } else {
    const GridBox whole{.last_course = Domain::kNumCourses - 1,
                        .last_speed = domain.speed_mps.count - 1};
    SignedParts greatest(objective, 1, domain);
    SignedParts least(objective, -1, domain);
    level = {.min = -BestPoint(&least, whole).second, .max = BestPoint(&greatest, whole).second};
  }
  return Rescaled(std::move(objective),
                  {.min = level.min + depth.min, .max = level.max + depth.max});
}

}  // namespace shoal
