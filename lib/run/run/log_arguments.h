// What several commands of `shoal log` take.
#pragma once

#include <string>
#include <vector>

#include "lib/bus/record/log_commands.h"
#include "lib/run/command_line/command.h"

namespace shoal {

/// The text of a log's argument.
inline constexpr char kLogArgument[] = "LCM event log, or the folder of a recording";

/// Adds the options that choose channels and times. `selection` lives until the words are parsed.
void AddLogSelection(Command command, LogSelection* selection);

/// Adds --types. `types` lives until the words are parsed.
void AddLogTypes(Command command, std::vector<std::string>* types);

}  // namespace shoal
