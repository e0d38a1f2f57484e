#include "lib/run/moos_text/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>

#include "lib/base/text/blanks.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool IsControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

std::optional<unsigned> HexDigit(char c) {
  if (c >= '0' && c <= '9') return static_cast<unsigned>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A' + 10);
  return std::nullopt;
}

/// Returns the place behind the '}' that closes the '{' at the beginning; npos: it stays open.
size_t EndOfBraces(std::string_view text) {
  size_t depth = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i + 1;
  }
  return std::string_view::npos;
}

class FieldReader {
 public:
  explicit FieldReader(std::string_view text) : text_(text) {}

  Result<std::vector<MoosField>> ReadAll() {
    std::vector<MoosField> fields;
    while (SkipToField()) {
      MoosField field;
      if (!ReadKey(fields.size() + 1, &field.key) || !ReadValue(field.key, &field.value)) {
        return Error{std::move(problem_)};
      }
      fields.push_back(std::move(field));
    }
    return fields;
  }

 private:
  bool AtEnd() const { return at_ == text_.size(); }
  void SkipBlanks() { at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size()); }

  /// Skips blanks and the commas of empty fields. Returns false at the end.
  bool SkipToField() {
    SkipBlanks();
    while (!AtEnd() && text_[at_] == ',') {
      ++at_;
      SkipBlanks();
    }
    return !AtEnd();
  }

  std::string_view TakeUntil(std::string_view stops) {
    const size_t end = std::min(text_.find_first_of(stops, at_), text_.size());
    const std::string_view taken = text_.substr(at_, end - at_);
    at_ = end;
    return taken;
  }

  bool Fail(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  bool ReadKey(size_t number, std::string* key) {
    if (text_[at_] == '"') {
      if (!ReadQuoted(key)) {
        return Fail(fmt::format("the double quote that begins field {} is never closed", number));
      }
      SkipBlanks();
    } else {
      *key = Trimmed(TakeUntil("=,"));
      if (key->empty()) {
        return Fail(fmt::format("field {} has no key; write KEY=VALUE", number));
      }
    }
    if (AtEnd() || text_[at_] != '=') {
      return Fail(
          fmt::format("field {}, {}, has no '='; write KEY=VALUE, and a value that holds a comma "
                      "in double quotes",
                      number, Quoted(*key)));
    }
    ++at_;
    return true;
  }

  bool ReadValue(const std::string& key, std::string* value) {
    SkipBlanks();
    if (!AtEnd() && text_[at_] == '"') {
      if (!ReadQuoted(value)) {
        return Fail(fmt::format("the double quote of {} is never closed", Quoted(key)));
      }
      const std::string_view rest = Trimmed(TakeUntil(","));
      if (rest.empty()) return true;
      return Fail(
          fmt::format("{} follows the closing quote of {}; write \\\" for a quote within "
                      "quotes",
                      Quoted(rest), Quoted(key)));
    }
    const size_t begin = at_;
    if (!AtEnd() && text_[at_] == '{') {
      const size_t size = EndOfBraces(text_.substr(at_));
      if (size == std::string_view::npos) {
        return Fail(
            fmt::format("the '{{' of {} is never closed; write such a value in double "
                        "quotes",
                        Quoted(key)));
      }
      at_ += size;
    }
    TakeUntil(",");
    *value = Trimmed(text_.substr(begin, at_ - begin));
    return true;
  }

  /// Reads from one double quote to the next that no backslash precedes.
  bool ReadQuoted(std::string* content) {
    ++at_;
    while (!AtEnd() && text_[at_] != '"') {
      if (text_[at_] == '\\') {
        ReadEscape(content);
      } else {
        *content += text_[at_++];
      }
    }
    if (AtEnd()) return false;
    ++at_;
    return true;
  }

  void ReadEscape(std::string* content) {
    constexpr std::string_view kLetters = "\"\\nrt";
    constexpr std::string_view kMeanings = "\"\\\n\r\t";
    const std::string_view rest = text_.substr(at_ + 1);
    const size_t letter = rest.empty() ? std::string_view::npos : kLetters.find(rest[0]);
    if (letter != std::string_view::npos) {
      *content += kMeanings[letter];
      at_ += 2;
      return;
    }
    if (rest.size() >= 3 && rest[0] == 'x') {
      const auto high = HexDigit(rest[1]);
      const auto low = HexDigit(rest[2]);
      if (high && low) {
        *content += static_cast<char>(*high * 16 + *low);
        at_ += 4;
        return;
      }
    }
    *content += '\\';
    ++at_;
  }

  std::string_view text_;
  size_t at_ = 0;
  std::string problem_;
};

void AppendInQuotes(std::string_view text, std::string* out) {
  *out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      *out += '\\';
      *out += c;
    } else if (c == '\n') {
      *out += "\\n";
    } else if (c == '\r') {
      *out += "\\r";
    } else if (c == '\t') {
      *out += "\\t";
    } else if (IsControl(c)) {
      *out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    } else {
      *out += c;
    }
  }
  *out += '"';
}

/// True where `text` can stand without quotes as far as its characters and ends are concerned.
bool IsBare(std::string_view text) {
  return Trimmed(text).size() == text.size() &&
         std::none_of(text.begin(), text.end(), [](char c) { return c == '"' || IsControl(c); });
}

bool IsBareKey(std::string_view key) {
  return !key.empty() && IsBare(key) && key.find_first_of("=,") == std::string_view::npos;
}

bool IsBareValue(std::string_view value) {
  if (!IsBare(value)) return false;
  if (value.empty() || value[0] != '{') return value.find(',') == std::string_view::npos;
  const size_t end = EndOfBraces(value);
  return end != std::string_view::npos && value.find(',', end) == std::string_view::npos;
}

}  // namespace

Result<std::vector<MoosField>> ParseFields(std::string_view text) {
  return FieldReader(text).ReadAll();
}

void AppendField(std::string_view key, std::string_view value, std::string* out) {
  if (!out->empty()) *out += ',';
  if (IsBareKey(key)) {
    *out += key;
  } else {
    AppendInQuotes(key, out);
  }
  *out += '=';
  if (IsBareValue(value)) {
    *out += value;
  } else {
    AppendInQuotes(value, out);
  }
}

}  // namespace shoal
