#include "lib/tools/moos/bhv_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {
namespace {

/// Returns what is behind `word` where the line begins with it and a blank.
std::string_view Behind(std::string_view word, std::string_view text) {
  const bool is_there = text.size() > word.size() &&
                        LowerCase(text.substr(0, word.size())) == word &&
                        (text[word.size()] == ' ' || text[word.size()] == '\t');
  return is_there ? Trimmed(text.substr(word.size())) : std::string_view();
}

bool MayHoldVariables(std::string_view key) {
  const std::string lower = LowerCase(key.substr(0, 32));
  return lower == "condition" || lower == "lead_condition" || lower.ends_with("flag") ||
         lower.ends_with("flagx");
}

class BhvParser {
 public:
  explicit BhvParser(std::string name) { file_.name = std::move(name); }

  void Line(PluggedLine line) {
    if (!line.reason.empty()) return Odd(line, line.reason, line.is_loss);
    const bool goes_on = line.text.ends_with('\\');
    if (goes_on) line.text = Trimmed(std::string_view(line.text).substr(0, line.text.size() - 1));
    if (!begun_.text.empty()) {
      begun_.text += " " + line.text;
      line = std::exchange(begun_, {});
    }
    if (goes_on) {
      begun_ = std::move(line);
    } else if (!line.text.empty()) {
      Whole(line);
    }
  }

  BhvFile Finish() && {
    if (!begun_.text.empty()) Whole(std::exchange(begun_, {}));
    if (place_ != Place::kOutside && place_ != Place::kHeadless) NotClosed();
    std::stable_sort(file_.odd_lines.begin(), file_.odd_lines.end(),
                     [](const auto& a, const auto& b) { return a.number < b.number; });
    return std::move(file_);
  }

 private:
  enum class Place { kOutside, kBeforeBehavior, kBehavior, kBeforeMode, kMode, kHeadless };

  static MoosLine Split(const PluggedLine& line) {
    const std::string_view text = line.text;
    const size_t equals = text.find('=');
    if (equals == text.npos) {
      return {
          .number = line.number, .origin = line.origin, .text = line.text, .key = "", .value = ""};
    }
    const std::string key(Trimmed(text.substr(0, equals)));
    const std::string value(Trimmed(text.substr(equals + 1)));
    return {.number = line.number,
            .origin = line.origin,
            .text = key + " = " + value,
            .key = key,
            .value = value};
  }

  void Odd(const PluggedLine& line, std::string reason, bool is_loss = true) {
    file_.odd_lines.push_back({.number = line.number,
                               .origin = line.origin,
                               .text = line.text,
                               .reason = std::move(reason),
                               .is_loss = is_loss});
  }

  void NotClosed() {
    Odd(opened_, "is a block that is not closed: write } on a line of its own at its end");
    place_ = Place::kOutside;
  }

  void Whole(const PluggedLine& line) {
    switch (place_) {
      case Place::kOutside:
        return Outside(line);
      case Place::kBeforeBehavior:
      case Place::kBeforeMode:
        return BeforeBrace(line);
      case Place::kBehavior:
        return InBehavior(line);
      case Place::kMode:
        return InMode(line);
      case Place::kHeadless:
        return InHeadless(line);
    }
  }

  void Outside(const PluggedLine& line) {
    for (const std::string_view word : {"initialize", "initialize_"}) {
      if (!Behind(word, line.text).empty()) return Initialize(line, Behind(word, line.text));
    }
    if (IsMode(line)) return OpenMode(line);
    if (LowerCase(Split(line).key) == "behavior") return OpenBehavior(line);
    if (line.text.starts_with('{')) {
      // MOOS-IvP skips it, as the writer of a // before its head wants.
      place_ = Place::kHeadless;
      return Odd(line, "begins a block without a Behavior or set line before it: it is left out");
    }
    Odd(line, "is not one of initialize, set and Behavior");
  }

  static bool IsMode(const PluggedLine& line) {
    const std::string_view rest = Behind("set", line.text);
    return rest.find('=') != rest.npos;
  }

  /// Returns true for a line that is never inside a block.
  static bool IsOfOutside(const PluggedLine& line) {
    return IsMode(line) || LowerCase(Split(line).key) == "behavior" ||
           !Behind("initialize", line.text).empty() || !Behind("initialize_", line.text).empty();
  }

  void Initialize(const PluggedLine& line, std::string_view rest) {
    while (true) {
      size_t end = 0;
      for (bool is_quoted = false; end < rest.size() && (is_quoted || rest[end] != ','); ++end) {
        is_quoted = is_quoted != (rest[end] == '"');
      }
      PluggedLine one = line;
      one.text = Trimmed(rest.substr(0, end));
      MoosLine split = Split(one);
      if (!FirstMacro(one.text).empty()) {
        OddMacro(one);
      } else if (split.key.empty() || split.value.empty()) {
        Odd(one.text.empty() ? line : one, "is not VARIABLE = value");
      } else {
        file_.initials.push_back(std::move(split));
      }
      if (end == rest.size()) return;
      rest.remove_prefix(end + 1);
    }
  }

  void OddMacro(const PluggedLine& line) {
    Odd(line, fmt::format("is for nsplug: {} has no value; give it one with --define NAME=VALUE",
                          line.unknown.empty() ? FirstMacro(line.text) : line.unknown));
  }

  void OpenMode(const PluggedLine& line) {
    opened_ = line;
    const std::string_view text = Behind("set", line.text);
    const size_t equals = text.find('=');
    const size_t brace = std::min(text.find('{', equals), text.size());
    file_.modes.push_back(
        {.origin = line.origin,
         .variable = std::string(Trimmed(text.substr(0, equals))),
         .value = std::string(Trimmed(text.substr(equals + 1, brace - equals - 1))),
         .otherwise = "",
         .conditions = {}});
    place_ = Place::kBeforeMode;
    if (brace == text.size()) return;
    place_ = Place::kMode;
    PluggedLine rest = line;
    rest.text = Trimmed(text.substr(brace + 1));
    if (!rest.text.empty()) InMode(rest);
  }

  void OpenBehavior(const PluggedLine& line) {
    opened_ = line;
    std::string type = Split(line).value;
    const bool has_brace = type.ends_with('{');
    if (has_brace) type = Trimmed(std::string_view(type).substr(0, type.size() - 1));
    file_.behaviors.push_back({.type = std::move(type), .origin = line.origin, .lines = {}});
    place_ = has_brace ? Place::kBehavior : Place::kBeforeBehavior;
  }

  void BeforeBrace(const PluggedLine& line) {
    if (!line.text.starts_with('{')) {
      Odd(opened_, "is not followed by {: write it on a line of its own");
      place_ = Place::kOutside;
      return Outside(line);
    }
    place_ = place_ == Place::kBeforeMode ? Place::kMode : Place::kBehavior;
    PluggedLine rest = line;
    rest.text = Trimmed(std::string_view(line.text).substr(1));
    if (!rest.text.empty()) Whole(rest);
  }

  void InHeadless(const PluggedLine& line) {
    if (IsOfOutside(line)) {
      place_ = Place::kOutside;
      return Outside(line);
    }
    if (line.text.starts_with('}')) place_ = Place::kOutside;
    Odd(line, "is of a block that is left out", false);
  }

  void InMode(const PluggedLine& line) {
    if (IsOfOutside(line)) {
      NotClosed();
      return Outside(line);
    }
    const std::string_view text = line.text;
    const size_t brace = std::min(text.find('}'), text.size());
    const std::string_view condition = Trimmed(text.substr(0, brace));
    BhvMode& mode = file_.modes.back();
    if (!condition.empty()) {
      mode.conditions.push_back({.number = line.number,
                                 .origin = line.origin,
                                 .text = std::string(condition),
                                 .key = "",
                                 .value = ""});
    }
    if (brace == text.size()) return;
    mode.otherwise = Trimmed(text.substr(brace + 1));
    place_ = Place::kOutside;
  }

  void InBehavior(const PluggedLine& line) {
    if (line.text == "}") {
      place_ = Place::kOutside;
      return;
    }
    if (IsOfOutside(line)) {
      NotClosed();
      return Outside(line);
    }
    MoosLine split = Split(line);
    if (split.key.empty()) return Odd(line, "is not KEY = VALUE");
    if (!FirstMacro(line.text).empty() && !MayHoldVariables(split.key)) return OddMacro(line);
    file_.behaviors.back().lines.push_back(std::move(split));
  }

  BhvFile file_;
  Place place_ = Place::kOutside;
  PluggedLine opened_;
  PluggedLine begun_;  ///< A line that goes on in the next.
};

}  // namespace

BhvFile ParseBhvFile(const PluggedText& text) {
  BhvParser parser(text.name);
  for (const PluggedLine& line : text.lines) parser.Line(line);
  return std::move(parser).Finish();
}

}  // namespace shoal
