#include "lib/run/command_line/tool_commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <utility>
#include <vector>

#include "lib/base/check/check.h"
#include "lib/base/check/result.h"
#include "lib/run/command_line/find_program.h"

namespace shoal {

namespace {

struct ToolCommand {
  std::string_view name;
  std::string_view text;  ///< What it does, in a line.
};

constexpr ToolCommand kToolCommands[] = {
    {"campaign", "Run a mission many times, and answer questions about it"},
    {"encounters", "Write mission files of encounters, or run many"},
    {"import", "Make a mission of MOOS-IvP mission files (.moos, .bhv)"},
    {"log", "Read logs"},
    {"plot", "Draw a log's tracks and curves (gnuplot)"},
    {"rebroker", "Route the recorded reports again, by other rules"},
};

const ToolCommand* FindToolCommand(std::string_view name) {
  const auto* found = std::find_if(std::begin(kToolCommands), std::end(kToolCommands),
                                   [name](const ToolCommand& each) { return each.name == name; });
  return found == std::end(kToolCommands) ? nullptr : found;
}

Command AddToolCommand(const Program& shoal, std::string_view name) {
  const ToolCommand* tool = FindToolCommand(name);
  SHOAL_CHECK(tool != nullptr, "kToolCommands has the command");
  return shoal.AddSubcommand(std::string(name), std::string(tool->text));
}

}  // namespace

void ListToolCommand(const Program& shoal, std::string_view name) { AddToolCommand(shoal, name); }

std::optional<int> StartToolCommand(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  // `shoal --help log` and `shoal help log` are `shoal log --help`.
  if (!words.empty() && words.front() == "help") words.front() = "--help";
  const auto is_help = [](const std::string& word) { return word == "--help" || word == "-h"; };
  const auto name = std::find_if_not(words.begin(), words.end(), is_help);
  if (name == words.end() || FindToolCommand(*name) == nullptr) return std::nullopt;
  const std::string command = *name;
  const std::string tool = "shoal-" + command;
  const Result<std::string> program = FindBeside(tool);
  if (!program.ok()) {
    fmt::print(stderr, "shoal {} needs the program {}, which {}\n", command, tool,
               WhyMissing(tool));
    return kExitEnvironment;
  }
  words.erase(name);
  return BecomeProgram(*program, std::move(words));
}

int RunToolCommand(std::string_view name, int argc, char** argv,
                   const std::function<void(Command command, CommandAction* action)>& add) {
  Program shoal = MakeShoalCommand();
  CommandAction action;
  add(AddToolCommand(shoal, name), &action);
  std::vector<std::string> words = {"shoal", std::string(name)};
  words.insert(words.end(), argv + std::min(argc, 1), argv + argc);
  return RunCommandLine(shoal, &action, words);
}

int BecomeProgram(const std::string& path, std::vector<std::string> words) {
  words.insert(words.begin(), path);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::fflush(stdout);
  execv(argv[0], argv.data());
  fmt::print(stderr, "shoal: cannot run {}: {}\n", path, std::strerror(errno));
  return kExitEnvironment;
}

}  // namespace shoal
