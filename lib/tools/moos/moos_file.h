// A MOOS mission file as lines, without their meaning.
//
//   ServerPort = 9000            // a global
//   ProcessConfig = uSimMarine   // a block
//   {
//     start_pos = x=0,y=-20
//   }
//
// `//` begins a comment, anywhere in a line. nsplug's lines are resolved (nsplug.h). Nothing is an
// error: what is not one of these is listed with the reason.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/nsplug.h"

namespace shoal {

struct MoosLine {
  int number = 0;           ///< PluggedLine::number.
  std::string origin = {};  ///< "a.moos:12".
  std::string text;         ///< "KEY = VALUE".
  std::string key;          ///< Before the first '='.
  std::string value;        ///< Behind it, without blanks and ';' at the end.
};

struct MoosBlock {
  std::string app;
  int number = 0;      ///< Of the line that names it.
  std::string origin;  ///< Of that line.
  std::vector<MoosLine> lines;
};

/// A line that has no meaning as it stands.
struct MoosOddLine {
  int number = 0;
  std::string origin;
  std::string text;
  std::string reason;   ///< With the remedy.
  bool is_loss = true;  ///< False: nothing of the mission is lost.
};

struct MoosFile {
  std::string name;  ///< Stands before line numbers.
  std::vector<MoosLine> globals;
  std::vector<MoosBlock> blocks;
  std::vector<MoosOddLine> odd_lines;
  /// Apps of lines `// Run = uTimerScript` that are switched off.
  std::vector<std::string> stopped_apps = {};
};

/// Reads any text. A line with a macro that has no value is odd, but for $(NAME) in blocks of apps
/// with macros of their own, pMarineViewer and uTimerScript. Control characters and bytes that are
/// not UTF-8 become '?'.
[[nodiscard]] MoosFile ParseMoosFile(const PluggedText& text);

/// The same of a text that includes no other.
[[nodiscard]] MoosFile ParseMoosFile(std::string_view text, std::string_view name);

}  // namespace shoal
