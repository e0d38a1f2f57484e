// A behavior file as tables of a mission file: [[vehicle.mode]], [vehicle.variables] and
// [[vehicle.behavior]].
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/mission_draft.h"

namespace shoal {

/// A table as a MissionDraft has it. One without settings is a list of comments.
struct BhvTable {
  std::string header;
  std::vector<DraftLine> lines;
};

/// A variable that a behavior of MOOS-IvP posts under a name of the file, and shoal's does not.
struct UnpostedVariable {
  std::string variable;
  std::string line;  ///< "a.bhv:12: KEY = VARIABLE".
};

struct BhvImport {
  std::vector<BhvTable> tables;
  std::vector<std::string> warnings;  ///< "a.bhv:12: TEXT: REASON".
  std::vector<std::string> lost;      ///< The same for each behavior and block that is left out.
  /// What conditions, updates and initialize lines name: a setting of another variable has no
  /// effect. In the letters of the file.
  std::set<std::string, std::less<>> variables;
  std::set<std::string, std::less<>> condition_variables;  ///< Those of conditions alone.
  std::set<std::string, std::less<>> words;  ///< All that may be a variable, in any line.
  std::vector<UnpostedVariable> unposted;
  size_t num_behaviors = 0;
};

/// Converts any file. At most 200 behaviors, modes and variables each; more are comments.
/// `contacts`: the other vehicles; a template of a kind that shoal does not spawn by alerts and
/// that asks for them becomes one behavior for each.
[[nodiscard]] BhvImport ImportBhv(const BhvFile& file,
                                  const std::vector<std::string>& contacts = {});

}  // namespace shoal
