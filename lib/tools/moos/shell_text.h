// The text of a shell script: its commands, their words, and patterns. Nothing is run, and no
// variable is known here.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// No value of a variable, and no replacement in one, is longer.
inline constexpr size_t kMaxShellText = 100'000;

/// A command as it is written, on one line.
struct ShellCommand {
  int line = 0;
  std::string text;
};

using ShellWords = std::vector<std::string>;

/// Returns the length of a quoted or bracketed part that begins at `at`; 1 for any other character.
/// @pre at < text.size()
[[nodiscard]] size_t ShellPartLength(std::string_view text, size_t at);

/// Cuts a script into commands; words such as `then` and `do`, and
/// the ";;" of a `case`, are commands of their own.
[[nodiscard]] std::vector<ShellCommand> ShellCommandsOf(std::string_view text);

/// Returns the index of the command that ends the block that begins at `at`, or one of `middle`
/// on its level; `end` where there is none.
[[nodiscard]] size_t ShellBlockEnd(const std::vector<ShellCommand>& commands, size_t at, size_t end,
                                   const std::set<std::string>& middle);

/// Returns how many braces a command opens more than it closes; sets `is_open` where it opens one.
[[nodiscard]] int ShellBraces(std::string_view text, bool* is_open);

[[nodiscard]] std::string FirstShellWord(std::string_view text);

/// Cuts a command at blanks; quotes stay.
[[nodiscard]] ShellWords RawShellWords(std::string_view text);

/// Cuts a value at blanks, whatever quotes are in it.
[[nodiscard]] ShellWords AtShellBlanks(std::string_view text);

/// Returns the words with a blank between them.
[[nodiscard]] std::string JoinShellWords(const ShellWords& words);

/// Returns true where a pattern with '*' and '?' is the whole text.
[[nodiscard]] bool MatchesShell(std::string_view pattern, std::string_view text);

/// Returns ${X//text/}: "[^0-9]", or "a/b", every a replaced by b.
[[nodiscard]] std::string WithoutAll(std::string value, std::string_view text);
/// Returns ${X#pattern}, or ${X##pattern}; `text` has the signs before the pattern. The steps are
/// the square of the value's length.
[[nodiscard]] std::string WithoutPrefix(const std::string& value, std::string_view text);
/// Returns ${X%pattern}, or ${X%%pattern}, likewise.
[[nodiscard]] std::string WithoutSuffix(const std::string& value, std::string_view text);

}  // namespace shoal
