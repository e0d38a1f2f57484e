// What was found when one expectation was put to one vehicle.
#pragma once

#include <optional>
#include <string>

namespace shoal {

struct Outcome {
  bool passed = false;
  double strain = 0;    ///< The larger, the nearer to a failure, among outcomes of one expectation.
  std::string numbers;  ///< What decided, and by how much: "there at 612.3 s, 12.3 s late".
  /// The number that decided, in UnitOf (lib/run/verdict/expectation_text.h); absent: there is
  /// none.
  std::optional<double> value = std::nullopt;
};

/// Returns by how much a limit was missed, with digits enough to distinguish it from zero: "12.3",
/// "0.0051".
[[nodiscard]] std::string FormatExcess(double excess);

}  // namespace shoal
