// The decision of a helm: the point of the grid with the greatest weighted sum, exact.
//
//   std::vector<WeightedObjective> aims = ...;  // One per active behavior.
//   const GridDecision decision = Decide(domain, aims);
//   for (const AimAtDecision& aim : Explain(domain, aims, decision)) ...
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lib/helm/decision/allowed.h"
#include "lib/helm/decision/objective.h"

namespace shoal {

/// What one behavior wants, and how much it counts.
struct WeightedObjective {
  double weight = 0;  ///< 0 and less: as if it were absent.
  Objective objective = {};
};

/// Indices into a domain.
struct DomainPoint {
  std::optional<int> course = {};
  std::optional<int> speed = {};
  std::optional<int> depth = {};

  bool operator==(const DomainPoint&) const = default;
};

struct GridDecision {
  DomainPoint point = {};  ///< Absent: no objective of weight > 0 mentions the variable.
  double utility = 0;      ///< The weighted sum at the point.
  /// The best point of the whole domain, where it is not allowed.
  std::optional<DomainPoint> wanted = {};
};

/// Returns the point of the domain where  sum of weight x value  is greatest, of all points that
/// are allowed. Where no course and speed is, all are; so with depths. Speeds of courses count only
/// where both are mentioned.
///
/// Ties: of equal sums the lowest course, of those the lowest speed; of equal depths the lowest.
/// Sums are equal that agree in whole units of 1e-10 of the greatest weight: each objective's share
/// of a sum is rounded to such units once, and added as an integer. So neither the order of the
/// objectives nor a common factor of their weights has any effect, and the utility is at most n
/// such units, n the number of objectives, below the greatest.
///
/// @pre values are finite and not beyond 1e4, as NormaliseTo100 leaves them; parts have as many
///      values as the domain; domain.speed_mps.count > 0 where speed is mentioned; `allowed` has
///      speeds of all courses or none, within the domain
[[nodiscard]] GridDecision Decide(const Domain& domain,
                                  std::span<const WeightedObjective> objectives,
                                  const AllowedPart& allowed = {});

/// Returns the value of an objective at a point. Parts whose variable is absent do not count.
[[nodiscard]] double ValueOf(const Objective& objective, const DomainPoint& point);
[[nodiscard]] double ValueOf(const Objective& objective, int course, int speed, int depth);

/// What a decision means for one objective.
struct AimAtDecision {
  double value = 0;             ///< At the decision.
  double best_value = 0;        ///< Anywhere.
  DomainPoint best_point = {};  ///< The lowest one of equals; absent: not mentioned.
  double loss = 0;              ///< weight x (best_value - value); >= 0 but for rounding.
};

/// Explains a decision to people, whatever is allowed: one line per objective, in their order.
/// Objectives of weight 0 lose nothing. @pre `decision` is of the same domain and objectives
[[nodiscard]] std::vector<AimAtDecision> Explain(const Domain& domain,
                                                 std::span<const WeightedObjective> objectives,
                                                 const GridDecision& decision);

}  // namespace shoal
