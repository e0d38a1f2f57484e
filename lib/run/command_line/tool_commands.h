// The commands of `shoal` that are programs of their own, as git has them: `shoal campaign ...`
// becomes `shoal-campaign ...`, so that `shoal` links nothing of lib/tools. The main function of
// such a program is
//
//   int RunShoalCampaign(int argc, char** argv) {
//     return RunToolCommand("campaign", argc, argv, AddCampaignCommands);
//   }
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds such a command by its name and text, and returns it. `of`: the command that it is a part
/// of, as `log` of `shoal log mcap`; empty of `shoal` itself.
/// @pre kToolCommands has the name (tool_commands.cc)
Command AddToolCommand(const Command& parent, std::string_view of, std::string_view name);

/// Adds all such commands of `of`, for --help to list; StartToolCommand runs them.
void ListToolCommands(const Command& parent, std::string_view of);

/// Where the words name such a command of `of`, turns this process into its program. Returns
/// kExitEnvironment, with an error, where that fails; nothing where they name none.
std::optional<int> StartToolCommand(int argc, char** argv, std::string_view of = "");

/// The main function of such a program: the command line of `shoal <name>`. `add` adds options and
/// subcommands; the chosen one sets `action`.
int RunToolCommand(std::string_view name, int argc, char** argv,
                   const std::function<void(Command command, CommandAction* action)>& add);

/// Turns this process into the program at this path, with these words after its name. Returns
/// kExitEnvironment, with an error, where that fails.
int BecomeProgram(const std::string& path, std::vector<std::string> words);

}  // namespace shoal
