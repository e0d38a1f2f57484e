// The words of a command line: commands with options, as a thin layer over CLI11, which costs
// seconds of compile time in each file that includes it. command.cc alone does.
//
//   Program program("sounder", "Measures the depth.");
//   std::string log;
//   double rate_hz = 1;
//   program.AddOption("LOG", &log, "Log file to write")->Required();  // by position
//   program.AddOption("--rate,-r", &rate_hz, "Soundings per second").InRange(0.1, 10.0);
//   program.ParseOrExit(argc, argv);
//
// A name with dashes is that of an option, one without that of a value by its position; commas part
// several names. What is read goes to the variable, which must live until the words are parsed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace shoal {

/// An option, a flag or a value by its position; the Program of its command owns it. Functions
/// that restrict it return it, so that calls can be chained.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}

  Option Required() const;
  /// May be given only together with `other`.
  Option Needs(Option other) const;
  /// May not be given together with `other`.
  Option Excludes(Option other) const;

  /// `check` returns what is wrong with a value, or nothing.
  Option Check(std::function<std::string(const std::string& text)> check) const;
  /// A number from `low` to `high`, both included.
  Option InRange(int64_t low, int64_t high) const;
  Option InRange(int low, int high) const;
  Option InRange(double low, double high) const;
  Option OneOf(std::vector<std::string> words) const;

  /// Of a list: may be given several times, with any number of values each time.
  Option TakeAll() const;
  /// Of a list: may be given several times, with one value each time.
  Option Repeatable() const;
  /// May be given several times, the last counts.
  Option TakeLast() const;
  /// May be given without a value.
  Option WithOptionalValue() const;

  /// Replaces the text of --help.
  Option Description(const std::string& text) const;
  /// Replaces, in --help, type and conditions behind the name.
  Option OptionText(const std::string& text) const;

  /// Returns true where the command line has it. @pre called by a callback of the command
  bool IsGiven() const;

 private:
  CLI::Option* option_;
};

/// A command; the Program that it is part of owns it.
class Command {
 public:
  explicit Command(CLI::App* command) : command_(command) {}

  Option AddFlag(const std::string& names, bool* value, const std::string& text) const;
  Option AddOption(const std::string& names, int* value, const std::string& text) const;
  Option AddOption(const std::string& names, int64_t* value, const std::string& text) const;
  Option AddOption(const std::string& names, uint64_t* value, const std::string& text) const;
  Option AddOption(const std::string& names, double* value, const std::string& text) const;
  Option AddOption(const std::string& names, std::string* value, const std::string& text) const;
  Option AddOption(const std::string& names, std::optional<int>* value,
                   const std::string& text) const;
  Option AddOption(const std::string& names, std::optional<int64_t>* value,
                   const std::string& text) const;
  Option AddOption(const std::string& names, std::optional<double>* value,
                   const std::string& text) const;
  Option AddOption(const std::string& names, std::vector<std::string>* values,
                   const std::string& text) const;

  Command AddSubcommand(const std::string& name, const std::string& text) const;
  /// One of the subcommands must be named.
  void RequireSubcommand() const;

  /// Calls `chosen` after the command line has been read, where it names this command.
  void Callback(std::function<void()> chosen) const;
  /// The same; `chosen` returns what is wrong with the command line, or nothing.
  void CheckedCallback(std::function<std::string()> chosen) const;

  /// Shown at the end of --help.
  void Footer(const std::string& text) const;
  /// From the first word that is neither an option nor a value of it, all words are Remaining().
  void PrefixCommand() const;
  [[nodiscard]] std::vector<std::string> Remaining() const;
  /// Returns true where the command line names it. @pre called by a callback
  [[nodiscard]] bool IsParsed() const;

  [[nodiscard]] std::string Name() const;
  [[nodiscard]] std::vector<Command> Subcommands() const;
  /// Returns what --help prints; `before`: the words before its name.
  [[nodiscard]] std::string Help(const std::string& before) const;

 protected:
  CLI::App* command_;
};

/// The command that is a program, with --help and --version; owns its subcommands and options.
class Program : public Command {
 public:
  /// `version_names`: those of the option that prints VersionText(name).
  Program(const std::string& name, const std::string& text,
          const std::string& version_names = "--version");
  ~Program();
  Program(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  Program& operator=(Program&&) = delete;

  /// Reads the words behind the program's name, and calls the callbacks of the commands that they
  /// name. Returns nothing where the program is to go on; else the exit code: kExitOk, where help
  /// or version have been printed, or kExitUsage, where an error has.
  [[nodiscard]] std::optional<int> Parse(const std::vector<std::string>& words);
  /// The same, and ends the process with the exit code, where there is one.
  void ParseOrExit(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> owned_;
};

/// Returns the words between blanks; one that begins with a quote ends at the next.
[[nodiscard]] std::vector<std::string> SplitWords(const std::string& line);

}  // namespace shoal
