#include "lib/run/command_line/command_line.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <optional>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/command_line/version_text.h"

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
std::optional<int> CheckCommandWords(const CLI::App& shoal, std::span<const std::string> words) {
  const CLI::App* command = &shoal;
  for (const std::string& word : words) {
    const std::vector<const CLI::App*> subcommands = command->get_subcommands({});
    if (subcommands.empty() || word.starts_with('-')) return std::nullopt;
    std::vector<std::string_view> names;
    const CLI::App* named = nullptr;
    for (const CLI::App* each : subcommands) {
      names.push_back(each->get_name());
      if (each->get_name() == word) named = each;
    }
    if (named == nullptr) {
      const std::string path = command == &shoal ? "shoal" : "shoal " + command->get_name();
      fmt::print(stderr, "{}: unknown command {}{}\nCommands: {}\n`{} --help` describes them\n",
                 path, Quoted(word), DidYouMean(word, names), Joined(names), path);
      return kExitUsage;
    }
    command = named;
  }
  if (command->get_subcommands({}).empty()) return std::nullopt;
  fmt::print("{}", command->help(command == &shoal ? "" : "shoal"));
  return kExitUsage;
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

std::shared_ptr<CLI::App> MakeShoalCommand() {
  auto shoal = std::make_shared<CLI::App>(
      "shoal runs missions of several vehicles over a lossy acoustic network.", "shoal");
  shoal->set_version_flag("--version", VersionText("shoal"));
  shoal->require_subcommand(1);
  return shoal;
}

int RunCommandLine(CLI::App& shoal, const CommandAction* action,
                   const std::vector<std::string>& words) {
  return WithWrittenOutput([&] {
    if (const auto code = CheckCommandWords(shoal, std::span(words).subspan(1))) return *code;
    try {
      // CLI11 takes words from the end.
      shoal.parse(std::vector<std::string>(words.rbegin(), words.rend() - 1));
    } catch (const CLI::ParseError& error) {
      return static_cast<int>(shoal.exit(error) == 0 ? kExitOk : kExitUsage);
    }
    return (*action)();
  });
}

}  // namespace shoal
