#include "lib/moos/moos_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "lib/mission/suggest.h"
#include "lib/moos/fields.h"

namespace shoal {
namespace {

/// Returns the length of the UTF-8 character that `text` begins with, 0 where there is none
/// (RFC 3629: no surrogates, nothing beyond U+10FFFF, no longer form than needed).
size_t CharacterLength(std::string_view text) {
  const auto byte = [&](size_t i) { return static_cast<uint8_t>(text[i]); };
  const uint8_t lead = byte(0);
  if (lead < 0x80) return 1;
  const size_t length = lead >= 0xC2 && lead <= 0xDF   ? 2
                        : lead >= 0xE0 && lead <= 0xEF ? 3
                        : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                       : 0;
  if (length == 0 || text.size() < length) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool is_too_long = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
  const bool is_no_character = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
  return is_too_long || is_no_character ? 0 : length;
}

/// What nsplug would have replaced.
bool IsTemplate(std::string_view line) {
  return line.starts_with('#') || line.find("$(") != std::string_view::npos ||
         line.find("%(") != std::string_view::npos || line.find("${") != std::string_view::npos;
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

  void Line(int number, std::string text) {
    if (text.empty()) return;
    const bool is_of_app = place_ == Place::kInside && !text.starts_with('#') &&
                           HasMacrosOfItsOwn(file_.blocks.back().app);
    if (IsTemplate(text) && !is_of_app) {
      const std::string remedy =
          "is for nsplug, which has not run: run nsplug on the file and import what it writes";
      // A block whose name or brace is on such a line is still a block.
      if (!text.starts_with('#') && place_ == Place::kOutside && !Split(number, text).key.empty() &&
          LowerCase(Split(number, text).key) == "processconfig") {
        OpenBlock(number, text);
      }
      return Odd(number, std::move(text), remedy);
    }
    switch (place_) {
      case Place::kOutside:
        return Outside(number, std::move(text));
      case Place::kBeforeBrace:
        return BeforeBrace(number, std::move(text));
      case Place::kInside:
        return Inside(number, std::move(text));
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

  static MoosLine Split(int number, const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos)
      return {.number = number, .text = text, .key = "", .value = ""};
    std::string_view value = std::string_view(text).substr(equals + 1);
    while (!Trimmed(value).empty() && Trimmed(value).back() == ';') {
      value = Trimmed(value);
      value.remove_suffix(1);
    }
    const std::string key(Trimmed(std::string_view(text).substr(0, equals)));
    const std::string written(Trimmed(value));
    return {.number = number, .text = key + " = " + written, .key = key, .value = written};
  }

  void Odd(int number, std::string text, std::string reason) {
    file_.odd_lines.push_back(
        {.number = number, .text = std::move(text), .reason = std::move(reason)});
  }

  void OpenBlock(int number, const std::string& text) {
    std::string app = Split(number, text).value;
    const bool has_brace = app.ends_with('{');
    if (has_brace) app = Trimmed(std::string_view(app).substr(0, app.size() - 1));
    file_.blocks.push_back({.app = std::move(app), .number = number, .lines = {}});
    place_ = has_brace ? Place::kInside : Place::kBeforeBrace;
  }

  void NotClosed() {
    const MoosBlock& block = file_.blocks.back();
    Odd(block.number, "ProcessConfig = " + block.app,
        "is a block that is not closed: write } on a line of its own at its end");
  }

  void Outside(int number, std::string text) {
    MoosLine line = Split(number, text);
    if (line.key.empty()) {
      Odd(number, std::move(text), "is neither KEY = VALUE nor part of a ProcessConfig block");
    } else if (LowerCase(line.key) == "processconfig") {
      OpenBlock(number, text);
    } else {
      file_.globals.push_back(std::move(line));
    }
  }

  void BeforeBrace(int number, std::string text) {
    if (text.starts_with('{')) {
      place_ = Place::kInside;
      std::string rest(Trimmed(std::string_view(text).substr(1)));
      if (!rest.empty()) Inside(number, std::move(rest));
      return;
    }
    const MoosBlock& block = file_.blocks.back();
    Odd(block.number, "ProcessConfig = " + block.app,
        "is not followed by {: write it on a line of its own before the block's first line");
    place_ = Place::kOutside;
    Outside(number, std::move(text));
  }

  void Inside(int number, std::string text) {
    if (text == "}") {
      place_ = Place::kOutside;
      return;
    }
    MoosLine line = Split(number, text);
    if (LowerCase(line.key) == "processconfig") {
      NotClosed();
      OpenBlock(number, text);
    } else if (line.key.empty()) {
      Odd(number, std::move(text), "is not KEY = VALUE");
    } else {
      file_.blocks.back().lines.push_back(std::move(line));
    }
  }

  MoosFile file_;
  Place place_ = Place::kOutside;
};

}  // namespace

std::string CleanUtf8(std::string_view text) {
  std::string line;
  line.reserve(text.size());
  while (!text.empty()) {
    const size_t length = CharacterLength(text);
    const bool is_control = static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7F;
    if (length == 0 || is_control) {
      line += text[0] == '\t' ? ' ' : '?';
    } else {
      line += text.substr(0, length);
    }
    text.remove_prefix(std::max(length, size_t{1}));
  }
  return line;
}

MoosFile ParseMoosFile(std::string_view text, std::string_view name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  MoosFileParser parser(CleanUtf8(name));
  for (int number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    parser.Line(number, CleanUtf8(Trimmed(line.substr(0, line.find("//")))));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return std::move(parser).Finish();
}

}  // namespace shoal
