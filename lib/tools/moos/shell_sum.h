// $((1 + 2 * X)): sums of whole numbers and variables in a shell script.
#pragma once

#include <functional>
#include <string_view>

namespace shoal {

/// Returns the first value of a variable; nothing: it has none.
using ShellValue = std::function<std::string_view(std::string_view name)>;

/// Computes a sum with + - * / % and brackets. What cannot be read counts as 0, as does a division
/// by 0; every step stays within +-1e9. `is_exact`: false where one of these two was needed.
[[nodiscard]] long long ShellSum(std::string_view text, const ShellValue& value_of,
                                 bool* is_exact = nullptr);

}  // namespace shoal
