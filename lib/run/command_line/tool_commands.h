// The commands of `shoal` that are programs of their own, as git has them: `shoal campaign ...`
// becomes `shoal-campaign ...`, so that `shoal` links nothing of lib/tools. Such a program is
//
//   int main(int argc, char** argv) {
//     return shoal::RunToolCommand("campaign", argc, argv, shoal::AddCampaignCommands);
//   }
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"

namespace shoal {

/// Adds the command to those that `shoal --help` lists; StartToolCommand runs it.
/// @pre kToolCommands has the name (tool_commands.cc)
void ListToolCommand(const Program& shoal, std::string_view name);

/// Where the words name a command that is a program of its own, turns this process into it. Returns
/// kExitEnvironment, with an error, where that fails; nothing where they name none.
std::optional<int> StartToolCommand(int argc, char** argv);

/// The main function of such a program: the command line of `shoal <name>`. `add` adds options and
/// subcommands; the chosen one sets `action`.
int RunToolCommand(std::string_view name, int argc, char** argv,
                   const std::function<void(Command command, CommandAction* action)>& add);

/// Turns this process into the program at this path, with these words after its name. Returns
/// kExitEnvironment, with an error, where that fails.
int BecomeProgram(const std::string& path, std::vector<std::string> words);

}  // namespace shoal
