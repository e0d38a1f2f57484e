// Numbers and texts as Fortran's list-directed input reads them: the form of Bellhop's files.
//
//   ListText text("bay.env", content);
//   const Result<std::vector<std::optional<double>>> record = text.Numbers(6);
//
// Blanks, tabs, commas and ends of lines separate items. A record takes as many lines as it has
// items; `/` ends it early and leaves the items that are missing as they were, as two commas leave
// one. What follows the last item on its line is ignored, so that a comment may stand there.
// `3*0.5` is three items, 1d-3 is a number, a text stands in single or double quotes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

class ListText {
 public:
  /// `name` is the file's, for messages. Both outlive it.
  ListText(std::string_view name, std::string_view text) : name_(name), text_(text) {}

  /// Reads a record of up to `count` numbers; nullopt: the item is left as it was. The error names
  /// file, line and the word that is not a number, or states what is missing at the file's end.
  Result<std::vector<std::optional<double>>> Numbers(size_t count, std::string_view what);
  /// Reads a record of one number that must be there.
  Result<double> Number(std::string_view what);
  /// Reads a record of one number that must be there and be whole, from `least` to `most`.
  Result<int> Count(std::string_view what, int least, int most);
  /// Reads a record that begins with a text, in quotes or one word.
  Result<std::string> Text(std::string_view what);
  /// Reads `count` numbers wherever lines end, without passing over the rest of the last line.
  Result<std::vector<double>> Items(size_t count, std::string_view what);

  /// Returns whether only blanks follow.
  [[nodiscard]] bool IsAtEnd() const;
  /// Returns an error at the last item that was read: "bay.env:3: ...".
  [[nodiscard]] Error Refuse(std::string_view message) const;

 private:
  struct Item {
    std::string_view word;    ///< Empty with neither flag: a null item.
    bool is_end = false;      ///< `/`.
    bool is_missing = false;  ///< The file ends.
  };
  Item Next();
  void SkipBlanks();
  void SkipLine();

  std::string_view name_;
  std::string_view text_;
  size_t at_ = 0;
  int line_ = 1;
  int item_line_ = 1;
};

}  // namespace shoal
