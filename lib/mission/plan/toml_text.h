// Where values stand in the text of a TOML file: from their places, which are lines and columns, to
// bytes.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "lib/mission/toml/value.h"

namespace shoal {

/// A part of a text: the bytes from `begin` to before `end`.
struct TextSpan {
  size_t begin = 0;
  size_t end = 0;

  bool empty() const { return begin == end; }
  bool operator==(const TextSpan&) const = default;
};

class TomlText {
 public:
  /// @pre `text` is TOML, and outlives this
  explicit TomlText(std::string_view text);

  /// Returns the byte at a place of a value of this text. @pre the place is of the file
  [[nodiscard]] size_t ByteAt(const Place& place) const;
  /// Returns the whole of the value that begins at `begin`: a number or word, a string, an array or
  /// an inline table.
  [[nodiscard]] TextSpan ValueAt(size_t begin) const;
  /// Returns the first byte of the line behind that of `byte`, or the end of the text.
  [[nodiscard]] size_t NextLine(size_t byte) const;
  [[nodiscard]] std::string_view text() const { return text_; }

 private:
  size_t EndOfString(size_t begin) const;

  std::string_view text_;
  std::vector<size_t> lines_;  ///< Where each begins.
};

}  // namespace shoal
