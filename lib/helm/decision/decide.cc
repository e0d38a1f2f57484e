#include "lib/helm/decision/decide.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "lib/base/check/check.h"
#include "lib/helm/decision/best_point.h"

namespace shoal {

namespace {

/// A whole number of units. Sums of them are exact below 2^53, 9,000 objectives of 0 to 100, and so
/// do not depend on the order of their terms.
using Units = double;

constexpr double kUnitsOfGreatestWeight = 1e10;

/// Returns the whole number nearest to x, by the mantissa's end. Never decreases with x, so that a
/// bound stays one. @pre |x| < 2^51
Units ToUnits(double x) {
  constexpr double kLastDigitIsOne = 6755399441055744;  // 1.5 x 2^52.
  return (x + kLastDigitIsOne) - kLastDigitIsOne;
}

void CheckSizes(const Domain& domain, const Objective& objective) {
  const auto fits = [](const std::vector<double>& values, int count) {
    return values.empty() || values.size() == static_cast<size_t>(count);
  };
  SHOAL_CHECK(fits(objective.course, Domain::kNumCourses), "one value per course, or none");
  SHOAL_CHECK(fits(objective.speed, domain.speed_mps.count), "one value per speed, or none");
  SHOAL_CHECK(fits(objective.depth, domain.depth_m.count), "one value per depth, or none");
  SHOAL_CHECK(!objective.mentions_speed() || domain.speed_mps.count > 0, "the domain has speeds");
}

void AddTo(std::vector<Units>* sum, const std::vector<double>& values, double factor) {
  for (size_t i = 0; i < values.size(); ++i) (*sum)[i] += ToUnits(factor * values[i]);
}

int FirstGreatest(const std::vector<Units>& sums) {
  return static_cast<int>(std::max_element(sums.begin(), sums.end()) - sums.begin());
}

/// The greatest of any interval of a row of sums, in constant time.
class IntervalMaximum {
 public:
  explicit IntervalMaximum(std::vector<Units> sums) {
    levels_[0] = std::move(sums);
    const size_t count = levels_[0].size();
    for (size_t level = 1; (size_t{1} << level) <= count; ++level) {
      const std::vector<Units>& half = levels_[level - 1];
      const size_t reach = size_t{1} << (level - 1);
      levels_[level].resize(count - 2 * reach + 1);
      for (size_t i = 0; i < levels_[level].size(); ++i) {
        levels_[level][i] = std::max(half[i], half[i + reach]);
      }
    }
  }

  Units At(int index) const { return levels_[0][static_cast<size_t>(index)]; }

  Units Of(int first, int last) const {
    const auto length = static_cast<unsigned>(last - first + 1);
    const auto level = static_cast<size_t>(std::bit_width(length)) - 1;
    const auto reach = size_t{1} << level;
    return std::max(levels_[level][static_cast<size_t>(first)],
                    levels_[level][static_cast<size_t>(last) + 1 - reach]);
  }

 private:
  std::array<std::vector<Units>, 10> levels_;
};

/// Speeds that are allowed, by course, and what boxes hold of them.
class AllowedBoxes {
 public:
  explicit AllowedBoxes(const std::vector<IndexRange>& speeds)
      : speeds_(speeds), greatest_(Ends(speeds, 1)), least_(Ends(speeds, -1)) {}

  bool Has(const GridPoint& point) const {
    return speeds_[static_cast<size_t>(point.course)].Has(point.speed);
  }
  /// False: no point of the box is allowed; true: some may be.
  bool MayHaveSome(const GridBox& box) const {
    return greatest_.Of(box.first_course, box.last_course) >= box.first_speed &&
           -least_.Of(box.first_course, box.last_course) <= box.last_speed;
  }

 private:
  /// Returns the last speed of each course, or minus the first one; of none, less than any.
  static std::vector<Units> Ends(const std::vector<IndexRange>& speeds, int sign) {
    std::vector<Units> ends;
    ends.reserve(speeds.size());
    for (const IndexRange& range : speeds) {
      ends.push_back(range.empty() ? -std::numeric_limits<Units>::infinity()
                                   : (sign > 0 ? range.last : -range.first));
    }
    return ends;
  }

  const std::vector<IndexRange>& speeds_;
  IntervalMaximum greatest_;
  IntervalMaximum least_;
};

struct CoupledTerm {
  const CourseSpeedFunction* function = nullptr;
  double factor = 0;
};

/// Course and speed: a separable sum, and terms that couple both. What is not allowed is worth less
/// than any sum.
class WeightedSum {
 public:
  using Number = Units;

  /// Of a box: an upper bound of each term, in a row of upper_, and which terms are constant.
  struct Bounds {
    size_t row = 0;
    uint64_t constant = 0;  ///< A bit for each of the first 64 terms.
  };
  static constexpr bool kAnyOfEquals = false;

  /// `allowed`: nullptr: everything.
  WeightedSum(std::vector<Units> course, std::vector<Units> speed, std::vector<CoupledTerm> terms,
              const AllowedBoxes* allowed)
      : allowed_(allowed),
        terms_(std::move(terms)),
        first_guess_{GridPoint{.course = FirstGreatest(course), .speed = FirstGreatest(speed)}},
        course_(std::move(course)),
        speed_(std::move(speed)) {
    // Those that matter most first: they rule a box out soonest.
    std::stable_sort(terms_.begin(), terms_.end(), [](const CoupledTerm& a, const CoupledTerm& b) {
      return std::abs(a.factor) > std::abs(b.factor);
    });
    upper_.reserve(256 * terms_.size());
    upper_.assign(terms_.size(), std::numeric_limits<Units>::infinity());
  }

  Units Value(const GridPoint& point) const {
    if (allowed_ != nullptr && !allowed_->Has(point)) return kNotAllowed;
    Units sum = course_.At(point.course) + speed_.At(point.speed);
    for (const CoupledTerm& term : terms_) {
      sum += ToUnits(term.factor * term.function->At(point.course, point.speed));
    }
    return sum;
  }

  Units Upper(const GridBox& box, const Bounds& outer, Units worth, Bounds* bounds) {
    if (allowed_ != nullptr && !allowed_->MayHaveSome(box)) return kNotAllowed;
    const Units separable =
        course_.Of(box.first_course, box.last_course) + speed_.Of(box.first_speed, box.last_speed);
    // The terms that were not bounded yet count as in the outer box.
    Units sum = separable + SumOfRow(outer.row);
    if (sum < worth) return sum;
    *bounds = {.row = upper_.size(), .constant = outer.constant};
    for (size_t i = 0; i < terms_.size(); ++i) {
      const Units outer_upper = upper_[outer.row + i];
      const uint64_t bit = i < 64 ? uint64_t{1} << i : 0;
      if ((outer.constant & bit) != 0) {
        upper_.push_back(outer_upper);
        continue;
      }
      const CourseSpeedFunction::Range range = terms_[i].function->Bound(box);
      if (range.min == range.max) bounds->constant |= bit;
      const Units upper = std::min(
          outer_upper, ToUnits(terms_[i].factor * (terms_[i].factor < 0 ? range.min : range.max)));
      upper_.push_back(upper);
      sum = outer_upper < std::numeric_limits<Units>::infinity() ? sum - outer_upper + upper : sum;
      if (sum < worth) {
        upper_.resize(bounds->row);
        return sum;
      }
    }
    return separable + SumOfRow(bounds->row);
  }

  bool Worthwhile(const GridPoint& point, const Bounds& bounds, Units worth) const {
    return course_.At(point.course) + speed_.At(point.speed) + SumOfRow(bounds.row) >= worth;
  }

  const std::array<GridPoint, 1>& first_guesses() const { return first_guess_; }

 private:
  static constexpr Units kNotAllowed = -std::numeric_limits<Units>::infinity();

  Units SumOfRow(size_t row) const {
    Units sum = 0;
    for (size_t i = 0; i < terms_.size(); ++i) sum += upper_[row + i];
    return sum;
  }

  const AllowedBoxes* allowed_;
  std::vector<CoupledTerm> terms_;
  std::array<GridPoint, 1> first_guess_;
  IntervalMaximum course_;
  IntervalMaximum speed_;
  std::vector<Units> upper_;  ///< Rows of terms_.size(); the first, infinite, is of no box.
};

/// What objectives come to, in units: tables, and terms that couple course and speed.
struct Sums {
  std::vector<Units> course = {};  ///< Empty: not mentioned, as below.
  std::vector<Units> speed = {};
  std::vector<Units> depth = {};
  std::vector<CoupledTerm> terms = {};
};

template <class Objectives>
Sums Add(const Domain& domain, const Objectives& objectives, double greatest_weight) {
  bool any_course = false;
  bool any_speed = false;
  bool any_depth = false;
  Sums sums = {.course = std::vector<Units>(Domain::kNumCourses),
               .speed = std::vector<Units>(static_cast<size_t>(domain.speed_mps.count)),
               .depth = std::vector<Units>(static_cast<size_t>(domain.depth_m.count))};
  for (const auto& [weight, objective] : objectives) {
    if (!(weight > 0)) continue;
    any_course = any_course || objective.mentions_course();
    any_speed = any_speed || objective.mentions_speed();
    any_depth = any_depth || objective.mentions_depth();
    const double factor = weight / greatest_weight * objective.scale * kUnitsOfGreatestWeight;
    AddTo(&sums.course, objective.course, factor);
    AddTo(&sums.speed, objective.speed, factor);
    AddTo(&sums.depth, objective.depth, factor);
    if (objective.coupled != nullptr && factor != 0) {
      sums.terms.push_back({.function = objective.coupled.get(), .factor = factor});
    }
  }
  if (!any_course) sums.course.clear();
  if (!any_speed) sums.speed.clear();
  if (!any_depth) sums.depth.clear();
  return sums;
}

/// Returns the best point of the whole domain.
DomainPoint BestOf(const Sums& sums) {
  DomainPoint best;
  if (!sums.depth.empty()) best.depth = FirstGreatest(sums.depth);
  if (sums.terms.empty()) {
    if (!sums.course.empty()) best.course = FirstGreatest(sums.course);
    if (!sums.speed.empty()) best.speed = FirstGreatest(sums.speed);
    return best;
  }
  WeightedSum sum(sums.course, sums.speed, sums.terms, nullptr);
  const GridPoint point = BestPoint(&sum, {.last_course = Domain::kNumCourses - 1,
                                           .last_speed = static_cast<int>(sums.speed.size()) - 1})
                              .first;
  best.course = point.course;
  best.speed = point.speed;
  return best;
}

/// Returns the best point of those that are allowed. `best` is the one of the whole domain.
DomainPoint BestAllowed(const Sums& sums, const AllowedPart& allowed, DomainPoint best) {
  if (best.depth && allowed.depths && !allowed.depths->empty() &&
      !allowed.depths->Has(*best.depth)) {
    const auto begin = sums.depth.begin();
    best.depth = static_cast<int>(
        std::max_element(begin + allowed.depths->first, begin + allowed.depths->last + 1) - begin);
  }
  if (!best.course || !best.speed || allowed.speeds.empty() || !AllowsAny(allowed.speeds) ||
      allowed.speeds[static_cast<size_t>(*best.course)].Has(*best.speed)) {
    return best;
  }
  const AllowedBoxes boxes(allowed.speeds);
  WeightedSum sum(sums.course, sums.speed, sums.terms, &boxes);
  const GridPoint point = BestPoint(&sum, {.last_course = Domain::kNumCourses - 1,
                                           .last_speed = static_cast<int>(sums.speed.size()) - 1})
                              .first;
  best.course = point.course;
  best.speed = point.speed;
  return best;
}

}  // namespace

GridDecision Decide(const Domain& domain, std::span<const WeightedObjective> objectives,
                    const AllowedPart& allowed) {
  double greatest_weight = 0;
  for (const WeightedObjective& aim : objectives) {
    CheckSizes(domain, aim.objective);
    greatest_weight = std::max(greatest_weight, aim.weight);
  }
  SHOAL_CHECK(allowed.speeds.empty() || allowed.speeds.size() == Domain::kNumCourses,
              "speeds are allowed by course");
  const Sums sums = Add(domain, objectives, greatest_weight);
  const DomainPoint wanted = BestOf(sums);
  GridDecision decision{.point = BestAllowed(sums, allowed, wanted)};
  if (decision.point != wanted) decision.wanted = wanted;
  // Sorted, so that the last digit of the sum does not depend on the order either.
  std::vector<double> shares;
  for (const auto& [weight, objective] : objectives) {
    if (weight > 0) shares.push_back(weight * ValueOf(objective, decision.point));
  }
  std::sort(shares.begin(), shares.end());
  for (const double share : shares) decision.utility += share;
  return decision;
}

double ValueOf(const Objective& objective, const DomainPoint& point) {
  double value = 0;
  if (!objective.course.empty() && point.course) {
    value += objective.course[static_cast<size_t>(*point.course)];
  }
  if (!objective.speed.empty() && point.speed) {
    value += objective.speed[static_cast<size_t>(*point.speed)];
  }
  if (!objective.depth.empty() && point.depth) {
    value += objective.depth[static_cast<size_t>(*point.depth)];
  }
  if (objective.coupled != nullptr && point.course && point.speed) {
    value += objective.coupled->At(*point.course, *point.speed);
  }
  return objective.offset + objective.scale * value;
}

double ValueOf(const Objective& objective, int course, int speed, int depth) {
  return ValueOf(objective, {.course = course, .speed = speed, .depth = depth});
}

std::vector<AimAtDecision> Explain(const Domain& domain,
                                   std::span<const WeightedObjective> objectives,
                                   const GridDecision& decision) {
  std::vector<AimAtDecision> aims;
  aims.reserve(objectives.size());
  for (const auto& [weight, objective] : objectives) {
    CheckSizes(domain, objective);
    struct Alone {
      double weight;
      const Objective& objective;
    };
    AimAtDecision aim{.value = ValueOf(objective, decision.point),
                      .best_point = BestOf(Add(domain, std::array{Alone{1, objective}}, 1))};
    aim.best_value = ValueOf(objective, aim.best_point);
    aim.loss = std::max(weight, 0.0) * (aim.best_value - aim.value);
    aims.push_back(aim);
  }
  return aims;
}

}  // namespace shoal
