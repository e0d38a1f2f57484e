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

/// $(NAME), %(NAME), or with = or := and a default.
struct Macro {
  size_t begin = 0;
  size_t end = 0;          ///< Behind it.
  std::string_view inner;  ///< Between the brackets.
  std::string_view name;
  std::string_view otherwise;  ///< The default; empty: none.
  bool counts_where_empty = false;
  bool is_upper = false;
};

/// Returns the first macro that closes behind `from`; of macros within one another the innermost.
std::optional<Macro> FindMacro(std::string_view text, size_t from) {
  for (size_t close = text.find(')', from); close != text.npos; close = text.find(')', close + 1)) {
    size_t open = close;
    while (open > from + 1 && text[open - 1] != '(' && text[open - 1] != ')') --open;
    if (open < from + 2 || text[open - 1] != '(') continue;
    const char kind = text[open - 2];
    if ((kind != '$' && kind != '%') || open == close) continue;
    Macro macro{.begin = open - 2,
                .end = close + 1,
                .inner = text.substr(open, close - open),
                .name = text.substr(open, close - open),
                .otherwise = {},
                .counts_where_empty = false,
                .is_upper = kind == '%'};
    // nsplug takes blanks at the ends of a macro for part of its name.
    const bool is_plain = Trimmed(macro.inner) == macro.inner;
    const size_t equals = macro.inner.find('=');
    if (is_plain && equals != macro.inner.npos && equals > 0) {
      macro.counts_where_empty = macro.inner[equals - 1] == ':';
      macro.name = macro.inner.substr(0, equals - (macro.counts_where_empty ? 1 : 0));
      macro.otherwise = macro.inner.substr(equals + 1);
    }
    return macro;
  }
  return std::nullopt;
}

/// Returns the name of a section that a line begins; nothing for any other line.
std::optional<std::string> SectionOf(std::string_view line) {
  constexpr std::string_view kTag = "<tag>";
  if (!line.starts_with(kTag)) return std::nullopt;
  std::string_view name = Trimmed(line.substr(kTag.size()));
  if (name.starts_with('<') && name.ends_with('>') && name.size() >= 2) {
    name = name.substr(1, name.size() - 2);
  }
  return std::string(name);
}

bool IsOfName(char c) { return IsNameCharacter(c) || c == '-' || c == '.'; }

/// Returns the text with a single blank for several.
std::string Compacted(std::string_view text) {
  std::string compact;
  for (const char c : text) {
    if (c != ' ' || !compact.ends_with(' ')) compact += c;
  }
  return compact;
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
  Plugger(const MoosDefines& defines, const FindMoosFile& find, const PlugOptions& options)
      : find_(find), options_(options) {
    for (const auto& [name, value] : defines) defines_.emplace(name, CleanUtf8(Trimmed(value)));
  }

  /// `section`: only the lines of that one; empty: all.
  void Run(const MoosSource& source, std::string_view section, const PluggedLine& including) {
    ++num_files_;
    open_files_.push_back(source.name);
    std::string at_section;
    std::string sections;
    bool is_found = section.empty();
    std::string_view text = source.text;
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
    const std::string name = CleanUtf8(source.name);
    for (int number = 1; !text.empty() && !is_full_; ++number) {
      const size_t end = std::min(text.find('\n'), text.size());
      std::string line(Trimmed(CleanUtf8(Trimmed(text.substr(0, end)))));
      text.remove_prefix(std::min(end + 1, text.size()));
      ++number_;
      const std::string origin = fmt::format("{}:{}", name, number);
      if (const auto begun = SectionOf(line)) {
        at_section = *begun;
        is_found = is_found || at_section == section;
        sections += (sections.empty() ? "" : ", ") + at_section;
      } else if (!line.empty() && (section.empty() || at_section == section)) {
        if (!section.empty() && line.front() == '#') {
          Add(origin, std::move(line),
              "is left out: in a section that is asked for by its name nsplug drops every line "
              "that begins with #, and the lines of all branches stand",
              true);
        } else {
          Line(origin, std::move(line));
        }
      }
    }
    if (!is_found) {
      Add(including.origin, including.text,
          fmt::format("is without effect: {} has no line <tag><{}>; its sections: {}", name,
                      section, sections.empty() ? "none" : sections.substr(0, 400)),
          true);
    }
    open_files_.pop_back();
    if (!open_files_.empty()) return;
    for (; !branches_.empty(); branches_.pop_back()) {
      Add(branches_.back().origin, branches_.back().text, "is not closed: write #endif", true);
    }
  }

  std::vector<PluggedLine> TakeLines() { return std::move(lines_); }

 private:
  /// One #ifdef that is open.
  struct Branch {
    std::string origin;
    std::string text;
    bool is_outer_on = true;  ///< What stands around it counts.
    bool is_on = false;       ///< What follows counts.
    bool was_on = false;      ///< One of its branches counted.
    bool is_else_seen = false;
    bool is_ifndef = false;
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

  /// A text with values for its macros, or as it is.
  struct Expansion {
    std::string text;
    std::string unknown;       ///< The first macro without a value: the text is as it was.
    bool is_too_long = false;  ///< With its values.
  };

  /// Returns the value of a macro; nothing where it has none.
  std::optional<std::string> ValueOf(const Macro& macro) const {
    const auto at = defines_.find(macro.name);
    const bool is_there = at != defines_.end();
    std::string value = is_there && at->second != kBareMacro ? at->second : "";
    if (!is_there || (value.empty() && macro.counts_where_empty)) {
      if (macro.otherwise.empty() && !is_there) return std::nullopt;
      value = macro.otherwise;
    }
    return macro.is_upper ? UpperCase(value) : value;
  }

  /// One macro without a value keeps the whole text as it is, as nsplug does; with --lenient only
  /// itself.
  Expansion Expanded(std::string_view whole, size_t most_bytes) const {
    constexpr int kMaxMacros = 1'000;
    std::string text(whole);
    std::string unknown;
    size_t from = 0;
    for (int i = 0; i < kMaxMacros; ++i) {
      const auto macro = FindMacro(text, from);
      if (!macro) {
        const size_t open = std::min(text.find("$(", from), text.find("%(", from));
        if (unknown.empty() && open != text.npos) unknown = text.substr(open, 2);
        if (unknown.empty() || options_.is_lenient) return {std::move(text), std::move(unknown)};
        return {.text = std::string(whole), .unknown = std::move(unknown)};
      }
      auto value = ValueOf(*macro);
      if (value) {
        text.replace(macro->begin, macro->end - macro->begin, *value);
        if (text.size() > most_bytes) break;
        continue;
      }
      if (unknown.empty()) unknown = text.substr(macro->begin, macro->end - macro->begin);
      if (!options_.is_lenient) return {.text = std::string(whole), .unknown = std::move(unknown)};
      from = macro->end;
    }
    return {.text = "", .unknown = "", .is_too_long = true};
  }

  void Line(const std::string& origin, std::string text) {
    if (text.front() == '#') return Directive(origin, text);
    if (!IsOn() || text.starts_with("//")) return;
    Expansion expansion = Expanded(text, kLongestLine_bytes);
    if (expansion.is_too_long) {
      text.resize(std::min<size_t>(text.size(), 80));
      return Add(origin, CleanUtf8(text), "is longer than 65,536 bytes with its macros' values",
                 true);
    }
    // A comment counts until here: a macro of it may have no value.
    const std::string_view own =
        Trimmed(std::string_view(expansion.text).substr(0, expansion.text.find("//")));
    if (own.empty()) return;
    if (options_.is_strict && !expansion.unknown.empty()) {
      return Add(origin, std::string(own),
                 fmt::format("is without a value for {}: with --strict nsplug writes nothing of "
                             "this file, whose other lines count here",
                             expansion.unknown),
                 true);
    }
    Add(origin, std::string(own), "", false);
    if (!is_full_) lines_.back().unknown = std::move(expansion.unknown);
  }

  void Directive(const std::string& origin, const std::string& text) {
    std::string_view rest = text;
    const std::string word(TakeWord(&rest));
    if (word == "#ifdef" || word == "#ifndef") return If(origin, text, rest, word == "#ifndef");
    if (word == "#elseifdef" || word == "#else") {
      return Else(origin, text, rest, word == "#else");
    }
    if (word == "#endif") {
      if (branches_.empty()) return Add(origin, text, "is without #ifdef", true);
      branches_.pop_back();
      return;
    }
    for (const std::string_view like : {"#if", "#el", "#end", "#inc", "#def"}) {
      if (!LowerCase(word).starts_with(like) || word == "#define" || word == "#include") continue;
      return Add(origin, text,
                 "is a remark for nsplug, without effect: it knows #include, #define, #ifdef, "
                 "#ifndef, #elseifdef, #else and #endif",
                 true);
    }
    if (!IsOn()) return;
    if (word == "#define") return Define(origin, text, rest);
    if (word == "#include") return Include(origin, text, rest);
    Add(origin, text, "is a remark", false);
  }

  /// Returns the value of a macro as #ifdef compares it; empty where it is not defined.
  std::string_view CompareValue(std::string_view name) const {
    const auto at = defines_.find(name);
    return at == defines_.end() ? std::string_view() : std::string_view(at->second);
  }

  /// "A", "A value", "A || B value", "A && B". An empty macro is not defined, but for `&&`.
  bool Holds(std::string_view condition) const {
    const bool is_or = condition.find("||") != condition.npos;
    const bool is_and = condition.find("&&") != condition.npos;
    if (is_or && is_and) return false;
    while (true) {
      const size_t end = std::min(condition.find(is_and ? "&&" : "||"), condition.size());
      std::string_view wanted = condition.substr(0, end);
      const std::string_view name = TakeWord(&wanted);
      const std::string_view value = CompareValue(name);
      const bool is_there = defines_.contains(name);
      const bool holds = wanted.empty() ? is_there && (is_and || !value.empty())
                                        : (is_there || is_and) &&
                                              (value == wanted || value == CompareValue(wanted));
      if (holds != is_and) return holds;
      if (end == condition.size()) return is_and;
      condition.remove_prefix(end + 2);
    }
  }

  /// Names that must all be without a value.
  bool NoneIsDefined(std::string_view names) const {
    if (names.empty()) return false;
    while (!names.empty()) {
      if (!CompareValue(TakeWord(&names)).empty()) return false;
    }
    return true;
  }

  void WarnOfCondition(const std::string& origin, const std::string& text,
                       std::string_view condition) {
    if (condition.empty()) return Add(origin, text, "is without the name of a macro", true);
    if (condition.find("||") != condition.npos && condition.find("&&") != condition.npos) {
      return Add(origin, text, "is never the case: || and && do not go together", true);
    }
    if (condition.find("//") == condition.npos) return;
    Add(origin, text, "is compared with its comment: write the comment on a line of its own", true);
  }

  void If(const std::string& origin, const std::string& text, std::string_view condition,
          bool is_ifndef) {
    const bool is_outer_on = IsOn();
    const bool is_on = is_outer_on && (is_ifndef ? NoneIsDefined(condition) : Holds(condition));
    branches_.push_back({.origin = origin,
                         .text = text,
                         .is_outer_on = is_outer_on,
                         .is_on = is_on,
                         .was_on = is_on,
                         .is_else_seen = false,
                         .is_ifndef = is_ifndef});
    if (is_outer_on) WarnOfCondition(origin, text, condition);
    if (is_outer_on && !is_on) AddLeftOut(origin, text);
  }

  void Else(const std::string& origin, const std::string& text, std::string_view condition,
            bool is_else) {
    if (branches_.empty()) return Add(origin, text, "is without #ifdef", true);
    Branch& branch = branches_.back();
    if (branch.is_else_seen) {
      return Add(origin, text, "is without effect: an #else is before it", true);
    }
    if (!is_else && branch.is_ifndef) {
      Add(origin, text, "is refused by nsplug: #elseifdef goes with #ifdef, not with #ifndef",
          true);
    }
    const bool counts = branch.is_outer_on && !branch.was_on;
    if (counts && !is_else) WarnOfCondition(origin, text, condition);
    branch.is_else_seen = is_else;
    branch.is_on = counts && (is_else || Holds(condition));
    branch.was_on = branch.was_on || branch.is_on;
    if (branch.is_outer_on && !branch.is_on) AddLeftOut(origin, text);
  }

  void AddLeftOut(const std::string& origin, const std::string& text) {
    Add(origin, text, "is not the case: what follows is left out; --define gives macros values",
        false);
  }

  void Define(const std::string& origin, const std::string& text, std::string_view whole) {
    const std::string compact = Compacted(whole);
    std::string_view rest = compact;
    std::string_view name = TakeWord(&rest);
    if (name.starts_with("$(") && name.ends_with(')')) name = name.substr(2, name.size() - 3);
    if (name.empty() || !std::all_of(name.begin(), name.end(), IsOfName)) {
      return Add(origin, text, "is not a #define NAME VALUE", true);
    }
    if (rest.size() > kLongestValue_bytes) {
      return Add(origin, text, "is longer than 4,096 bytes", true);
    }
    const std::string value(rest.empty() ? kBareMacro : rest);
    const auto at = defines_.find(name);
    if (at != defines_.end() && at->second != value) {
      Add(origin, text,
          fmt::format("is taken from here on, and not {} as before",
                      Quoted(std::string_view(at->second).substr(0, 80))),
          true);
    } else {
      Add(origin, text, "is taken: its value stands where the macro stands", false);
    }
    defines_.insert_or_assign(std::string(name), value);
  }

  /// nsplug looks from the folder in which it runs, which is taken for that of the first file.
  std::optional<MoosSource> Find(const std::string& name, bool* is_beside) const {
    if (find_ == nullptr) return std::nullopt;
    auto source = find_(name, open_files_.front());
    for (const std::string& path : options_.paths) {
      if (!source) source = find_(fmt::format("{}/{}", path, name), open_files_.front());
    }
    if (source || open_files_.size() == 1) return source;
    *is_beside = true;
    return find_(name, open_files_.back());
  }

  void Include(const std::string& origin, const std::string& text, std::string_view rest) {
    const Expansion expansion = Expanded(rest, kLongestValue_bytes);
    if (expansion.is_too_long) return Add(origin, text, "is longer than 4,096 bytes", true);
    std::string_view words = expansion.text;
    const size_t comment = words.find("//");
    if (comment != words.npos) {
      Add(origin, text,
          "is refused by nsplug, for which the comment belongs to the file's name: write it on a "
          "line of its own",
          true);
      words = Trimmed(words.substr(0, comment));
    }
    std::string_view section;
    const size_t blank = words.find_last_of(' ');
    if (words.ends_with('>') && blank != words.npos && words[blank + 1] == '<') {
      section = words.substr(blank + 2, words.size() - blank - 3);
      words = words.substr(0, blank);
    }
    std::string name(Unquoted(words));
    if (name.size() > 2 && name.front() == '<' && name.back() == '>') {
      name = name.substr(1, name.size() - 2);
    }
    if (open_files_.size() >= kDeepest || num_files_ >= kMaxFiles) {
      return Add(origin, text, "is one #include too many: 16 deep, 1,000 in all", true);
    }
    bool is_beside = false;
    const auto source = Find(name, &is_beside);
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
    if (is_beside) {
      Add(origin, text,
          "is taken from beside its own file, where nsplug does not look: name the folder with "
          "--path",
          true);
    } else {
      Add(origin, text, "is taken: its lines are here", false);
    }
    const std::string kept(section);
    Run(*source, kept, {.origin = origin, .text = text});
  }

  MoosDefines defines_;
  const FindMoosFile& find_;
  const PlugOptions& options_;
  std::vector<PluggedLine> lines_;
  std::vector<std::string> open_files_;
  std::vector<Branch> branches_;
  size_t num_files_ = 0;
  size_t num_bytes_ = 0;
  int number_ = 0;
  bool is_full_ = false;
};

}  // namespace

PluggedText Plug(const MoosSource& source, const MoosDefines& defines, const FindMoosFile& find,
                 const PlugOptions& options) {
  Plugger plugger(defines, find, options);
  plugger.Run(source, "", {});
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
