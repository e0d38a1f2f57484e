#pragma once

#include <string>

namespace shoal {

/// Returns the shortest usual writing of a number with at most 6 digits: "10.25", "1e-09", "nan".
[[nodiscard]] std::string RoundedText(double number);

}  // namespace shoal
