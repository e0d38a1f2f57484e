// Reads the rules of a broker alone: from a whole mission file, or from a file that holds a table
// [comms], with or without [acoustics], and nothing else.
//
//   LoadedComms loaded = LoadComms("quiet.toml");
//   if (!loaded.errors.empty()) { print them; exit 2; }
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/comms/routing/rules.h"
#include "lib/mission/model/mission.h"

namespace shoal {

struct LoadedComms {
  RoutingRules rules;                  ///< Usable only where `errors` is empty.
  std::optional<Acoustics> acoustics;  ///< Where the file has the table, or is a whole mission's.
  std::optional<Mission> mission;      ///< Where the file is a whole mission's.
  std::vector<std::string> errors;     ///< "file:line:column: what is wrong", in file order.
  std::vector<std::string> warnings;   ///< The same for what is suspicious but legal.
};

/// Reads `path`. A file with [mission], [[vehicle]] or [[fleet]] is a mission file, and must be a
/// sound one.
[[nodiscard]] LoadedComms LoadComms(const std::string& path);

/// The same for text that is already in memory; `name` stands for the file in messages.
[[nodiscard]] LoadedComms LoadCommsText(std::string_view text, const std::string& name);

/// Returns the rules as [comms] writes them, a line for each key: "comms_range = 100".
[[nodiscard]] std::vector<std::string> ExplainComms(const RoutingRules& rules);

}  // namespace shoal
