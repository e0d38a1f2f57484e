#include "lib/base/text/terminal_text.h"

#include <algorithm>

namespace shoal {

namespace {

constexpr unsigned char kDelete = 0x7f;

bool Continues(std::string_view text, size_t at) {
  return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
}

/// True for U+2028 to U+202E and U+2066 to U+2069: they begin a line, or let a terminal show what
/// follows from right to left, so that a text looks like another.
bool IsOrderOrLine(std::string_view character) {
  return (character >= "\xe2\x80\xa8" && character <= "\xe2\x80\xae") ||
         (character >= "\xe2\x81\xa6" && character <= "\xe2\x81\xa9");
}

/// Returns how many bytes the UTF-8 character at the front has; 0: it is not one, or is not
/// shown. Table 3-7 of the Unicode standard has the ranges of the second byte.
size_t PrintableLength(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return first >= ' ' && first != kDelete ? 1 : 0;
  const auto second = static_cast<unsigned char>(text.size() > 1 ? text[1] : '\0');
  const auto is_second = [&](unsigned char low, unsigned char high) {
    return second >= low && second <= high;
  };
  size_t length = 0;
  if (first == 0xc2) {
    length = is_second(0xa0, 0xbf) ? 2 : 0;  // Below lie the C1 control characters.
  } else if (first >= 0xc3 && first <= 0xdf) {
    length = is_second(0x80, 0xbf) ? 2 : 0;
  } else if (first >= 0xe0 && first <= 0xef) {
    length = is_second(first == 0xe0 ? 0xa0 : 0x80, first == 0xed ? 0x9f : 0xbf) ? 3 : 0;
  } else if (first >= 0xf0 && first <= 0xf4) {
    length = is_second(first == 0xf0 ? 0x90 : 0x80, first == 0xf4 ? 0x8f : 0xbf) ? 4 : 0;
  }
  for (size_t at = 2; at < length; ++at) {
    if (!Continues(text, at)) return 0;
  }
  return IsOrderOrLine(text.substr(0, length)) ? 0 : length;
}

}  // namespace

std::string TerminalText(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const size_t length = PrintableLength(text);
    if (length > 0) {
      shown += text.substr(0, length);
    } else {
      shown += text[0] == '\n' ? '\n' : text[0] == '\t' ? ' ' : '?';
    }
    text.remove_prefix(std::max(length, size_t{1}));
  }
  return shown;
}

std::string TerminalLine(std::string_view text, size_t most_bytes) {
  const bool is_cut = text.size() > most_bytes;
  std::string line = TerminalText(text.substr(0, most_bytes));
  std::replace(line.begin(), line.end(), '\n', '?');
  return is_cut ? line + "..." : line;
}

}  // namespace shoal
