// A behavior file of MOOS-IvP's helm as blocks, without their meaning.
//
//   initialize DEPLOY = false, RETURN = false
//
//   set MODE = ACTIVE {
//     DEPLOY = true
//   } INACTIVE
//
//   Behavior = BHV_Waypoint
//   {
//     name   = survey
//     points = 0,0 : 100,0
//   }
//
// `//` begins a comment; a line that ends with a backslash goes on in the next. nsplug's lines are
// resolved (nsplug.h). Nothing is an error: what is not one of these is listed with the reason.
#pragma once

#include <string>
#include <vector>

#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

/// `set VARIABLE = VALUE { ... } OTHERWISE`.
struct BhvMode {
  std::string origin;  ///< Of its first line.
  std::string variable;
  std::string value;
  std::string otherwise;             ///< Empty: none.
  std::vector<MoosLine> conditions;  ///< Only origin and text.
};

struct BhvBlock {
  std::string type;    ///< "BHV_Waypoint".
  std::string origin;  ///< Of the line that names it.
  std::vector<MoosLine> lines;
};

struct BhvFile {
  std::string name;
  std::vector<MoosLine> initials;  ///< One for each variable.
  std::vector<BhvMode> modes;
  std::vector<BhvBlock> behaviors;
  std::vector<MoosOddLine> odd_lines;
};

/// Reads any text. A line with a macro that has no value is odd, but in conditions and flags, where
/// $(NAME) is a variable's value.
[[nodiscard]] BhvFile ParseBhvFile(const PluggedText& text);

}  // namespace shoal
