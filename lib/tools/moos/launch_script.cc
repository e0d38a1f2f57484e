#include "lib/tools/moos/launch_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/shell_condition.h"
#include "lib/tools/moos/shell_output.h"
#include "lib/tools/moos/shell_run.h"
#include "lib/tools/moos/shell_text.h"
#include "lib/tools/moos/shell_values.h"

namespace shoal {
namespace {

constexpr int kDeepestScript = 8;

/// Runs through a script: its blocks, and the commands that count.
class LaunchReader {
 public:
  explicit LaunchReader(const FindMoosFile& find) : values_(find) {}

  void RunScript(const MoosSource& script, const ShellWords& arguments) {
    if (depth_ >= kDeepestScript) return;
    ++depth_;
    const ShellScript outer =
        std::exchange(run_.script(),
                      {.name = FileName(script.name), .from = script.name, .arguments = arguments});
    ShellValues::Variables outer_variables = values_.Begin(depth_ > 1);
    std::vector<ShellCommand> commands = ShellCommandsOf(script.text);
    if (commands.size() > kMaxShellCommands) {
      run_.Note(commands[kMaxShellCommands].line, "is too long a script");
      commands.resize(kMaxShellCommands);
    }
    Run(commands, 0, commands.size());
    values_.Resume(std::move(outer_variables));
    run_.script() = outer;
    --depth_;
  }

  LaunchPlan TakePlan() && {
    plan_.plan().notes = run_.notes();
    return std::move(plan_.plan());
  }

 private:
  void Run(const std::vector<ShellCommand>& commands, size_t begin, size_t end) {
    for (size_t i = begin; i < end && !run_.script().is_ended;) {
      if (!run_.Count(1)) return run_.Note(commands[i].line, "is too long a script");
      const std::string& text = commands[i].text;
      const std::string word = FirstShellWord(text);
      const bool is_block =
          word == "if" || word == "for" || word == "while" || word == "until" || word == "case";
      if (is_block) {
        i = RunBlock(commands, i, end, word);
      } else if (word == "select") {
        run_.Note(commands[i].line, word + " is not read");
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
      run_.Note(commands[at].line,
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
        if (is_else || HoldsInShell(condition, &values_)) {
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
      run_.Note(commands[at].line, "case without in is not read");
      return esac + 1;
    }
    const std::string subject = JoinShellWords(values_.Expand(head[1], commands[at].line));
    // The first pattern may stand on the line of the head.
    std::vector<ShellCommand> parts = {
        {.line = commands[at].line, .text = JoinShellWords({head.begin() + 3, head.end()})}};
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
      const std::string pattern =
          JoinShellWords(values_.Expand(Trimmed(patterns.substr(0, bar)), line));
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
    for (int round = 0; HoldsInShell(condition, &values_) != is_until && !run_.script().is_ended;
         ++round) {
      if (run_.IsTooLong()) break;
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
    ShellWords values = run_.script().arguments;
    if (words.size() > 2 && words[2] == "in") {
      values.clear();
      for (size_t i = 3; i < words.size(); ++i) {
        for (std::string& each : values_.Expand(words[i], commands[at].line))
          values.push_back(each);
      }
    } else if (words.size() > 2) {
      run_.Note(commands[at].line, "this form of for is not read");
      return done + 1;
    }
    size_t body = at + 1;
    if (body < done && FirstShellWord(commands[body].text) == "do") ++body;
    for (const std::string& value : values) {
      if (run_.script().is_ended || run_.IsTooLong()) break;
      values_.Set(name, value);
      Run(commands, body, done);
    }
    return done + 1;
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
                            .text = JoinShellWords({raw.begin() + static_cast<long>(from),
                                                    raw.begin() + static_cast<long>(to)})};
      };
      const bool is_test = raw[0] == "[" || raw[0] == "[[" || raw[0] == "test";
      const bool holds = is_test ? HoldsInShell(text_of(0, i), &values_) : true;
      if (!is_test) Command(text_of(0, i));
      if (holds == (raw[i] == "&&")) Command(text_of(i + 1, raw.size()));
      return;
    }
    bool exports = false;
    while (!raw.empty() && (raw[0] == "export" || raw[0] == "local" || raw[0] == "declare")) {
      exports = raw[0] == "export";
      raw.erase(raw.begin());
    }
    while (!raw.empty() && values_.Assign(raw[0], command.line)) {
      if (exports) {
        values_.Export(raw[0].substr(0, raw[0].find_first_of("+=[")));
      }
      raw.erase(raw.begin());
    }
    if (raw.empty()) return;
    RunWords(values_.ExpandAll(raw, command.line), command.line);
  }

  void RunWords(ShellWords words, int line) {
    if (words.empty()) return;
    const std::string name = words.front();
    words.erase(words.begin());
    if (name == "eval") return Command({.line = line, .text = JoinShellWords(words)});
    if (name == "exit") {
      run_.script().is_ended = true;
    } else if (name == "echo") {
      Write(words, [](const ShellWords& own) { return JoinShellWords(own); });
    } else if (name == "pickpos") {
      Write(words, [&](ShellWords own) {
        own.insert(own.begin(), name);
        return ShellOutput(own, line, &run_);
      });
    } else if (name == "nsplug") {
      plan_.TakeNsplug(words, line, &run_);
    } else if (name == "pAntler") {
      if (!words.empty()) plan_.AddPlain(words[0], run_);
    } else if (name == "uPokeDB") {
      plan_.TakePoke(words, line, run_);
    } else if (name == "sh" || name == "bash" || name == "source" || name == ".") {
      if (!words.empty()) Call(words[0], {words.begin() + 1, words.end()}, line);
    } else if (name.ends_with(".sh")) {
      Call(name, words, line);
    }
  }

  void Call(const std::string& name, const ShellWords& arguments, int line) {
    const std::string file = FileName(name);
    if (file == "clean.sh" || file == "soft_reset.sh") return;
    const auto found = run_.Find(name);
    if (!found) return run_.Note(line, fmt::format("{} is not there", Quoted(name)));
    ShellWords own;
    for (const std::string& each : arguments) {
      if (each.starts_with('>') || each == "&") break;
      own.push_back(each);
    }
    plan_.plan().scripts.push_back(file);
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
      run_.Write(file, appends, print({words.begin(), words.begin() + static_cast<long>(i)}));
      return;
    }
  }

  ShellValues values_;
  ShellRun& run_ = values_.run();
  LaunchPlanDraft plan_;
  int depth_ = 0;
  int blocks_ = 0;  ///< Within one another.
};

}  // namespace

LaunchPlan ReadLaunchScript(const MoosSource& script, const FindMoosFile& find) {
  LaunchReader reader(find);
  reader.RunScript(script, {});
  return std::move(reader).TakePlan();
}

}  // namespace shoal
