#include "lib/run/command_line/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/command_line/version_text.h"

namespace shoal {

Option Option::Required() const { return Option(option_->required()); }

Option Option::Needs(Option other) const { return Option(option_->needs(other.option_)); }

Option Option::Excludes(Option other) const { return Option(option_->excludes(other.option_)); }

Option Option::Check(std::function<std::string(const std::string& text)> check) const {
  return Option(option_->check(std::move(check)));
}

Option Option::InRange(int64_t low, int64_t high) const {
  return Option(option_->check(CLI::Range(low, high)));
}

Option Option::InRange(int low, int high) const { return InRange(int64_t{low}, int64_t{high}); }

Option Option::InRange(double low, double high) const {
  return Option(option_->check(CLI::Range(low, high)));
}

Option Option::OneOf(std::vector<std::string> words) const {
  return Option(option_->check(CLI::IsMember(std::move(words))));
}

Option Option::TakeAll() const { return Option(option_->take_all()); }

Option Option::Repeatable() const { return Option(option_->take_all()->allow_extra_args(false)); }

Option Option::TakeLast() const { return Option(option_->take_last()); }

Option Option::WithOptionalValue() const { return Option(option_->expected(0, 1)); }

Option Option::Description(const std::string& text) const {
  return Option(option_->description(text));
}

Option Option::OptionText(const std::string& text) const {
  return Option(option_->option_text(text));
}

bool Option::IsGiven() const { return option_->count() > 0; }

Option Command::AddFlag(const std::string& names, bool* value, const std::string& text) const {
  return Option(command_->add_flag(names, *value, text));
}

Option Command::AddOption(const std::string& names, int* value, const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, int64_t* value, const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, uint64_t* value,
                          const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, double* value, const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, std::string* value,
                          const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, std::optional<int>* value,
                          const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, std::optional<int64_t>* value,
                          const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, std::optional<double>* value,
                          const std::string& text) const {
  return Option(command_->add_option(names, *value, text));
}

Option Command::AddOption(const std::string& names, std::vector<std::string>* values,
                          const std::string& text) const {
  return Option(command_->add_option(names, *values, text));
}

Command Command::AddSubcommand(const std::string& name, const std::string& text) const {
  return Command(command_->add_subcommand(name, text));
}

void Command::RequireSubcommand() const { command_->require_subcommand(1); }

void Command::Callback(std::function<void()> chosen) const {
  command_->callback(std::move(chosen));
}

void Command::CheckedCallback(std::function<std::string()> chosen) const {
  command_->callback([chosen = std::move(chosen)] {
    const std::string error = chosen();
    if (!error.empty()) throw CLI::ValidationError(error, CLI::ExitCodes::ValidationError);
  });
}

void Command::Footer(const std::string& text) const { command_->footer(text); }

void Command::PrefixCommand() const { command_->prefix_command(); }

std::vector<std::string> Command::Remaining() const { return command_->remaining(); }

bool Command::IsParsed() const { return command_->parsed(); }

std::string Command::Name() const { return command_->get_name(); }

std::vector<Command> Command::Subcommands() const {
  std::vector<Command> commands;
  for (CLI::App* each : command_->get_subcommands({})) commands.emplace_back(each);
  return commands;
}

std::string Command::Help(const std::string& before) const { return command_->help(before); }

Program::Program(const std::string& name, const std::string& text, const std::string& version_names)
    : Command(nullptr), owned_(std::make_unique<CLI::App>(text, name)) {
  command_ = owned_.get();
  command_->set_version_flag(version_names, VersionText(name));
}

Program::~Program() = default;

Program::Program(Program&& other) noexcept = default;

namespace {

/// Returns the command that the words name, the last of its line.
const CLI::App& NamedCommand(const CLI::App& program) {
  const CLI::App* command = &program;
  for (std::vector<CLI::App*> named = command->get_subcommands(); !named.empty();
       named = command->get_subcommands()) {
    command = named.front();
  }
  return *command;
}

std::vector<std::string> OptionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Returns the commands beside `command` that have the option: "`shoal run`".
std::string WhoHas(const std::string& option, const CLI::App& program, const CLI::App& command) {
  std::string text;
  for (const CLI::App* each : program.get_subcommands({})) {
    const std::vector<std::string> names = OptionsOf(*each);
    if (each == &command || std::ranges::find(names, option) == names.end()) continue;
    text +=
        fmt::format("{}`{} {}`", text.empty() ? "" : ", ", program.get_name(), each->get_name());
  }
  return text;
}

/// Returns what is wrong with the first word that is neither an option nor a value of one.
std::string UnexpectedText(const CLI::App& program) {
  const CLI::App& command = NamedCommand(program);
  const std::string path = &command == &program
                               ? program.get_name()
                               : fmt::format("{} {}", program.get_name(), command.get_name());
  const std::vector<std::string> words = program.remaining(true);
  const auto option = std::ranges::find_if(
      words, [](const std::string& word) { return word.starts_with("--") && word.size() > 2; });
  std::string what;
  if (option == words.end()) {
    what = fmt::format("{} is one word too many", Quoted(words.empty() ? "" : words.front()));
  } else {
    const std::string name = option->substr(0, option->find('='));
    const std::vector<std::string> names = OptionsOf(command);
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    what = fmt::format("unknown option {}{}", Quoted(name), DidYouMean(name, candidates));
    const std::string owners = WhoHas(name, program, command);
    if (!owners.empty()) what += fmt::format("; it is an option of {}", owners);
  }
  return fmt::format("{}: {}; `{} --help` lists what it takes\n", path, what, path);
}

}  // namespace

std::optional<int> Program::Parse(const std::vector<std::string>& words) {
  try {
    // CLI11 takes words from the end.
    owned_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ExtrasError&) {
    fmt::print(stderr, "{}", UnexpectedText(*owned_));
    return kExitUsage;
  } catch (const CLI::ParseError& error) {
    return owned_->exit(error) == 0 ? kExitOk : kExitUsage;
  }
  return std::nullopt;
}

void Program::ParseOrExit(int argc, char** argv) {
  if (const auto code = Parse({argv + std::min(argc, 1), argv + argc})) std::exit(*code);
}

std::vector<std::string> SplitWords(const std::string& line) { return CLI::detail::split_up(line); }

}  // namespace shoal
