#include "lib/tools/moos/moos_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {
namespace {

/// Returns what nsplug would have replaced; empty: nothing.
std::string UnresolvedMacro(const PluggedLine& plugged) {
  const std::string_view line = plugged.text;
  std::string macro = FirstMacro(line).empty() ? "" : plugged.unknown;
  for (const std::string_view begin : {"$(", "%(", "${"}) {
    if (macro.empty() && line.find(begin) != line.npos) macro = begin;
  }
  return macro;
}

/// True for apps that replace macros themselves while they run: $(XPOS) of a mouse click, $(IDX) of
/// a script.
bool HasMacrosOfItsOwn(std::string_view app) {
  const std::string lower = LowerCase(app);
  return lower.starts_with("pmarineviewer") || lower.starts_with("utimerscript");
}

class MoosFileParser {
 public:
  explicit MoosFileParser(std::string_view name) { file_.name = name; }

  void Line(const PluggedLine& line) {
    if (!line.reason.empty()) {
      file_.odd_lines.push_back({.number = line.number,
                                 .origin = line.origin,
                                 .text = line.text,
                                 .reason = line.reason,
                                 .is_loss = line.is_loss});
      return;
    }
    const bool is_of_app = place_ == Place::kInside && HasMacrosOfItsOwn(file_.blocks.back().app);
    const std::string macro = is_of_app ? "" : UnresolvedMacro(line);
    if (!macro.empty()) {
      // A block whose name or brace is on such a line is still a block.
      if (place_ == Place::kOutside && LowerCase(Split(line).key) == "processconfig") {
        OpenBlock(line);
      }
      return Odd(line, fmt::format("is for nsplug: {} has no value; give it one with --define "
                                   "NAME=VALUE",
                                   macro));
    }
    switch (place_) {
      case Place::kOutside:
        return Outside(line);
      case Place::kBeforeBrace:
        return BeforeBrace(line);
      case Place::kInside:
        return Inside(line);
    }
  }

  MoosFile Finish() && {
    if (place_ != Place::kOutside) NotClosed();
    std::stable_sort(file_.odd_lines.begin(), file_.odd_lines.end(),
                     [](const auto& a, const auto& b) { return a.number < b.number; });
    return std::move(file_);
  }

 private:
  enum class Place { kOutside, kBeforeBrace, kInside };

  static MoosLine Split(const PluggedLine& line) {
    const size_t equals = line.text.find('=');
    if (equals == std::string::npos) {
      return {
          .number = line.number, .origin = line.origin, .text = line.text, .key = "", .value = ""};
    }
    std::string_view value = std::string_view(line.text).substr(equals + 1);
    while (!Trimmed(value).empty() && Trimmed(value).back() == ';') {
      value = Trimmed(value);
      value.remove_suffix(1);
    }
    const std::string key(Trimmed(std::string_view(line.text).substr(0, equals)));
    const std::string written(Trimmed(value));
    return {.number = line.number,
            .origin = line.origin,
            .text = key + " = " + written,
            .key = key,
            .value = written};
  }

  void Odd(const PluggedLine& line, std::string reason, bool is_loss = true) {
    file_.odd_lines.push_back({.number = line.number,
                               .origin = line.origin,
                               .text = line.text,
                               .reason = std::move(reason),
                               .is_loss = is_loss});
  }

  /// The block that was opened last is odd.
  void OddBlock(std::string reason) {
    const MoosBlock& block = file_.blocks.back();
    file_.odd_lines.push_back({.number = block.number,
                               .origin = block.origin,
                               .text = "ProcessConfig = " + block.app,
                               .reason = std::move(reason)});
  }

  void OpenBlock(const PluggedLine& line) {
    std::string app = Split(line).value;
    const bool has_brace = app.ends_with('{');
    if (has_brace) app = Trimmed(std::string_view(app).substr(0, app.size() - 1));
    file_.blocks.push_back(
        {.app = std::move(app), .number = line.number, .origin = line.origin, .lines = {}});
    place_ = has_brace ? Place::kInside : Place::kBeforeBrace;
  }

  void NotClosed() {
    OddBlock("is a block that is not closed: write } on a line of its own at its end");
  }

  void Outside(const PluggedLine& line) {
    MoosLine split = Split(line);
    if (line.text.starts_with('/')) {
      Odd(line, "is a remark", false);
    } else if (split.key.empty()) {
      Odd(line, "is neither KEY = VALUE nor part of a ProcessConfig block");
    } else if (LowerCase(split.key) == "processconfig") {
      OpenBlock(line);
    } else {
      file_.globals.push_back(std::move(split));
    }
  }

  void BeforeBrace(const PluggedLine& line) {
    if (line.text.starts_with('{')) {
      place_ = Place::kInside;
      PluggedLine rest = line;
      rest.text = Trimmed(std::string_view(line.text).substr(1));
      if (!rest.text.empty()) Inside(rest);
      return;
    }
    OddBlock("is not followed by {: write it on a line of its own before the block's first line");
    place_ = Place::kOutside;
    Outside(line);
  }

  void Inside(const PluggedLine& line) {
    if (line.text == "}") {
      place_ = Place::kOutside;
      return;
    }
    MoosLine split = Split(line);
    if (LowerCase(split.key) == "processconfig") {
      NotClosed();
      OpenBlock(line);
    } else if (split.key.empty()) {
      Odd(line, "is not KEY = VALUE");
    } else {
      file_.blocks.back().lines.push_back(std::move(split));
    }
  }

  MoosFile file_;
  Place place_ = Place::kOutside;
};

}  // namespace

MoosFile ParseMoosFile(const PluggedText& text) {
  MoosFileParser parser(text.name);
  for (const PluggedLine& line : text.lines) parser.Line(line);
  return std::move(parser).Finish();
}

MoosFile ParseMoosFile(std::string_view text, std::string_view name) {
  return ParseMoosFile(Plug({.name = std::string(name), .text = std::string(text)}, {}, {}));
}

}  // namespace shoal
