// What most behaviors answer: a function built of lib/helm/decision/shapes.h, and reports.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/decision/shapes.h"

namespace shoal {

/// A peak over one variable, in its units; `delta` is what it loses over `width`, 0 to 100.
struct Peak {
  double summit = 0;
  double width = 0;
  double base = 0;
  double delta = 0;
};

/// Returns an answer with the function, normalised, and full relevance.
[[nodiscard]] BehaviorAnswer Prefer(const BehaviorInputs& inputs, Objective objective);

[[nodiscard]] BehaviorAnswer PreferCourse(const Peak& peak, const BehaviorInputs& inputs);
/// Without preference where the helm does not decide about speed.
[[nodiscard]] BehaviorAnswer PreferSpeed(const Peak& peak, const BehaviorInputs& inputs);
/// Without preference, and with a warning, where the helm does not decide about depth.
[[nodiscard]] BehaviorAnswer PreferDepth(const Peak& peak, const BehaviorInputs& inputs);

/// Returns an answer whose only content is the warning that the helm does not decide about depth.
[[nodiscard]] BehaviorAnswer WarnOfNoDepth();

/// Course and speed coupled; `patience` is the share of the course, per cent.
[[nodiscard]] BehaviorAnswer PreferBoth(const BehaviorInputs& inputs,
                                        const std::vector<double>& course,
                                        const std::vector<double>& speed, double patience);

/// Returns the speed limited to those of the domain.
[[nodiscard]] double InDomain(const BehaviorInputs& inputs, double speed_mps);

/// Returns the polyline of speed that transit behaviors share: from `slow_value` at 0.1 m/s up to
/// 100 at the speed, down to 20 at 0.4 m/s more, 0 at the ends.
[[nodiscard]] std::vector<double> TransitSpeed(const BehaviorInputs& inputs, double speed_mps,
                                               double slow_value);

/// Appends a report; none where `variable` is empty. `suffix` goes behind the name of the variable,
/// after an underscore; empty: nothing does.
void Post(BehaviorAnswer& answer, std::string_view variable, double value,
          std::string_view suffix = {});
void Post(BehaviorAnswer& answer, std::string_view variable, std::string_view value,
          std::string_view suffix = {});

/// Returns a number without decimals, for texts.
[[nodiscard]] std::string Whole(double number);

/// Returns true where the variable was set since the last iteration. An empty name never was.
[[nodiscard]] bool IsFresh(const BehaviorInputs& inputs, std::string_view variable);

/// Returns the bearing of `to_m` from `from_m`, degrees, [0, 360); 0 where they coincide.
[[nodiscard]] double BearingDeg(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

}  // namespace shoal
