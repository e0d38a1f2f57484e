#include "lib/tools/moos/launch_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr int kMaxCommands = 50'000;
constexpr int kDeepestScript = 8;
constexpr size_t kLongestText = 100'000;

/// A command as it is written, on one line.
struct ShellCommand {
  int line = 0;
  std::string text;
};

using Words = std::vector<std::string>;

/// Returns the length of a quoted or bracketed part that begins at `at`; 1 for any other character.
size_t PartLength(std::string_view text, size_t at) {
  const char c = text[at];
  if (c == '\\') return std::min<size_t>(2, text.size() - at);
  if (c == '\'' || c == '`') {
    const size_t end = text.find(c, at + 1);
    return end == text.npos ? text.size() - at : end + 1 - at;
  }
  if (c == '"') {
    for (size_t i = at + 1; i < text.size(); ++i) {
      if (text[i] == '\\') {
        ++i;
      } else if (text[i] == '"') {
        return i + 1 - at;
      }
    }
    return text.size() - at;
  }
  if (c == '$' && at + 1 < text.size() && (text[at + 1] == '(' || text[at + 1] == '{')) {
    const char open = text[at + 1];
    const char close = open == '(' ? ')' : '}';
    int depth = 0;
    for (size_t i = at + 1; i < text.size(); ++i) {
      if (text[i] == open) ++depth;
      if (text[i] == close && --depth == 0) return i + 1 - at;
    }
    return text.size() - at;
  }
  return 1;
}

/// Cuts a script into commands; words such as `then` and `do` are commands of their own.
std::vector<ShellCommand> CommandsOf(std::string_view text) {
  std::vector<ShellCommand> commands;
  ShellCommand command{.line = 1, .text = ""};
  int line = 1;
  int brackets = 0;
  const auto end = [&] {
    std::string_view rest = Trimmed(command.text);
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
      const bool is_keyword = word == "then" || word == "do" || word == "else";
      const std::string_view one = is_keyword ? word : rest;
      commands.push_back({.line = command.line, .text = std::string(one)});
      rest = Trimmed(rest.substr(one.size()));
    }
    command.text.clear();
  };
  for (size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (Trimmed(command.text).empty()) command.line = line;
    if (c == '\\' && i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r')) {
      command.text += ' ';
      i = text.find('\n', i) + 1;
      ++line;
      continue;
    }
    const bool is_word_start = command.text.empty() || command.text.back() == ' ' ||
                               command.text.back() == '\t' || command.text.back() == ';';
    if (c == '#' && is_word_start) {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '(' && command.text.ends_with('=')) ++brackets;
    if (c == ')' && brackets > 0) --brackets;
    if (c == '\n' || c == ';') {
      if (brackets > 0) {
        command.text += ' ';
      } else {
        end();
      }
      line += c == '\n' ? 1 : 0;
      ++i;
      continue;
    }
    const size_t length = PartLength(text, i);
    const std::string_view part = text.substr(i, length);
    line += static_cast<int>(std::count(part.begin(), part.end(), '\n'));
    command.text += part;
    i += length;
  }
  end();
  return commands;
}

std::string FirstWord(std::string_view text) {
  text = Trimmed(text);
  return std::string(text.substr(0, text.find_first_of(" \t")));
}

/// Returns true where a pattern with '*' and '?' is the whole text.
bool Matches(std::string_view pattern, std::string_view text) {
  size_t at = 0;
  size_t star = pattern.npos;
  size_t star_at = 0;
  size_t p = 0;
  while (at < text.size()) {
    if (p < pattern.size() &&
        (pattern[p] == '?' || (pattern[p] != '*' && pattern[p] == text[at]))) {
      ++p;
      ++at;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_at = at;
    } else if (star != pattern.npos) {
      p = star + 1;
      at = ++star_at;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

class LaunchReader {
 public:
  explicit LaunchReader(const FindMoosFile& find) : find_(find) {}

  void RunScript(const MoosSource& script, const Words& arguments) {
    if (depth_ >= kDeepestScript) return;
    ++depth_;
    const Script outer = std::exchange(
        script_, {.name = FileName(script.name), .from = script.name, .arguments = arguments});
    auto outer_variables = std::exchange(variables_, {});
    variables_ = depth_ > 1 ? exported_ : variables_;
    const std::vector<ShellCommand> commands = CommandsOf(script.text);
    Run(commands, 0, commands.size());
    variables_ = std::move(outer_variables);
    script_ = outer;
    --depth_;
  }

  LaunchPlan TakePlan() && { return std::move(plan_); }

 private:
  struct Script {
    std::string name;
    std::string from;
    Words arguments;
    bool is_ended = false;
  };

  void Note(int line, std::string text) {
    std::string note = fmt::format("{}:{}: {}", script_.name, line, text);
    if (noted_.insert(text).second) plan_.notes.push_back(CleanUtf8(note));
  }

  /// Returns the index of the command that ends the block that begins at `at`, or one of `middle`
  /// on its level.
  static size_t BlockEnd(const std::vector<ShellCommand>& commands, size_t at, size_t end,
                         const std::set<std::string>& middle) {
    int depth = 0;
    for (size_t i = at; i < end; ++i) {
      const std::string word = FirstWord(commands[i].text);
      const bool opens = word == "if" || word == "for" || word == "while" || word == "until" ||
                         word == "case" || word == "select";
      if (opens) ++depth;
      if (i > at && depth == 1 && middle.contains(word)) return i;
      if (word == "fi" || word == "done" || word == "esac") {
        if (--depth == 0) return i;
      }
    }
    return end;
  }

  /// Returns how many braces a command opens more than it closes.
  static int Braces(std::string_view text, bool* is_open) {
    int depth = 0;
    for (size_t i = 0; i < text.size(); i += PartLength(text, i)) {
      if (text[i] == '{') {
        ++depth;
        *is_open = true;
      } else if (text[i] == '}') {
        --depth;
      }
    }
    return depth;
  }

  void Run(const std::vector<ShellCommand>& commands, size_t begin, size_t end) {
    for (size_t i = begin; i < end && !script_.is_ended;) {
      if (++num_commands_ > kMaxCommands) return Note(commands[i].line, "is too long a script");
      const std::string& text = commands[i].text;
      const std::string word = FirstWord(text);
      if (word == "if") {
        i = RunIf(commands, i, end);
      } else if (word == "for") {
        i = RunFor(commands, i, end);
      } else if (word == "while") {
        i = RunWhile(commands, i, end);
      } else if (word == "until" || word == "case" || word == "select") {
        Note(commands[i].line, word + " is not read");
        i = BlockEnd(commands, i, end, {}) + 1;
      } else if (word.ends_with("()") || word == "function" || text.find("() {") != text.npos) {
        // What a function does is not needed: those of launch scripts print.
        int depth = 0;
        bool is_open = false;
        do {
          const int change = Braces(commands[i].text, &is_open);
          depth += change;
          ++i;
        } while (i < end && (!is_open || depth > 0));
      } else {
        Command(commands[i]);
        ++i;
      }
    }
  }

  size_t RunIf(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    const size_t fi = BlockEnd(commands, at, end, {});
    bool is_done = false;
    size_t part = at;
    while (part < fi) {
      // From an `if` or `elif` to the next part on this level.
      size_t next = fi;
      int depth = 0;
      for (size_t i = part + 1; i < fi; ++i) {
        const std::string word = FirstWord(commands[i].text);
        if (word == "if" || word == "for" || word == "while" || word == "case") ++depth;
        if (word == "fi" || word == "done" || word == "esac") --depth;
        if (depth == 0 && (word == "elif" || word == "else")) {
          next = i;
          break;
        }
      }
      const std::string word = FirstWord(commands[part].text);
      const bool is_else = word == "else";
      size_t body = part + 1;
      if (!is_else && body < fi && FirstWord(commands[body].text) == "then") ++body;
      if (!is_done) {
        const ShellCommand condition{
            .line = commands[part].line,
            .text =
                std::string(Trimmed(std::string_view(commands[part].text).substr(word.size())))};
        if (is_else || Test(condition)) {
          is_done = true;
          Run(commands, body, next);
        }
      }
      part = next;
    }
    return fi + 1;
  }

  size_t RunWhile(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    constexpr int kMostRounds = 1'000;
    const size_t done = BlockEnd(commands, at, end, {});
    const ShellCommand condition{
        .line = commands[at].line,
        .text = std::string(Trimmed(std::string_view(commands[at].text).substr(5)))};
    size_t body = at + 1;
    if (body < done && FirstWord(commands[body].text) == "do") ++body;
    for (int round = 0; Test(condition) && !script_.is_ended; ++round) {
      if (num_commands_ > kMaxCommands) break;
      // One that waits for an answer ends the script here.
      const bool asks = std::any_of(
          commands.begin() + static_cast<long>(body), commands.begin() + static_cast<long>(done),
          [](const ShellCommand& each) { return FirstWord(each.text) == "read"; });
      if (asks || round >= kMostRounds) break;
      Run(commands, body, done);
    }
    return done + 1;
  }

  size_t RunFor(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    const size_t done = BlockEnd(commands, at, end, {});
    Words words = SplitRaw(commands[at].text);
    if (words.size() < 2) return done + 1;
    const std::string name = words[1];
    Words values = script_.arguments;
    if (words.size() > 2 && words[2] == "in") {
      values.clear();
      for (size_t i = 3; i < words.size(); ++i) {
        for (std::string& each : Expand(words[i], commands[at].line)) values.push_back(each);
      }
    } else if (words.size() > 2) {
      Note(commands[at].line, "this form of for is not read");
      return done + 1;
    }
    size_t body = at + 1;
    if (body < done && FirstWord(commands[body].text) == "do") ++body;
    for (const std::string& value : values) {
      if (script_.is_ended || num_commands_ > kMaxCommands) break;
      variables_[name] = {value};
      Run(commands, body, done);
    }
    return done + 1;
  }

  /// Cuts a command at blanks, quotes stay.
  static Words SplitRaw(std::string_view text) {
    Words words;
    std::string word;
    bool is_open = false;
    int brackets = 0;
    for (size_t i = 0; i < text.size();) {
      const size_t length = PartLength(text, i);
      const std::string_view part = text.substr(i, length);
      i += length;
      if (part == "(" && word.ends_with('=')) ++brackets;
      if (part == ")" && brackets > 0) --brackets;
      if (brackets == 0 && (part == " " || part == "\t" || part == "\r" || part == "\n")) {
        if (is_open) words.push_back(std::exchange(word, {}));
        is_open = false;
      } else {
        word += part;
        is_open = true;
      }
    }
    if (is_open) words.push_back(word);
    return words;
  }

  static Words AtBlanks(std::string_view text) {
    Words words;
    while (true) {
      const size_t begin = text.find_first_not_of(" \t\r\n");
      if (begin == text.npos) return words;
      text.remove_prefix(begin);
      const size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
      words.emplace_back(text.substr(0, end));
      text.remove_prefix(end);
    }
  }

  /// Returns the values of a raw word: without quotes it may become several, or none.
  Words Expand(std::string_view raw, int line) {
    Words words;
    std::string word;
    bool is_there = false;
    for (size_t i = 0; i < raw.size();) {
      const size_t length = PartLength(raw, i);
      const std::string_view part = raw.substr(i, length);
      i += length;
      if (part.size() == 2 && part[0] == '\\') {
        word += part[1];
        is_there = true;
      } else if (part[0] == '\'' && part.size() >= 2) {
        word += part.substr(1, part.size() - 2);
        is_there = true;
      } else if (part[0] == '"' && part.size() >= 2) {
        word += Quoted(part.substr(1, part.size() - 2), line);
        is_there = true;
      } else if (part[0] == '$' || part[0] == '`') {
        size_t used = part.size();
        std::string_view reference = part;
        if (part == "$") {
          used = 1;
          while (i + used - 1 < raw.size() && IsNameCharacter(raw[i + used - 1])) ++used;
          if (used == 1 && i < raw.size()) used = 2;  // $?, $$, $@, $#
          reference = raw.substr(i - 1, used);
          i += used - 1;
        }
        const std::string value = Reference(reference, line);
        const bool joins_left = !value.empty() && value.front() != ' ';
        Words parts = AtBlanks(value);
        if (parts.empty()) continue;
        if (!joins_left && is_there) words.push_back(std::exchange(word, {}));
        for (size_t k = 0; k < parts.size(); ++k) {
          if (k > 0) words.push_back(std::exchange(word, {}));
          word += parts[k];
        }
        is_there = true;
      } else {
        word += part;
        is_there = true;
      }
      if (word.size() > kLongestText) return words;
    }
    if (is_there) words.push_back(word);
    return words;
  }

  /// Returns what stands in double quotes with its values.
  std::string Quoted(std::string_view text, int line) {
    std::string value;
    for (size_t i = 0; i < text.size();) {
      size_t length = text[i] == '"' || text[i] == '\'' ? 1 : PartLength(text, i);
      std::string_view part = text.substr(i, length);
      if (part.size() == 2 && part[0] == '\\') {
        value += part[1];
      } else if (part == "$" && i + 1 < text.size()) {
        length = 1;
        while (i + length < text.size() && IsNameCharacter(text[i + length])) ++length;
        if (length == 1) ++length;
        value += Reference(text.substr(i, length), line);
      } else if (part[0] == '$' || part[0] == '`') {
        value += Reference(part, line);
      } else {
        value += part;
      }
      i += length;
      if (value.size() > kLongestText) break;
    }
    return value;
  }

  std::string Join(const Words& words) const {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
  }

  const Words& Values(std::string_view name) const {
    static const Words kNone;
    const auto at = variables_.find(name);
    return at == variables_.end() ? kNone : at->second;
  }

  /// Returns the value of $X, ${X...}, $((...)), $(...) or `...`.
  std::string Reference(std::string_view text, int line) {
    if (text.starts_with("$(("))
      return Sum(text.substr(3, text.size() - std::min<size_t>(5, text.size())));
    if (text.starts_with("$(")) return Output(text.substr(2, text.size() - 3), line);
    if (text.starts_with('`')) return Output(text.substr(1, text.size() - 2), line);
    if (!text.starts_with("${")) {
      const std::string_view name = text.substr(1);
      if (name == "@" || name == "*") return Join(script_.arguments);
      if (name == "#") return std::to_string(script_.arguments.size());
      if (name == "?") return "0";
      if (name == "0") return script_.name;
      if (name.size() == 1 && IsDigit(name[0])) {
        const size_t index = static_cast<size_t>(name[0] - '1');
        return index < script_.arguments.size() ? script_.arguments[index] : "";
      }
      const Words& values = Values(name);
      return values.empty() ? "" : values.front();
    }
    std::string_view inner = text.substr(2, text.size() - std::min<size_t>(3, text.size()));
    const bool is_length = inner.starts_with('#') && inner.size() > 1;
    if (is_length) inner.remove_prefix(1);
    size_t end = 0;
    while (end < inner.size() && IsNameCharacter(inner[end])) ++end;
    const std::string_view name = inner.substr(0, end);
    std::string_view rest = inner.substr(end);
    const Words& values = Values(name);
    std::string value = values.empty() ? "" : values.front();
    if (name.size() == 1 && IsDigit(name[0])) value = Reference("$" + std::string(name), line);
    if (rest.starts_with('[')) {
      const size_t close = rest.find(']');
      if (close == rest.npos) return "";
      const std::string_view index = rest.substr(1, close - 1);
      rest.remove_prefix(close + 1);
      if (index == "@" || index == "*") {
        if (is_length) return std::to_string(values.size());
        value = Join(values);
      } else {
        const auto number = NumberIn(Sum(index));
        const bool is_inside =
            number && *number >= 0 && *number < static_cast<double>(values.size());
        value = is_inside ? values[static_cast<size_t>(*number)] : "";
      }
    }
    if (is_length) return std::to_string(value.size());
    if (rest.empty()) return value;
    if (rest.starts_with(":-") || rest.starts_with(":=")) {
      return value.empty() ? Quoted(rest.substr(2), line) : value;
    }
    if (rest.starts_with(':')) return Slice(value, rest.substr(1));
    if (rest.starts_with("//")) return WithoutAll(value, rest.substr(2));
    if (rest.starts_with('#')) return WithoutPrefix(value, rest);
    if (rest.starts_with('%')) return WithoutSuffix(value, rest);
    Note(line, fmt::format("{} is not read", shoal::Quoted(text)));
    return value;
  }

  std::string Slice(const std::string& value, std::string_view text) {
    const size_t colon = text.find(':');
    const double from = NumberIn(Sum(text.substr(0, colon))).value_or(0);
    const double count =
        colon == text.npos ? 1e6 : NumberIn(Sum(text.substr(colon + 1))).value_or(1e6);
    if (from < 0 || count < 0 || from >= static_cast<double>(value.size())) return "";
    return value.substr(static_cast<size_t>(from), static_cast<size_t>(std::min(count, 1e6)));
  }

  /// ${X//[^0-9]/} and ${X//a/b}.
  static std::string WithoutAll(std::string value, std::string_view text) {
    const size_t slash = text.find('/');
    const std::string_view pattern = text.substr(0, slash);
    const std::string replacement(slash == text.npos ? "" : text.substr(slash + 1));
    if (pattern == "[^0-9]") {
      std::erase_if(value, [](char c) { return !IsDigit(c); });
      return value;
    }
    if (pattern.empty()) return value;
    for (size_t at = value.find(pattern); at != value.npos && value.size() < kLongestText;
         at = value.find(pattern, at + replacement.size())) {
      value.replace(at, pattern.size(), replacement);
    }
    return value;
  }

  static std::string WithoutPrefix(const std::string& value, std::string_view text) {
    const bool is_longest = text.starts_with("##");
    const std::string_view pattern = text.substr(is_longest ? 2 : 1);
    std::optional<size_t> cut;
    for (size_t length = 0; length <= value.size(); ++length) {
      if (!Matches(pattern, std::string_view(value).substr(0, length))) continue;
      cut = length;
      if (!is_longest) break;
    }
    return cut ? value.substr(*cut) : value;
  }

  static std::string WithoutSuffix(const std::string& value, std::string_view text) {
    const bool is_longest = text.starts_with("%%");
    const std::string_view pattern = text.substr(is_longest ? 2 : 1);
    std::optional<size_t> cut;
    for (size_t length = 0; length <= value.size(); ++length) {
      if (!Matches(pattern, std::string_view(value).substr(value.size() - length))) continue;
      cut = length;
      if (!is_longest) break;
    }
    return cut ? value.substr(0, value.size() - *cut) : value;
  }

  /// Computes a sum of whole numbers and variables.
  std::string Sum(std::string_view text) {
    std::string plain = Quoted(text, 0);
    size_t at = 0;
    return fmt::format("{}", AddAt(plain, &at, 0));
  }

  long long AddAt(std::string_view text, size_t* at, int depth) {
    long long sum = MultiplyAt(text, at, depth);
    while (true) {
      Skip(text, at);
      if (*at >= text.size() || (text[*at] != '+' && text[*at] != '-')) return sum;
      const bool is_minus = text[(*at)++] == '-';
      const long long next = MultiplyAt(text, at, depth);
      sum = Bounded(is_minus ? sum - next : sum + next);
    }
  }

  long long MultiplyAt(std::string_view text, size_t* at, int depth) {
    long long product = OneAt(text, at, depth);
    while (true) {
      Skip(text, at);
      if (*at >= text.size() || (text[*at] != '*' && text[*at] != '/' && text[*at] != '%')) {
        return product;
      }
      const char sign = text[(*at)++];
      const long long next = OneAt(text, at, depth);
      if (sign == '*') product = Bounded(product * next);
      if (sign != '*' && next == 0) return 0;
      if (sign == '/') product /= next;
      if (sign == '%') product %= next;
    }
  }

  static void Skip(std::string_view text, size_t* at) {
    while (*at < text.size() && (text[*at] == ' ' || text[*at] == '\t')) ++*at;
  }
  static long long Bounded(long long value) {
    return std::clamp(value, -1'000'000'000LL, 1'000'000'000LL);
  }

  long long OneAt(std::string_view text, size_t* at, int depth) {
    constexpr int kDeepest = 20;
    Skip(text, at);
    if (*at >= text.size() || depth > kDeepest) return 0;
    if (text[*at] == '-') return ++*at, -OneAt(text, at, depth + 1);
    if (text[*at] == '(') {
      ++*at;
      const long long value = AddAt(text, at, depth + 1);
      Skip(text, at);
      if (*at < text.size() && text[*at] == ')') ++*at;
      return value;
    }
    const size_t begin = *at;
    while (*at < text.size() && IsNameCharacter(text[*at])) ++*at;
    if (*at == begin) return ++*at, 0;
    const std::string_view word = text.substr(begin, *at - begin);
    if (const auto number = NumberIn(word)) {
      return Bounded(static_cast<long long>(std::clamp(*number, -1e9, 1e9)));
    }
    const Words& values = Values(word);
    if (values.empty()) return 0;
    return Bounded(
        static_cast<long long>(std::clamp(NumberIn(values.front()).value_or(0), -1e9, 1e9)));
  }

  /// Returns what a command prints.
  std::string Output(std::string_view text, int line) {
    Words words = ExpandAll(SplitRaw(text), line);
    if (words.empty()) return "";
    const std::string& name = words.front();
    if (name == "seq") {
      const auto last = NumberIn(words.back());
      const auto first = words.size() > 2 ? NumberIn(words[1]) : std::optional<double>(1);
      std::string list;
      constexpr double kMost = 1'000;
      if (first && last) {
        for (double i = *first; i <= std::min(*last, *first + kMost); ++i) {
          list += fmt::format("{}{:.0f}", list.empty() ? "" : " ", i);
        }
      }
      return list;
    }
    if (name == "basename" && words.size() > 1) return FileName(words[1]);
    if (name == "echo") return Join({words.begin() + 1, words.end()});
    if (name == "pickpos") return Picked(words, line);
    if (name == "cat" && words.size() > 1) {
      const auto made = made_files_.find(words[1]);
      if (made != made_files_.end()) return made->second;
      if (const auto found = Find(words[1])) return found->text.substr(0, kLongestText);
      Note(line, fmt::format("{} is not there", shoal::Quoted(words[1])));
      return "";
    }
    if (name != "date" && name != "pwd" && name != "whoami" && name != "hostname") {
      Note(line, fmt::format("the output of {} is not known", shoal::Quoted(name)));
    }
    return "";
  }

  /// Returns what pickpos prints of names, colors and speeds; places are random there, and are none
  /// here.
  std::string Picked(const Words& words, int line) {
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
      Note(line, "the places of pickpos are random: give them in --vehicle");
      return "";
    }
    std::string list;
    for (size_t i = 0; i < amount; ++i) {
      std::string one = speed;
      if (what != "--spd") {
        one = what == "--vnames" ? kNames[i % std::size(kNames)] : kColors[i % std::size(kColors)];
      }
      if (what == "--vnames" && i >= std::size(kNames))
        one += std::to_string(i / std::size(kNames));
      list += one + "\n";
    }
    return list;
  }

  std::optional<MoosSource> Find(std::string_view name) const {
    if (find_ == nullptr) return std::nullopt;
    if (name.starts_with("./")) name.remove_prefix(2);
    return find_(name, script_.from);
  }

  Words ExpandAll(const Words& raw, int line) {
    Words words;
    for (const std::string& each : raw) {
      for (std::string& word : Expand(each, line)) words.push_back(std::move(word));
    }
    return words;
  }

  bool Test(const ShellCommand& command) {
    Words raw = SplitRaw(command.text);
    if (raw.empty()) return false;
    if (raw.front() != "[" && raw.front() != "[[" && raw.front() != "test") {
      return FirstWord(command.text) == "true";
    }
    // Each of the words is one: `[ $X = a ]` of an empty X is an error of the shell, false here.
    Words words;
    for (size_t i = 1; i < raw.size(); ++i) {
      if (raw[i] == "]" || raw[i] == "]]") break;
      words.push_back(Join(Expand(raw[i], command.line)));
      if (raw[i] == "=" || raw[i] == "==") words.back() = "=";
    }
    bool result = true;
    bool is_first = true;
    for (size_t at = 0; at < words.size();) {
      bool is_or = false;
      if (!is_first) {
        is_or = words[at] == "-o" || words[at] == "||";
        ++at;
      }
      bool is_not = false;
      while (at < words.size() && words[at] == "!") {
        is_not = !is_not;
        ++at;
      }
      const bool holds = Primary(words, &at) != is_not;
      if (is_first) result = holds;
      if (!is_first) result = is_or ? result || holds : result && holds;
      is_first = false;
    }
    return result && !is_first;
  }

  bool Primary(const Words& words, size_t* at) {
    if (*at >= words.size()) return false;
    const std::string& first = words[*at];
    if (*at + 1 < words.size() &&
        (first == "-z" || first == "-n" || first == "-f" || first == "-e" || first == "-d" ||
         first == "-x" || first == "-r")) {
      const std::string& value = words[*at + 1];
      *at += 2;
      if (first == "-z") return value.empty();
      if (first == "-n") return !value.empty();
      return first != "-d" && (made_files_.contains(value) || Find(value).has_value());
    }
    if (*at + 2 >= words.size()) {
      ++*at;
      return !first.empty();
    }
    const std::string& relation = words[*at + 1];
    const std::string& second = words[*at + 2];
    const std::set<std::string> known = {"=",   "!=",  "-eq", "-ne", "-lt",
                                         "-gt", "-le", "-ge", "<",   ">"};
    if (!known.contains(relation)) {
      ++*at;
      return !first.empty();
    }
    *at += 3;
    if (relation == "=") return first == second;
    if (relation == "!=") return first != second;
    const double left = NumberIn(first).value_or(0);
    const double right = NumberIn(second).value_or(0);
    if (relation == "-eq") return left == right;
    if (relation == "-ne") return left != right;
    if (relation == "-lt" || relation == "<") return left < right;
    if (relation == "-gt" || relation == ">") return left > right;
    return relation == "-le" ? left <= right : left >= right;
  }

  /// Sets variables; returns false where the word is no NAME=VALUE.
  bool Assign(const std::string& raw, int line) {
    size_t end = 0;
    while (end < raw.size() && IsNameCharacter(raw[end])) ++end;
    if (end == 0 || IsDigit(raw[0])) return false;
    const std::string name = raw.substr(0, end);
    std::string_view rest = std::string_view(raw).substr(end);
    std::optional<size_t> index;
    if (rest.starts_with('[')) {
      const size_t close = rest.find(']');
      if (close == rest.npos) return false;
      const double number = NumberIn(Sum(rest.substr(1, close - 1))).value_or(-1);
      if (number < 0 || number > 1'000) return false;
      index = static_cast<size_t>(number);
      rest.remove_prefix(close + 1);
    }
    const bool appends = rest.starts_with("+=");
    if (!appends && !rest.starts_with('=')) return false;
    rest.remove_prefix(appends ? 2 : 1);
    Words values;
    if (rest.starts_with('(') && rest.ends_with(')')) {
      values = ExpandAll(SplitRaw(rest.substr(1, rest.size() - 2)), line);
      Words& kept = variables_[name];
      if (!appends) kept.clear();
      kept.insert(kept.end(), values.begin(), values.end());
      return true;
    }
    // An assigned word is not cut at blanks.
    std::string value;
    for (size_t i = 0; i < rest.size();) {
      const size_t length = PartLength(rest, i);
      const std::string_view part = rest.substr(i, length);
      if (part[0] == '"' || part[0] == '\'') {
        const std::string_view inner = part.size() < 2 ? part : part.substr(1, part.size() - 2);
        value += part[0] == '"' ? Quoted(inner, line) : std::string(inner);
        i += length;
      } else {
        size_t stop = i + length;
        while (stop < rest.size() && rest[stop] != '"' && rest[stop] != '\'') {
          stop += PartLength(rest, stop);
        }
        value += Quoted(rest.substr(i, stop - i), line);
        i = stop;
      }
    }
    Words& kept = variables_[name];
    const size_t place = index.value_or(0);
    if (kept.size() <= place) kept.resize(place + 1);
    kept[place] = appends ? kept[place] + value : value;
    if (kept[place].size() > kLongestText) kept[place].resize(kLongestText);
    return true;
  }

  void Command(const ShellCommand& command) {
    Words raw = SplitRaw(command.text);
    // `a && b`, `a || b`: the second by what a test of the first gives.
    for (size_t i = 1; i + 1 < raw.size(); ++i) {
      if (raw[i] != "&&" && raw[i] != "||") continue;
      if (raw[0] == "[[" &&
          std::find(raw.begin(), raw.end(), "]]") > raw.begin() + static_cast<long>(i)) {
        continue;
      }
      const auto text_of = [&](size_t from, size_t to) {
        return ShellCommand{.line = command.line,
                            .text = Join({raw.begin() + static_cast<long>(from),
                                          raw.begin() + static_cast<long>(to)})};
      };
      const bool is_test = raw[0] == "[" || raw[0] == "[[" || raw[0] == "test";
      const bool holds = is_test ? Test(text_of(0, i)) : true;
      if (!is_test) Command(text_of(0, i));
      if (holds == (raw[i] == "&&")) Command(text_of(i + 1, raw.size()));
      return;
    }
    bool exports = false;
    while (!raw.empty() && (raw[0] == "export" || raw[0] == "local" || raw[0] == "declare")) {
      exports = raw[0] == "export";
      raw.erase(raw.begin());
    }
    while (!raw.empty() && Assign(raw[0], command.line)) {
      if (exports) {
        const std::string name = raw[0].substr(0, raw[0].find_first_of("+=["));
        exported_[name] = variables_[name];
      }
      raw.erase(raw.begin());
    }
    if (raw.empty()) return;
    RunWords(ExpandAll(raw, command.line), command.line);
  }

  void RunWords(Words words, int line) {
    if (words.empty()) return;
    const std::string name = words.front();
    words.erase(words.begin());
    if (name == "eval") return Command({.line = line, .text = Join(words)});
    if (name == "exit") {
      script_.is_ended = true;
    } else if (name == "echo") {
      Write(words, [](const Words& own) { return own; });
    } else if (name == "pickpos") {
      Write(words, [&](const Words& own) { return Words{Picked(own, line)}; });
    } else if (name == "nsplug") {
      TakeNsplug(words, line);
    } else if (name == "pAntler") {
      if (!words.empty())
        AddFile({.source = words[0], .target = FileName(words[0]), .defines = {}}, true);
    } else if (name == "sh" || name == "bash" || name == "source" || name == ".") {
      if (!words.empty()) Call(words[0], {words.begin() + 1, words.end()}, line);
    } else if (name.ends_with(".sh")) {
      Call(name, words, line);
    }
  }

  void Call(const std::string& name, const Words& arguments, int line) {
    const std::string file = FileName(name);
    if (file == "clean.sh" || file == "soft_reset.sh") return;
    const auto found = Find(name);
    if (!found) return Note(line, fmt::format("{} is not there", shoal::Quoted(name)));
    Words own;
    for (const std::string& each : arguments) {
      if (each.starts_with('>') || each == "&") break;
      own.push_back(each);
    }
    RunScript(*found, own);
  }

  /// `echo TEXT > FILE`: keeps what the command prints.
  template <class Print>
  void Write(const Words& words, const Print& print) {
    for (size_t i = 0; i < words.size(); ++i) {
      const bool appends = words[i].starts_with(">>");
      if (!words[i].starts_with('>')) continue;
      std::string file = words[i].substr(appends ? 2 : 1);
      if (file.empty() && i + 1 < words.size()) file = words[i + 1];
      std::string& text = made_files_[file];
      if (!appends) text.clear();
      if (text.size() < kLongestText) {
        text += Join(print({words.begin(), words.begin() + static_cast<long>(i)})) + "\n";
      }
      return;
    }
  }

  void TakeNsplug(const Words& words, int line) {
    if (words.size() < 2) return Note(line, "nsplug has no two files");
    LaunchFile file{.source = words[0], .target = words[1], .defines = {}};
    for (size_t i = 2; i < words.size(); ++i) {
      const std::string& word = words[i];
      if (word.starts_with('-')) continue;
      if (word.starts_with('>') || word == "&") break;
      const size_t equals = word.find('=');
      if (equals == 0) continue;
      file.defines.insert_or_assign(word.substr(0, equals), equals == word.npos
                                                                ? std::string(kBareMacro)
                                                                : word.substr(equals + 1));
    }
    AddFile(std::move(file), false);
  }

  void AddFile(LaunchFile file, bool is_plain) {
    constexpr size_t kMostFiles = 400;
    if (!file.source.ends_with(".moos") && !file.source.ends_with(".bhv")) return;
    for (LaunchFile& earlier : plan_.files) {
      if (FileName(earlier.target) != FileName(file.target)) continue;
      if (!is_plain) earlier = std::move(file);
      return;
    }
    if (is_plain && !Find(file.source)) return;
    if (plan_.files.size() < kMostFiles) plan_.files.push_back(std::move(file));
  }

  const FindMoosFile& find_;
  LaunchPlan plan_;
  Script script_;
  std::map<std::string, Words, std::less<>> variables_;
  std::map<std::string, Words, std::less<>> exported_;
  std::map<std::string, std::string, std::less<>> made_files_;
  std::set<std::string> noted_;
  int num_commands_ = 0;
  int depth_ = 0;
};

}  // namespace

LaunchPlan ReadLaunchScript(const MoosSource& script, const FindMoosFile& find) {
  LaunchReader reader(find);
  reader.RunScript(script, {});
  return std::move(reader).TakePlan();
}

}  // namespace shoal
