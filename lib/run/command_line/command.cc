#include "lib/run/command_line/command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "lib/base/check/result.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/command_line/version_text.h"

namespace shoal {

namespace {

/// What a callback finds wrong, in words of its own.
struct CheckError : CLI::ParseError {
  explicit CheckError(const std::string& text)
      : CLI::ParseError("CheckError", text, CLI::ExitCodes::ValidationError) {}
};

/// Returns what is wrong with "nan" and "inf"; empty: nothing is. CLI11 itself refuses a text that
/// is not a number.
std::string IsFinite(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size() || std::isfinite(value)) return "";
  return fmt::format("{} is not a finite number", Quoted(text));
}

}  // namespace

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
  return Option(command_->add_option(names, *value, text)->check(IsFinite, ""));
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
  return Option(command_->add_option(names, *value, text)->check(IsFinite, ""));
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
    if (!error.empty()) throw CheckError(error);
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

/// The command that the words name, the last of its line, and the words that name it.
struct NamedCommand {
  const CLI::App* command;
  std::string path;
};

NamedCommand NamedBy(const CLI::App& program) {
  NamedCommand last{.command = &program, .path = program.get_name()};
  for (std::vector<CLI::App*> named = program.get_subcommands(); !named.empty();
       named = last.command->get_subcommands()) {
    last.command = named.front();
    last.path += " " + last.command->get_name();
  }
  return last;
}

std::vector<std::string> OptionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Returns the commands beside `command` that have the option: "`shoal run`".
std::string OwnersOf(const std::string& option, const CLI::App& program, const CLI::App& command) {
  std::string text;
  for (const CLI::App* each : program.get_subcommands({})) {
    const std::vector<std::string> names = OptionsOf(*each);
    if (each == &command || std::ranges::find(names, option) == names.end()) continue;
    text +=
        fmt::format("{}`{} {}`", text.empty() ? "" : ", ", program.get_name(), each->get_name());
  }
  return text;
}

/// "-q" and "--quiet" look like options, "-", "-5" and "-.5" do not.
bool LooksLikeAnOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '.' && (word[1] < '0' || word[1] > '9') &&
         word != "--";
}

/// Returns the first option among the words that no command takes, without its value; or nothing.
std::optional<std::string> UnknownOption(const CLI::App& program) {
  const std::vector<std::string> words = program.remaining(true);
  const auto option = std::ranges::find_if(words, LooksLikeAnOption);
  if (option == words.end()) return std::nullopt;
  return option->substr(0, option->find('='));
}

std::string UnknownOptionText(const std::string& option, const CLI::App& program,
                              const CLI::App& command) {
  const std::vector<std::string> names = OptionsOf(command);
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  // "-quiet" is "--quiet", and nothing is near enough to one letter.
  const std::string whole = option.starts_with("--") ? option : "-" + option;
  std::string text = "unknown option " + Quoted(option);
  if (whole.size() > 3) text += DidYouMean(whole, candidates);
  const std::string owners = OwnersOf(option, program, command);
  if (!owners.empty()) text += fmt::format("; it is an option of {}", owners);
  return text;
}

/// Prints what is wrong, with the command that it is wrong for, and how to see what that takes.
int PrintUsageError(const NamedCommand& named, const std::string& what) {
  fmt::print(stderr, "{}: {}; `{} --help` lists what it takes\n", named.path, what, named.path);
  return kExitUsage;
}

}  // namespace

std::optional<int> Program::Parse(const std::vector<std::string>& words) {
  try {
    // CLI11 takes words from the end.
    owned_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ExtrasError&) {
    const NamedCommand named = NamedBy(*owned_);
    if (const auto option = UnknownOption(*owned_)) {
      return PrintUsageError(named, UnknownOptionText(*option, *owned_, *named.command));
    }
    const std::vector<std::string> extra = owned_->remaining(true);
    return PrintUsageError(named,
                           Quoted(extra.empty() ? "" : extra.front()) + " is one word too many");
  } catch (const CLI::RequiredError& error) {
    // What is missing may be missing because an option was mistyped.
    const NamedCommand named = NamedBy(*owned_);
    if (const auto option = UnknownOption(*owned_)) {
      return PrintUsageError(named, UnknownOptionText(*option, *owned_, *named.command));
    }
    return PrintUsageError(named, error.what());
  } catch (const CheckError& error) {
    return owned_->exit(error) == 0 ? kExitOk : kExitUsage;
  } catch (const CLI::ParseError& error) {
    // Help and version come this way, too.
    if (error.get_exit_code() == 0) return owned_->exit(error) == 0 ? kExitOk : kExitUsage;
    return PrintUsageError(NamedBy(*owned_), error.what());
  }
  return std::nullopt;
}

void Program::ParseOrExit(int argc, char** argv) {
  if (const auto code = Parse({argv + std::min(argc, 1), argv + argc})) std::exit(*code);
}

std::vector<std::string> SplitWords(const std::string& line) { return CLI::detail::split_up(line); }

}  // namespace shoal
