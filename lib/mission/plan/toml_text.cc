#include "lib/mission/plan/toml_text.h"

#include <algorithm>

namespace shoal {

TomlText::TomlText(std::string_view text) : text_(text), lines_{0} {
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') lines_.push_back(i + 1);
  }
}

size_t TomlText::ByteAt(const Place& place) const {
  const auto line = static_cast<size_t>(std::max<int64_t>(place.line, 1)) - 1;
  size_t byte = line < lines_.size() ? lines_[line] : text_.size();
  // Columns count characters; of UTF-8 all bytes but the first of one are 10xxxxxx.
  for (int64_t column = 1; column < place.column && byte < text_.size(); ++column) {
    ++byte;
    while (byte < text_.size() && (static_cast<unsigned char>(text_[byte]) & 0xc0) == 0x80) ++byte;
  }
  return byte;
}

size_t TomlText::NextLine(size_t byte) const {
  const size_t end = text_.find('\n', byte);
  return end == text_.npos ? text_.size() : end + 1;
}

size_t TomlText::EndOfString(size_t begin) const {
  const char quote = text_[begin];
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool is_long = text_.substr(begin).starts_with(triple);
  size_t at = begin + (is_long ? 3 : 1);
  for (; at < text_.size(); ++at) {
    if (quote == '"' && text_[at] == '\\') {
      ++at;
    } else if (!is_long && text_[at] == quote) {
      return at + 1;
    } else if (is_long && text_.substr(at).starts_with(triple)) {
      at += 3;
      while (at < text_.size() && text_[at] == quote) ++at;  // Two more may belong to it.
      return at;
    }
  }
  return text_.size();
}

TextSpan TomlText::ValueAt(size_t begin) const {
  if (begin >= text_.size()) return {text_.size(), text_.size()};
  if (text_[begin] == '"' || text_[begin] == '\'') return {begin, EndOfString(begin)};
  if (text_[begin] != '[' && text_[begin] != '{') {
    return {begin, std::min(text_.find_first_of(",]}# \t\r\n", begin), text_.size())};
  }
  int depth = 0;
  for (size_t at = begin; at < text_.size();) {
    const char letter = text_[at];
    if (letter == '"' || letter == '\'') {
      at = EndOfString(at);
      continue;
    }
    if (letter == '#') at = std::min(text_.find('\n', at), text_.size() - 1);
    if (letter == '[' || letter == '{') ++depth;
    if ((letter == ']' || letter == '}') && --depth == 0) return {begin, at + 1};
    ++at;
  }
  return {begin, text_.size()};
}

}  // namespace shoal
