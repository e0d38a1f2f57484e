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
  std::string_view of;  ///< The command that it is a part of.
  std::string_view name;
  std::string_view program;
  std::string_view text;  ///< What it does, in a line.
};

constexpr ToolCommand kToolCommands[] = {
    {"", "log", "shoal-log", "Read logs"},
    {"", "play", "shoal-play", "Publish a recording on LCM, as if its mission ran"},
    {"", "import", "shoal-import", "Make a mission of MOOS-IvP mission files (.moos, .bhv)"},
    {"", "plot", "shoal-plot", "Draw a log's tracks and curves (gnuplot)"},
    {"", "rays", "shoal-rays", "List and draw the paths of sound between two places"},
    {"", "rebroker", "shoal-rebroker", "Route the recorded reports again, by other rules"},
    {"", "encounters", "shoal-encounters", "Write mission files of encounters, or run many"},
    {"", "campaign", "shoal-campaign", "Run a mission many times, and answer questions about it"},
    {"log", "mcap", "shoal-log-export", "One MCAP file, for Foxglove, Rerun and PlotJuggler"},
    {"log", "sqlite", "shoal-log-export",
     "One SQLite database: a table per channel, fates, mission"},
};

const ToolCommand* FindToolCommand(std::string_view of, std::string_view name) {
  const auto* found =
      std::find_if(std::begin(kToolCommands), std::end(kToolCommands),
                   [&](const ToolCommand& each) { return each.of == of && each.name == name; });
  return found == std::end(kToolCommands) ? nullptr : found;
}

}  // namespace

Command AddToolCommand(const Command& parent, std::string_view of, std::string_view name) {
  const ToolCommand* tool = FindToolCommand(of, name);
  SHOAL_CHECK(tool != nullptr, "kToolCommands has the command");
  return parent.AddSubcommand(std::string(name), std::string(tool->text));
}

void ListToolCommands(const Command& parent, std::string_view of) {
  for (const ToolCommand& each : kToolCommands) {
    if (each.of == of) AddToolCommand(parent, of, each.name);
  }
}

std::optional<int> StartToolCommand(int argc, char** argv, std::string_view of) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  // `shoal --help log` and `shoal help log` are `shoal log --help`.
  if (!words.empty() && words.front() == "help") words.front() = "--help";
  const auto is_help = [](const std::string& word) { return word == "--help" || word == "-h"; };
  const auto name = std::find_if_not(words.begin(), words.end(), is_help);
  if (name == words.end()) return std::nullopt;
  const ToolCommand* tool = FindToolCommand(of, *name);
  if (tool == nullptr) return std::nullopt;
  const std::string program(tool->program);
  const Result<std::string> path = FindBeside(program);
  if (!path.ok()) {
    fmt::print(stderr, "shoal {}{}{} needs the program {}, which {}\n", of, of.empty() ? "" : " ",
               tool->name, program, WhyMissing(program));
    return kExitEnvironment;
  }
  // Programs of one command begin with what it takes, those of several with its name.
  if (of.empty()) {
    words.erase(name);
  } else {
    std::rotate(words.begin(), name, name + 1);
  }
  return BecomeProgram(*path, std::move(words));
}

int RunToolCommand(std::string_view name, int argc, char** argv,
                   const std::function<void(Command command, CommandAction* action)>& add) {
  Program shoal = MakeShoalCommand();
  CommandAction action;
  add(AddToolCommand(shoal, "", name), &action);
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
