// A MOOS mission file as lines, without their meaning.
//
//   ServerPort = 9000            // a global
//   ProcessConfig = uSimMarine   // a block
//   {
//     start_pos = x=0,y=-20
//   }
//
// `//` begins a comment, anywhere in a line. Nothing is an error: what is neither of the above is
// listed with the reason.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shoal {

struct MoosLine {
  int number = 0;     ///< Counts from 1.
  std::string text;   ///< "KEY = VALUE".
  std::string key;    ///< Before the first '='.
  std::string value;  ///< Behind it, without blanks and ';' at the end.
};

struct MoosBlock {
  std::string app;
  int number = 0;  ///< Of the line that names it.
  std::vector<MoosLine> lines;
};

/// A line that has no meaning as it stands.
struct MoosOddLine {
  int number = 0;
  std::string text;
  std::string reason;  ///< With the remedy.
};

struct MoosFile {
  std::string name;  ///< Stands before line numbers.
  std::vector<MoosLine> globals;
  std::vector<MoosBlock> blocks;
  std::vector<MoosOddLine> odd_lines;
};

/// Reads any text. A line that nsplug should have replaced is odd, but for $(NAME) in blocks of
/// apps with macros of their own, pMarineViewer and uTimerScript. Control characters and bytes that
/// are not UTF-8 become '?'.
[[nodiscard]] MoosFile ParseMoosFile(std::string_view text, std::string_view name);

/// Returns `text` as one line of UTF-8: control characters and bytes that are not UTF-8 are '?'.
[[nodiscard]] std::string CleanUtf8(std::string_view text);

}  // namespace shoal
