#include "lib/tools/moos/nsplug.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {
namespace {

constexpr size_t kMaxLines = 100'000;
constexpr size_t kMax_bytes = 20'000'000;
constexpr size_t kMaxFiles = 1'000;
constexpr size_t kDeepest = 16;
constexpr size_t kLongestValue_bytes = 4'096;
constexpr size_t kLongestLine_bytes = 65'536;

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

bool IsOfName(char c) { return IsNameCharacter(c) || c == '-' || c == '.'; }

/// $(NAME), %(NAME), or with := and a default.
struct Macro {
  size_t begin = 0;
  size_t end = 0;  ///< Behind it.
  std::string_view name;
  std::optional<std::string_view> otherwise;
  bool is_upper = false;
};

std::optional<Macro> FindMacro(std::string_view text, size_t from) {
  for (size_t at = from; at + 2 < text.size(); ++at) {
    if ((text[at] != '$' && text[at] != '%') || text[at + 1] != '(') continue;
    size_t end = at + 2;
    while (end < text.size() && IsOfName(text[end])) ++end;
    Macro macro{.begin = at,
                .end = end + 1,
                .name = text.substr(at + 2, end - at - 2),
                .otherwise = std::nullopt,
                .is_upper = text[at] == '%'};
    if (macro.name.empty()) continue;
    if (text.substr(end).starts_with(":=")) {
      const size_t close = text.find(')', end);
      if (close == text.npos) continue;
      macro.otherwise = text.substr(end + 2, close - end - 2);
      macro.end = close + 1;
      return macro;
    }
    if (end < text.size() && text[end] == ')') return macro;
  }
  return std::nullopt;
}

std::string_view Unquoted(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

/// Returns the first word, and takes it off `text`.
std::string_view TakeWord(std::string_view* text) {
  *text = Trimmed(*text);
  const std::string_view word = text->substr(0, text->find_first_of(" \t"));
  *text = Trimmed(text->substr(word.size()));
  return word;
}

class Plugger {
 public:
  Plugger(const MoosDefines& defines, const FindMoosFile& find) : given_(defines), find_(find) {
    for (const auto& [name, value] : defines) defines_.emplace(name, CleanUtf8(value));
  }

  void Run(const MoosSource& source, std::string_view tag) {
    ++num_files_;
    open_files_.push_back(source.name);
    const size_t outer_branches = branches_.size();
    bool is_of_tag = tag.empty();
    std::string_view text = source.text;
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    const std::string name = CleanUtf8(source.name);
    for (int number = 1; !text.empty() && !is_full_; ++number) {
      const size_t end = std::min(text.find('\n'), text.size());
      const std::string_view raw = text.substr(0, end);
      text.remove_prefix(std::min(end + 1, text.size()));
      std::string line = CleanUtf8(Trimmed(raw.substr(0, raw.find("//"))));
      ++number_;
      if (line.empty()) continue;
      const bool is_tag = line.size() > 2 && line.front() == '<' && line.back() == '>';
      if (!tag.empty() && is_tag) {
        is_of_tag = line == tag;
        continue;
      }
      if (is_of_tag) Line(fmt::format("{}:{}", name, number), std::move(line));
    }
    for (; branches_.size() > outer_branches; branches_.pop_back()) {
      Add(branches_.back().origin, branches_.back().text, "is not closed: write #endif", true);
    }
    open_files_.pop_back();
  }

  std::vector<PluggedLine> TakeLines() { return std::move(lines_); }

 private:
  /// One #ifdef that is open.
  struct Branch {
    std::string origin;
    std::string text;
    size_t file = 0;          ///< Its index among the open files.
    bool is_outer_on = true;  ///< What stands around it counts.
    bool is_on = false;       ///< What follows counts.
    bool was_on = false;      ///< One of its branches counted.
    bool is_else_seen = false;
  };

  bool IsOn() const { return branches_.empty() || branches_.back().is_on; }

  void Add(std::string origin, std::string text, std::string reason, bool is_loss) {
    if (is_full_) return;
    num_bytes_ += text.size();
    if (lines_.size() >= kMaxLines || num_bytes_ > kMax_bytes) {
      is_full_ = true;
      reason = "is too much: what follows is left out; 100,000 lines and 20 MB are the most";
      is_loss = true;
    }
    lines_.push_back({.number = number_,
                      .origin = std::move(origin),
                      .text = std::move(text),
                      .reason = std::move(reason),
                      .is_loss = is_loss});
  }

  /// Returns the text with values for macros; nothing where it becomes too long.
  std::optional<std::string> Expanded(std::string_view text, size_t most_bytes) const {
    std::string expanded;
    size_t from = 0;
    while (const auto macro = FindMacro(text, from)) {
      expanded += text.substr(from, macro->begin - from);
      const auto at = defines_.find(macro->name);
      std::string value(text.substr(macro->begin, macro->end - macro->begin));
      if (at != defines_.end()) {
        value = macro->is_upper ? UpperCase(at->second) : at->second;
      } else if (macro->otherwise) {
        value = macro->is_upper ? UpperCase(*macro->otherwise) : std::string(*macro->otherwise);
      }
      expanded += value;
      from = macro->end;
      if (expanded.size() > most_bytes) return std::nullopt;
    }
    expanded += text.substr(from);
    return expanded.size() > most_bytes ? std::nullopt : std::optional(expanded);
  }

  void Line(const std::string& origin, std::string text) {
    if (text.front() == '#') return Directive(origin, text);
    if (!IsOn()) return;
    auto expanded = Expanded(text, kLongestLine_bytes);
    if (!expanded) {
      text.resize(std::min<size_t>(text.size(), 80));
      return Add(origin, CleanUtf8(text), "is longer than 65,536 bytes with its macros' values",
                 true);
    }
    if (!Trimmed(*expanded).empty()) Add(origin, std::string(Trimmed(*expanded)), "", false);
  }

  void Directive(const std::string& origin, const std::string& text) {
    std::string_view rest = text;
    const std::string word = LowerCase(TakeWord(&rest));
    if (word == "#ifdef" || word == "#ifndef") return If(origin, text, rest, word == "#ifdef");
    if (word == "#elseifdef" || word == "#elseif" || word == "#else") {
      return Else(origin, text, rest, word == "#else");
    }
    if (word == "#endif") {
      if (!IsBranchOfThisFile()) return Add(origin, text, "is without #ifdef", true);
      branches_.pop_back();
      return;
    }
    if (!IsOn()) return;
    if (word == "#define") return Define(origin, text, rest);
    if (word == "#include") return Include(origin, text, rest);
    Add(origin, text, "is no line that nsplug knows", true);
  }

  bool IsBranchOfThisFile() const {
    return !branches_.empty() && branches_.back().file == open_files_.size();
  }

  /// "A", "A value", "A || B value", "A && B".
  bool Holds(std::string_view condition) const {
    bool any = false;
    while (true) {
      const size_t end = std::min(condition.find("||"), condition.size());
      any = any || AllHold(condition.substr(0, end));
      if (end == condition.size()) return any;
      condition.remove_prefix(end + 2);
    }
  }

  bool AllHold(std::string_view condition) const {
    bool all = true;
    while (true) {
      const size_t end = std::min(condition.find("&&"), condition.size());
      std::string_view term = condition.substr(0, end);
      const auto at = defines_.find(TakeWord(&term));
      all = all && at != defines_.end() && (term.empty() || Unquoted(term) == Unquoted(at->second));
      if (end == condition.size()) return all;
      condition.remove_prefix(end + 2);
    }
  }

  void If(const std::string& origin, const std::string& text, std::string_view condition,
          bool wanted) {
    const bool is_outer_on = IsOn();
    const bool is_on = is_outer_on && Holds(condition) == wanted;
    branches_.push_back({.origin = origin,
                         .text = text,
                         .file = open_files_.size(),
                         .is_outer_on = is_outer_on,
                         .is_on = is_on,
                         .was_on = is_on});
    if (condition.empty()) return Add(origin, text, "is without the name of a macro", true);
    if (is_outer_on && !is_on) AddLeftOut(origin, text);
  }

  void Else(const std::string& origin, const std::string& text, std::string_view condition,
            bool is_else) {
    if (!IsBranchOfThisFile() || branches_.back().is_else_seen) {
      return Add(origin, text, "is without #ifdef", true);
    }
    Branch& branch = branches_.back();
    branch.is_else_seen = is_else;
    branch.is_on = branch.is_outer_on && !branch.was_on && (is_else || Holds(condition));
    branch.was_on = branch.was_on || branch.is_on;
    if (branch.is_outer_on && !branch.is_on) AddLeftOut(origin, text);
  }

  void AddLeftOut(const std::string& origin, const std::string& text) {
    Add(origin, text, "is not the case: what follows is left out; --define gives macros values",
        false);
  }

  void Define(const std::string& origin, const std::string& text, std::string_view rest) {
    std::string_view name = TakeWord(&rest);
    if (name.starts_with("$(") && name.ends_with(')')) name = name.substr(2, name.size() - 3);
    const auto value = Expanded(Unquoted(rest), kLongestValue_bytes);
    if (name.empty() || !std::all_of(name.begin(), name.end(), IsOfName)) {
      return Add(origin, text, "is no #define NAME VALUE", true);
    }
    if (!value) return Add(origin, text, "is longer than 4,096 bytes", true);
    if (given_.contains(name)) {
      return Add(origin, text, fmt::format("is replaced by the value that {} is given", name),
                 false);
    }
    defines_.insert_or_assign(std::string(name), *value);
    Add(origin, text, "is taken: its value stands where the macro stands", false);
  }

  void Include(const std::string& origin, const std::string& text, std::string_view rest) {
    const auto expanded = Expanded(rest, kLongestValue_bytes);
    if (!expanded) return Add(origin, text, "is longer than 4,096 bytes", true);
    std::string_view words = *expanded;
    std::string name(Unquoted(TakeWord(&words)));
    const std::string tag(words);
    if (name.size() > 2 && name.front() == '<' && name.back() == '>') {
      name = name.substr(1, name.size() - 2);
    }
    if (open_files_.size() >= kDeepest || num_files_ >= kMaxFiles) {
      return Add(origin, text, "is one #include too many: 16 deep, 1,000 in all", true);
    }
    const auto source = find_ == nullptr ? std::nullopt : find_(name, open_files_.back());
    if (!source) {
      return Add(origin, text,
                 fmt::format(
                     "is for nsplug, and no file {} is there or below: name its folder with --path",
                     Quoted(name)),
                 true);
    }
    if (std::find(open_files_.begin(), open_files_.end(), source->name) != open_files_.end()) {
      return Add(origin, text, "is in a circle: the file includes itself", true);
    }
    Add(origin, text, "is taken: its lines stand here", false);
    Run(*source, tag);
  }

  const MoosDefines& given_;
  MoosDefines defines_;
  const FindMoosFile& find_;
  std::vector<PluggedLine> lines_;
  std::vector<std::string> open_files_;
  std::vector<Branch> branches_;
  size_t num_files_ = 0;
  size_t num_bytes_ = 0;
  int number_ = 0;
  bool is_full_ = false;
};

}  // namespace

PluggedText Plug(const MoosSource& source, const MoosDefines& defines, const FindMoosFile& find) {
  Plugger plugger(defines, find);
  plugger.Run(source, "");
  return {.name = CleanUtf8(source.name), .lines = plugger.TakeLines()};
}

std::string FileName(std::string_view path) {
  const size_t slash = path.find_last_of('/');
  return std::string(slash == path.npos ? path : path.substr(slash + 1));
}

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

std::string FirstMacro(std::string_view text) {
  const auto macro = FindMacro(text, 0);
  if (!macro) return {};
  return std::string(text.substr(macro->begin, macro->end - macro->begin));
}

}  // namespace shoal
