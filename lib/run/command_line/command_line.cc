#include "lib/run/command_line/command_line.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>

#include "lib/base/check/result.h"
#include "lib/bus/os/standard_descriptors.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

/// True where standard output is a pipe without a reader, as behind `| head`. (Where SIGPIPE is
/// not ignored, it ends the process before this is called.)
bool ReaderHasLeft() {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

/// Follows the words that name a command and its subcommands, up to the first option. Returns an
/// exit code where one names none (the error has been printed) or is missing (the list has).
std::optional<int> CheckCommandWords(const Command& shoal, std::span<const std::string> words) {
  Command command = shoal;
  bool is_shoal = true;
  // `shoal help run` is `shoal run --help`.
  const bool is_help = !words.empty() && words.front() == "help";
  if (is_help) words = words.subspan(1);
  for (const std::string& word : words) {
    const std::vector<Command> subcommands = command.Subcommands();
    if (subcommands.empty() || word.starts_with('-')) return std::nullopt;
    std::vector<std::string> names;
    names.reserve(subcommands.size());
    for (const Command& each : subcommands) names.push_back(each.Name());
    const auto named = std::find(names.begin(), names.end(), word);
    if (named == names.end()) {
      const std::string path = is_shoal ? "shoal" : "shoal " + command.Name();
      const std::vector<std::string_view> valid(names.begin(), names.end());
      fmt::print(stderr, "{}: unknown command {}{}\nCommands: {}\n`{} --help` describes them\n",
                 path, Quoted(word), DidYouMean(word, valid), Joined(valid), path);
      return kExitUsage;
    }
    command = subcommands[static_cast<size_t>(named - names.begin())];
    is_shoal = false;
  }
  if (command.Subcommands().empty() && !is_help) return std::nullopt;
  fmt::print("{}", command.Help(is_shoal ? "" : "shoal"));
  return is_help ? kExitOk : kExitUsage;
}

/// Runs `action`, and returns its exit code; kExitEnvironment, with an error, where what it printed
/// could not be written. (fmt throws then, the streams only set a flag.)
int WithWrittenOutput(const CommandAction& action) {
  bool written = true;
  int code = kExitEnvironment;
  try {
    code = action();
  } catch (const std::system_error& error) {
    written = false;
    if (std::ferror(stdout) == 0) {
      std::fputs((std::string("shoal: ") + error.what() + "\n").c_str(), stderr);
      return kExitEnvironment;
    }
  }
  std::cout.flush();
  written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good() && written;
  if (written || ReaderHasLeft()) return code;
  std::fputs("shoal: cannot write to standard output: is the disk full?\n", stderr);
  return kExitEnvironment;
}

}  // namespace

Program MakeShoalCommand() {
  Program shoal("shoal", "shoal runs missions of several vehicles over a lossy acoustic network.");
  shoal.RequireSubcommand();
  return shoal;
}

int RunCommandLine(Program& shoal, const CommandAction* action,
                   const std::vector<std::string>& words) {
  TakeStandardDescriptors();
  return WithWrittenOutput([&] {
    if (const auto code = CheckCommandWords(shoal, std::span(words).subspan(1))) return *code;
    if (const auto code = shoal.Parse({words.begin() + 1, words.end()})) return *code;
    return (*action)();
  });
}

}  // namespace shoal
