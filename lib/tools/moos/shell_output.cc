#include "lib/tools/moos/shell_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {
namespace {

/// Returns what `expr 1 + 2` prints; its comparisons and functions of texts are not known.
std::string Expr(const ShellWords& words, int line, ShellRun* run) {
  const auto is_number = [](std::string_view word) {
    if (word.starts_with('-')) word.remove_prefix(1);
    return !word.empty() && std::all_of(word.begin(), word.end(), IsDigit);
  };
  bool needs_number = true;
  bool is_sum = true;
  for (size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    const bool is_sign = word == "+" || word == "-" || word == "*" || word == "/" || word == "%";
    if (word == "(" || word == ")") {
      is_sum = is_sum && needs_number == (word == "(");
    } else {
      is_sum = is_sum && (needs_number ? is_number(word) : is_sign);
      needs_number = !needs_number;
    }
  }
  const std::string text = JoinShellWords({words.begin() + 1, words.end()});
  if (is_sum && !needs_number)
    return run->Sum(text, line, [](std::string_view) { return std::string_view(); });
  run->Note(line, fmt::format("the output of {} is not known", Quoted("expr " + text)));
  return "";
}

std::string_view WithoutSlashes(std::string_view path) {
  while (path.size() > 1 && path.ends_with('/')) path.remove_suffix(1);
  return path;
}

std::string FolderOf(std::string_view path) {
  path = WithoutSlashes(path);
  const size_t slash = path.rfind('/');
  if (slash == path.npos) return ".";
  return std::string(WithoutSlashes(path.substr(0, std::max<size_t>(slash, 1))));
}

std::string BaseName(const ShellWords& words) {
  const std::string_view path = WithoutSlashes(words[1]);
  std::string name = path == "/" ? "/" : FileName(path);
  if (words.size() > 2 && name.size() > words[2].size() && name.ends_with(words[2])) {
    name.resize(name.size() - words[2].size());
  }
  return name;
}

/// Returns what pickpos prints of names, colors and speeds; places are random there, and are none
/// here.
std::string Picked(const ShellWords& words, int line, ShellRun* run) {
  constexpr std::string_view kNames[] = {"abe", "ben", "cal", "deb", "eve",
                                         "fin", "max", "ned", "oak", "pal"};
  constexpr std::string_view kColors[] = {"yellow", "red",   "dodgerblue", "green", "purple",
                                          "orange", "white", "cyan",       "pink",  "gold"};
  constexpr size_t kMostPicked = 100;
  size_t amount = 1;
  std::string what;
  std::string speed;
  for (const std::string& word : words) {
    if (word.starts_with("--amt=")) {
      const double number = NumberIn(std::string_view(word).substr(6)).value_or(1);
      amount = static_cast<size_t>(std::clamp(number, 1.0, static_cast<double>(kMostPicked)));
    } else if (word == "--vnames" || word == "--colors") {
      what = word;
    } else if (word.starts_with("--spd=")) {
      what = "--spd";
      speed = word.substr(6, word.find(':') == word.npos ? word.npos : word.find(':') - 6);
    }
  }
  if (what.empty()) {
    run->Note(line, "the places of pickpos are random: give them in --vehicle");
    return "";
  }
  std::string list;
  for (size_t i = 0; i < amount; ++i) {
    std::string one = speed;
    if (what != "--spd") {
      one = what == "--vnames" ? kNames[i % std::size(kNames)] : kColors[i % std::size(kColors)];
    }
    if (what == "--vnames" && i >= std::size(kNames)) one += std::to_string(i / std::size(kNames));
    list += one + "\n";
  }
  return list;
}

}  // namespace

std::string ShellOutput(const ShellWords& words, int line, ShellRun* run) {
  if (words.empty()) return "";
  const std::string& name = words.front();
  if (name == "seq") {
    const auto last = NumberIn(words.back());
    const auto first = words.size() > 2 ? NumberIn(words[1]) : std::optional<double>(1);
    std::string list;
    constexpr int kMost = 1'000;
    if (first && last) {
      // Counted in whole steps: a number beyond 2^53 plus one is itself.
      for (int step = 0; step <= kMost && *first + step <= *last; ++step) {
        list += fmt::format("{}{:.0f}", list.empty() ? "" : " ", *first + step);
      }
    }
    return list;
  }
  const bool has_path = words.size() > 1 && !words[1].starts_with('-');
  if (name == "basename" && has_path) return BaseName(words);
  if (name == "dirname" && has_path) return FolderOf(words[1]);
  if (name == "echo") return JoinShellWords({words.begin() + 1, words.end()});
  if (name == "expr") return Expr(words, line, run);
  if (name == "pickpos") return Picked(words, line, run);
  if (name == "cat" && words.size() > 1) {
    if (const std::string* made = run->FindMade(words[1])) return *made;
    if (const auto found = run->Find(words[1])) return found->text.substr(0, kMaxShellText);
    run->Note(line, fmt::format("{} is not there", Quoted(words[1])));
    return "";
  }
  constexpr std::string_view kOfThisMachine[] = {"date", "pwd", "whoami", "hostname", "id", "cd"};
  if (std::find(std::begin(kOfThisMachine), std::end(kOfThisMachine), name) ==
      std::end(kOfThisMachine)) {
    run->Note(line, fmt::format("the output of {} is not known", Quoted(name)));
  }
  return "";
}

}  // namespace shoal
