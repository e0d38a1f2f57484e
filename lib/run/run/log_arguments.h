// What several commands of `shoal log` take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/record/channel_choice.h"
#include "lib/bus/record/log_commands.h"
#include "lib/run/command_line/command.h"

namespace shoal {

/// The text of a log's argument.
inline constexpr char kLogArgument[] = "LCM event log, or the folder of a recording";

/// Adds --channels, with its other name --channel, and --without: the one definition for all
/// commands. `verb`: what is done with the channels, "Log". The choice lives until the words are
/// parsed.
void AddChannelChoice(Command command, ChannelChoice* choice, std::string_view verb = "Log");

/// Adds --without alone.
void AddWithout(Command command, std::vector<std::string>* without);

/// Adds the options that choose channels and times. `selection` lives until the words are parsed.
void AddLogSelection(Command command, LogSelection* selection);

/// Adds --types. `types` lives until the words are parsed.
void AddLogTypes(Command command, std::vector<std::string>* types);

}  // namespace shoal
