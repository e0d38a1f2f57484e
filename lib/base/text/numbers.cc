#include "lib/base/text/numbers.h"

#include <array>

#include "lib/base/text/blanks.h"

namespace shoal {

std::optional<double> NumberIn(std::string_view text) { return ReadNumber<double>(Trimmed(text)); }

std::string ShortestText(double number) {
  std::array<char, 32> digits{};  // The longest, -2.2250738585072014e-308, has 24.
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  return {digits.data(), end};
}

std::string ZeroPadded(int64_t number, int width) {
  std::string digits = std::to_string(number);
  const size_t length = digits.size();
  const auto wanted = static_cast<size_t>(width);
  if (length < wanted) digits.insert(number < 0 ? 1 : 0, wanted - length, '0');
  return digits;
}

}  // namespace shoal
