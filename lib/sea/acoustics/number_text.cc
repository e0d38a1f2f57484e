#include "lib/sea/acoustics/number_text.h"

#include <array>
#include <charconv>

namespace shoal {

std::string RoundedText(double number) {
  std::array<char, 32> text;  // "-1.23457e-308" is the longest.
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

}  // namespace shoal
