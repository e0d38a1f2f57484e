// Texts of others on their way to a terminal, which would execute what they hold: ESC [ 2 J clears
// it, a line feed begins a line that looks like one of our own.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace shoal {

/// Returns `text` with '?' for each byte of a control character (C0, DEL, and C1 as UTF-8 has
/// them), of a character that turns the direction of what follows (U+202A to U+202E, U+2066 to
/// U+2069) or ends a line (U+2028, U+2029), and for each byte that is not part of UTF-8; line feeds
/// stay, tabs become blanks.
[[nodiscard]] std::string TerminalText(std::string_view text);

/// Returns the same as one line, with '?' for line feeds too, cut behind `most_bytes`.
[[nodiscard]] std::string TerminalLine(std::string_view text, size_t most_bytes = 1000);

}  // namespace shoal
