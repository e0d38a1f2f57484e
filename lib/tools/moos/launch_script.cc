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
#include "lib/tools/moos/shell_sum.h"
#include "lib/tools/moos/shell_text.h"

namespace shoal {
namespace {

constexpr int kMaxCommands = 50'000;
constexpr int kDeepestScript = 8;

class LaunchReader {
 public:
  explicit LaunchReader(const FindMoosFile& find) : find_(find) {}

  void RunScript(const MoosSource& script, const ShellWords& arguments) {
    if (depth_ >= kDeepestScript) return;
    ++depth_;
    const Script outer = std::exchange(
        script_, {.name = FileName(script.name), .from = script.name, .arguments = arguments});
    auto outer_variables = std::exchange(variables_, {});
    variables_ = depth_ > 1 ? exported_ : variables_;
    std::vector<ShellCommand> commands = ShellCommandsOf(script.text);
    if (commands.size() > kMaxCommands) {
      Note(commands[kMaxCommands].line, "is too long a script");
      commands.resize(kMaxCommands);
    }
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
    ShellWords arguments;
    bool is_ended = false;
  };

  void Note(int line, std::string text) {
    std::string note = fmt::format("{}:{}: {}", script_.name, line, text);
    if (noted_.insert(text).second) plan_.notes.push_back(CleanUtf8(note));
  }

  void Run(const std::vector<ShellCommand>& commands, size_t begin, size_t end) {
    for (size_t i = begin; i < end && !script_.is_ended;) {
      if (++num_commands_ > kMaxCommands) return Note(commands[i].line, "is too long a script");
      const std::string& text = commands[i].text;
      const std::string word = FirstShellWord(text);
      const bool is_block =
          word == "if" || word == "for" || word == "while" || word == "until" || word == "case";
      if (is_block) {
        i = RunBlock(commands, i, end, word);
      } else if (word == "select") {
        Note(commands[i].line, word + " is not read");
        i = ShellBlockEnd(commands, i, end, {}) + 1;
      } else if (word.ends_with("()") || word == "function" || text.find("() {") != text.npos) {
        // What a function does is not needed: those of launch scripts print.
        int depth = 0;
        bool is_open = false;
        do {
          const int change = ShellBraces(commands[i].text, &is_open);
          depth += change;
          ++i;
        } while (i < end && (!is_open || depth > 0));
      } else {
        Command(commands[i]);
        ++i;
      }
    }
  }

  /// Runs the block that begins with `word` at `at`; returns where to go on.
  size_t RunBlock(const std::vector<ShellCommand>& commands, size_t at, size_t end,
                  std::string_view word) {
    constexpr int kDeepestBlock = 50;
    if (blocks_ == kDeepestBlock) {
      Note(commands[at].line,
           fmt::format("blocks lie within one another more than {} deep", kDeepestBlock));
      return ShellBlockEnd(commands, at, end, {}) + 1;
    }
    ++blocks_;
    const size_t next = word == "if"     ? RunIf(commands, at, end)
                        : word == "for"  ? RunFor(commands, at, end)
                        : word == "case" ? RunCase(commands, at, end)
                                         : RunWhile(commands, at, end, word == "until");
    --blocks_;
    return next;
  }

  size_t RunIf(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    const size_t fi = ShellBlockEnd(commands, at, end, {});
    bool is_done = false;
    size_t part = at;
    while (part < fi) {
      // From an `if` or `elif` to the next part on this level.
      size_t next = fi;
      int depth = 0;
      for (size_t i = part + 1; i < fi; ++i) {
        const std::string word = FirstShellWord(commands[i].text);
        if (word == "if" || word == "for" || word == "while" || word == "until" || word == "case") {
          ++depth;
        }
        if (word == "fi" || word == "done" || word == "esac") --depth;
        if (depth == 0 && (word == "elif" || word == "else")) {
          next = i;
          break;
        }
      }
      const std::string word = FirstShellWord(commands[part].text);
      const bool is_else = word == "else";
      size_t body = part + 1;
      if (!is_else && body < fi && FirstShellWord(commands[body].text) == "then") ++body;
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

  /// `case "$X" in a|b) ... ;; *) ... ;; esac`.
  size_t RunCase(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    const size_t esac = ShellBlockEnd(commands, at, end, {});
    const ShellWords head = RawShellWords(commands[at].text);
    if (head.size() < 3 || head[2] != "in") {
      Note(commands[at].line, "case without in is not read");
      return esac + 1;
    }
    const std::string subject = Join(Expand(head[1], commands[at].line));
    // The first pattern may stand on the line of the head.
    std::vector<ShellCommand> parts = {
        {.line = commands[at].line, .text = Join({head.begin() + 3, head.end()})}};
    parts.insert(parts.end(), commands.begin() + static_cast<long>(at) + 1,
                 commands.begin() + static_cast<long>(esac));
    for (size_t i = 0; i < parts.size(); ++i) {
      const size_t close = PatternEnd(parts[i].text);
      if (close == std::string::npos) continue;
      const bool matches = IsCase(parts[i].text.substr(0, close), subject, parts[i].line);
      parts[i].text.erase(0, close + 1);
      size_t last = i;
      for (int depth = 0; last < parts.size(); ++last) {
        const std::string word = FirstShellWord(parts[last].text);
        if (word == "case") ++depth;
        if (word == "esac") --depth;
        if (depth == 0 && parts[last].text == ";;") break;
      }
      if (matches) {
        Run(parts, i, last);
        break;
      }
      i = last;
    }
    return esac + 1;
  }

  /// Returns the place of the ')' behind a pattern.
  static size_t PatternEnd(std::string_view text) {
    for (size_t i = 0; i < text.size(); i += ShellPartLength(text, i)) {
      if (text[i] == ')') return i;
    }
    return text.npos;
  }

  bool IsCase(std::string_view patterns, const std::string& subject, int line) {
    patterns = Trimmed(patterns);
    if (patterns.starts_with('(')) patterns.remove_prefix(1);
    while (true) {
      const size_t bar = std::min(patterns.find('|'), patterns.size());
      const std::string pattern = Join(Expand(Trimmed(patterns.substr(0, bar)), line));
      if (MatchesShell(pattern, subject)) return true;
      if (bar == patterns.size()) return false;
      patterns.remove_prefix(bar + 1);
    }
  }

  size_t RunWhile(const std::vector<ShellCommand>& commands, size_t at, size_t end, bool is_until) {
    constexpr int kMostRounds = 1'000;
    const size_t done = ShellBlockEnd(commands, at, end, {});
    const ShellCommand condition{
        .line = commands[at].line,
        .text = std::string(Trimmed(std::string_view(commands[at].text).substr(5)))};
    size_t body = at + 1;
    if (body < done && FirstShellWord(commands[body].text) == "do") ++body;
    for (int round = 0; Test(condition) != is_until && !script_.is_ended; ++round) {
      if (num_commands_ > kMaxCommands) break;
      // One that waits for an answer ends the script here.
      const bool asks = std::any_of(
          commands.begin() + static_cast<long>(body), commands.begin() + static_cast<long>(done),
          [](const ShellCommand& each) { return FirstShellWord(each.text) == "read"; });
      if (asks || round >= kMostRounds) break;
      Run(commands, body, done);
    }
    return done + 1;
  }

  size_t RunFor(const std::vector<ShellCommand>& commands, size_t at, size_t end) {
    const size_t done = ShellBlockEnd(commands, at, end, {});
    ShellWords words = RawShellWords(commands[at].text);
    if (words.size() < 2) return done + 1;
    const std::string name = words[1];
    ShellWords values = script_.arguments;
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
    if (body < done && FirstShellWord(commands[body].text) == "do") ++body;
    for (const std::string& value : values) {
      if (script_.is_ended || num_commands_ > kMaxCommands) break;
      variables_[name] = {value};
      Run(commands, body, done);
    }
    return done + 1;
  }

  /// Returns the values of a raw word: without quotes it may become several, or none.
  ShellWords Expand(std::string_view raw, int line) {
    ShellWords words;
    std::string word;
    bool is_there = false;
    for (size_t i = 0; i < raw.size();) {
      const size_t length = ShellPartLength(raw, i);
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
        std::string_view reference = part;
        if (part == "$") {
          size_t used = 1;
          while (i + used - 1 < raw.size() && IsNameCharacter(raw[i + used - 1])) ++used;
          if (used == 1 && i < raw.size()) used = 2;  // $?, $$, $@, $#
          reference = raw.substr(i - 1, used);
          i += used - 1;
        }
        const std::string value = Reference(reference, line);
        const bool joins_left = !value.empty() && value.front() != ' ';
        ShellWords parts = AtShellBlanks(value);
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
      if (word.size() > kMaxShellText) return words;
    }
    if (is_there) words.push_back(word);
    return words;
  }

  /// Returns what stands in double quotes with its values.
  std::string Quoted(std::string_view text, int line) {
    std::string value;
    for (size_t i = 0; i < text.size();) {
      size_t length = text[i] == '"' || text[i] == '\'' ? 1 : ShellPartLength(text, i);
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
      if (value.size() > kMaxShellText) break;
    }
    return value;
  }

  std::string Join(const ShellWords& words) const {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
  }

  const ShellWords& Values(std::string_view name) const {
    static const ShellWords kNone;
    const auto at = variables_.find(name);
    return at == variables_.end() ? kNone : at->second;
  }

  /// Returns the value of $X, ${X...}, $((...)), $(...) or `...`, each of which may hold others.
  std::string Reference(std::string_view text, int line) {
    constexpr int kDeepestReference = 16;
    if (nesting_ == kDeepestReference) {
      Note(line, fmt::format("values lie within one another more than {} deep", kDeepestReference));
      return "";
    }
    ++nesting_;
    std::string value = ValueOf(text, line);
    --nesting_;
    return value;
  }

  std::string ValueOf(std::string_view text, int line) {
    if (text.starts_with("$(("))
      return Sum(text.substr(3, text.size() - std::min<size_t>(5, text.size())), line);
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
      const ShellWords& values = Values(name);
      if (values.empty()) NoteRandom(name, line);
      return values.empty() ? "" : values.front();
    }
    std::string_view inner = text.substr(2, text.size() - std::min<size_t>(3, text.size()));
    const bool is_length = inner.starts_with('#') && inner.size() > 1;
    if (is_length) inner.remove_prefix(1);
    size_t end = 0;
    while (end < inner.size() && IsNameCharacter(inner[end])) ++end;
    const std::string_view name = inner.substr(0, end);
    std::string_view rest = inner.substr(end);
    const ShellWords& values = Values(name);
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
        const auto number = NumberIn(Sum(index, line));
        const bool is_inside =
            number && *number >= 0 && *number < static_cast<double>(values.size());
        value = is_inside ? values[static_cast<size_t>(*number)] : "";
      }
    }
    if (is_length) return std::to_string(value.size());
    if (rest.empty()) return value;
    if (rest.starts_with(":-") || rest.starts_with(":=")) {
      return value.empty() ? Join(Expand(rest.substr(2), line)) : value;
    }
    if (rest.starts_with(':')) return Slice(value, rest.substr(1), line);
    // A pattern is compared with every part of the value: long values count as many commands.
    constexpr size_t kStepsOfACommand = 100'000;
    const auto steps = static_cast<int>(value.size() * value.size() / kStepsOfACommand);
    num_commands_ = std::min(num_commands_ + steps, 10 * kMaxCommands);
    if (num_commands_ > kMaxCommands) return value;
    if (rest.starts_with("//")) return WithoutAll(value, rest.substr(2));
    if (rest.starts_with('#')) return WithoutPrefix(value, rest);
    if (rest.starts_with('%')) return WithoutSuffix(value, rest);
    Note(line, fmt::format("{} is not read", shoal::Quoted(text)));
    return value;
  }

  std::string Slice(const std::string& value, std::string_view text, int line) {
    const size_t colon = text.find(':');
    const double from = NumberIn(Sum(text.substr(0, colon), line)).value_or(0);
    const double count =
        colon == text.npos ? 1e6 : NumberIn(Sum(text.substr(colon + 1), line)).value_or(1e6);
    if (from < 0 || count < 0 || from >= static_cast<double>(value.size())) return "";
    return value.substr(static_cast<size_t>(from), static_cast<size_t>(std::min(count, 1e6)));
  }

  /// Computes a sum of whole numbers and variables.
  std::string Sum(std::string_view text, int line) {
    const std::string plain = Quoted(text, line);
    bool is_exact = true;
    const long long sum = ShellSum(
        plain,
        [&](std::string_view name) {
          const ShellWords& values = Values(name);
          if (values.empty()) NoteRandom(name, line);
          return values.empty() ? std::string_view() : std::string_view(values.front());
        },
        &is_exact);
    if (!is_exact) {
      Note(line,
           fmt::format("{} divides by 0 or leaves +-1e9: taken as {}", shoal::Quoted(plain), sum));
    }
    return fmt::format("{}", sum);
  }

  /// Notes that a variable which bash draws has no value here.
  void NoteRandom(std::string_view name, int line) {
    if (name == "RANDOM" || name == "SRANDOM") Note(line, fmt::format("{} is random", name));
  }

  /// Returns what `expr 1 + 2` prints; its comparisons and functions of texts are not known.
  std::string Expr(const ShellWords& words, int line) {
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
    const std::string text = Join({words.begin() + 1, words.end()});
    if (is_sum && !needs_number) return Sum(text, line);
    Note(line, fmt::format("the output of {} is not known", shoal::Quoted("expr " + text)));
    return "";
  }

  /// Returns the path without slashes at its end; "/" stays.
  static std::string_view WithoutSlashes(std::string_view path) {
    while (path.size() > 1 && path.ends_with('/')) path.remove_suffix(1);
    return path;
  }

  static std::string FolderOf(std::string_view path) {
    path = WithoutSlashes(path);
    const size_t slash = path.rfind('/');
    if (slash == path.npos) return ".";
    return std::string(WithoutSlashes(path.substr(0, std::max<size_t>(slash, 1))));
  }

  static std::string BaseName(const ShellWords& words) {
    const std::string_view path = WithoutSlashes(words[1]);
    std::string name = path == "/" ? "/" : FileName(path);
    if (words.size() > 2 && name.size() > words[2].size() && name.ends_with(words[2])) {
      name.resize(name.size() - words[2].size());
    }
    return name;
  }

  /// Returns what a command prints.
  std::string Output(std::string_view text, int line) {
    ShellWords words = ExpandAll(RawShellWords(text), line);
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
    if (name == "echo") return Join({words.begin() + 1, words.end()});
    if (name == "expr") return Expr(words, line);
    if (name == "pickpos") return Picked(words, line);
    if (name == "cat" && words.size() > 1) {
      const auto made = made_files_.find(words[1]);
      if (made != made_files_.end()) return made->second;
      if (const auto found = Find(words[1])) return found->text.substr(0, kMaxShellText);
      Note(line, fmt::format("{} is not there", shoal::Quoted(words[1])));
      return "";
    }
    constexpr std::string_view kOfThisMachine[] = {"date", "pwd", "whoami", "hostname", "id", "cd"};
    if (std::find(std::begin(kOfThisMachine), std::end(kOfThisMachine), name) ==
        std::end(kOfThisMachine)) {
      Note(line, fmt::format("the output of {} is not known", shoal::Quoted(name)));
    }
    return "";
  }

  /// Returns what pickpos prints of names, colors and speeds; places are random there, and are none
  /// here.
  std::string Picked(const ShellWords& words, int line) {
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

  ShellWords ExpandAll(const ShellWords& raw, int line) {
    ShellWords words;
    for (const std::string& each : raw) {
      for (std::string& word : Expand(each, line)) words.push_back(std::move(word));
    }
    return words;
  }

  bool Test(const ShellCommand& command) {
    ShellWords raw = RawShellWords(command.text);
    if (raw.empty()) return false;
    if (raw.front() != "[" && raw.front() != "[[" && raw.front() != "test") {
      return FirstShellWord(command.text) == "true";
    }
    // Each of the words is one: `[ $X = a ]` of an empty X is an error of the shell, false here.
    ShellWords words;
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

  bool Primary(const ShellWords& words, size_t* at) {
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
      const double number = NumberIn(Sum(rest.substr(1, close - 1), line)).value_or(-1);
      if (number < 0 || number > 1'000) return false;
      index = static_cast<size_t>(number);
      rest.remove_prefix(close + 1);
    }
    const bool appends = rest.starts_with("+=");
    if (!appends && !rest.starts_with('=')) return false;
    rest.remove_prefix(appends ? 2 : 1);
    ShellWords values;
    if (rest.starts_with('(') && rest.ends_with(')')) {
      values = ExpandAll(RawShellWords(rest.substr(1, rest.size() - 2)), line);
      ShellWords& kept = variables_[name];
      if (!appends) kept.clear();
      kept.insert(kept.end(), values.begin(), values.end());
      return true;
    }
    // An assigned word is not cut at blanks.
    std::string value;
    for (size_t i = 0; i < rest.size();) {
      const size_t length = ShellPartLength(rest, i);
      const std::string_view part = rest.substr(i, length);
      if (part[0] == '"' || part[0] == '\'') {
        const std::string_view inner = part.size() < 2 ? part : part.substr(1, part.size() - 2);
        value += part[0] == '"' ? Quoted(inner, line) : std::string(inner);
        i += length;
      } else {
        size_t stop = i + length;
        while (stop < rest.size() && rest[stop] != '"' && rest[stop] != '\'') {
          stop += ShellPartLength(rest, stop);
        }
        value += Quoted(rest.substr(i, stop - i), line);
        i = stop;
      }
    }
    ShellWords& kept = variables_[name];
    const size_t place = index.value_or(0);
    if (kept.size() <= place) kept.resize(place + 1);
    kept[place] = appends ? kept[place] + value : value;
    if (kept[place].size() > kMaxShellText) kept[place].resize(kMaxShellText);
    return true;
  }

  void Command(const ShellCommand& command) {
    ShellWords raw = RawShellWords(command.text);
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

  void RunWords(ShellWords words, int line) {
    if (words.empty()) return;
    const std::string name = words.front();
    words.erase(words.begin());
    if (name == "eval") return Command({.line = line, .text = Join(words)});
    if (name == "exit") {
      script_.is_ended = true;
    } else if (name == "echo") {
      Write(words, [](const ShellWords& own) { return own; });
    } else if (name == "pickpos") {
      Write(words, [&](const ShellWords& own) { return ShellWords{Picked(own, line)}; });
    } else if (name == "nsplug") {
      TakeNsplug(words, line);
    } else if (name == "pAntler") {
      if (!words.empty())
        AddFile({.source = words[0], .target = FileName(words[0]), .defines = {}}, true);
    } else if (name == "uPokeDB") {
      TakePoke(words, line);
    } else if (name == "sh" || name == "bash" || name == "source" || name == ".") {
      if (!words.empty()) Call(words[0], {words.begin() + 1, words.end()}, line);
    } else if (name.ends_with(".sh")) {
      Call(name, words, line);
    }
  }

  void Call(const std::string& name, const ShellWords& arguments, int line) {
    const std::string file = FileName(name);
    if (file == "clean.sh" || file == "soft_reset.sh") return;
    const auto found = Find(name);
    if (!found) return Note(line, fmt::format("{} is not there", shoal::Quoted(name)));
    ShellWords own;
    for (const std::string& each : arguments) {
      if (each.starts_with('>') || each == "&") break;
      own.push_back(each);
    }
    RunScript(*found, own);
  }

  /// `echo TEXT > FILE`: keeps what the command prints.
  template <class Print>
  void Write(const ShellWords& words, const Print& print) {
    for (size_t i = 0; i < words.size(); ++i) {
      const bool appends = words[i].starts_with(">>");
      if (!words[i].starts_with('>')) continue;
      std::string file = words[i].substr(appends ? 2 : 1);
      if (file.empty() && i + 1 < words.size()) file = words[i + 1];
      std::string& text = made_files_[file];
      if (!appends) text.clear();
      if (text.size() < kMaxShellText) {
        text += Join(print({words.begin(), words.begin() + static_cast<long>(i)})) + "\n";
      }
      return;
    }
  }

  void TakeNsplug(const ShellWords& words, int line) {
    if (words.size() < 2) return Note(line, "nsplug has no two files");
    LaunchFile file{.source = words[0], .target = words[1], .defines = {}};
    for (size_t i = 2; i < words.size(); ++i) {
      const std::string& word = words[i];
      if (word.starts_with("--macros=")) AddMacros(word.substr(word.find('=') + 1), line, &file);
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

  /// Lines NAME=VALUE of a file; what the command line gives, wins.
  void AddMacros(const std::string& name, int line, LaunchFile* file) {
    constexpr size_t kMostMacros = 1'000;
    const auto made = made_files_.find(name);
    const auto found = made == made_files_.end() ? Find(name) : std::nullopt;
    if (made == made_files_.end() && !found) {
      return Note(line, fmt::format("{} is not there", shoal::Quoted(name)));
    }
    std::string_view rest = found ? std::string_view(found->text) : made->second;
    while (!rest.empty()) {
      if (file->defines.size() >= kMostMacros) {
        return Note(line,
                    fmt::format("{} has more than {} macros", shoal::Quoted(name), kMostMacros));
      }
      const size_t end = std::min(rest.find('\n'), rest.size());
      const std::string_view text = Trimmed(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
      const size_t equals = text.find('=');
      const bool is_remark = text.starts_with('#') || text.starts_with("//");
      if (is_remark || equals == text.npos || equals == 0) continue;
      std::string_view value = Trimmed(text.substr(equals + 1));
      if (value.size() >= 2 && value.starts_with('"') && value.ends_with('"')) {
        value = value.substr(1, value.size() - 2);
      }
      file->defines.emplace(Trimmed(text.substr(0, equals)), value);
    }
  }

  /// `uPokeDB targ_shore.moos DEPLOY_ALL=true SPEED:=1.5`; of several "=" the first counts.
  void TakePoke(const ShellWords& words, int line) {
    constexpr size_t kMostPokes = 200;
    MoosButton poke{.key = "upokedb",
                    .label = "",
                    .origins = fmt::format("{}:{}", script_.name, line),
                    .posts = {}};
    for (const std::string& word : words) {
      if (word.starts_with('>') || word == "&") break;
      if (word.starts_with('-') || word.ends_with(".moos")) continue;
      const size_t equals = word.find('=');
      if (equals == word.npos || equals == 0) continue;
      const bool is_text = word[equals - 1] == ':';
      if (is_text && word.find(":=", equals + 1) != word.npos) continue;  // It refuses that.
      poke.posts.emplace_back(word.substr(0, equals - (is_text ? 1 : 0)), word.substr(equals + 1));
    }
    if (!poke.posts.empty() && plan_.pokes.size() < kMostPokes) {
      plan_.pokes.push_back(std::move(poke));
    }
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
  std::map<std::string, ShellWords, std::less<>> variables_;
  std::map<std::string, ShellWords, std::less<>> exported_;
  std::map<std::string, std::string, std::less<>> made_files_;
  std::set<std::string> noted_;
  int num_commands_ = 0;
  int depth_ = 0;
  int nesting_ = 0;  ///< Of references.
  int blocks_ = 0;   ///< Within one another.
};

}  // namespace

LaunchPlan ReadLaunchScript(const MoosSource& script, const FindMoosFile& find) {
  LaunchReader reader(find);
  reader.RunScript(script, {});
  return std::move(reader).TakePlan();
}

}  // namespace shoal
