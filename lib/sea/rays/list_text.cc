#include "lib/sea/rays/list_text.h"

#include <algorithm>
#include <cmath>

#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

bool IsSpace(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// "1d-3" and "1D-3" are numbers of Fortran; so is ".5" and "5.".
std::optional<double> FortranNumber(std::string_view word) {
  std::string text(word);
  std::ranges::replace(text, 'd', 'e');
  std::ranges::replace(text, 'D', 'e');
  return ReadNumber<double>(text);
}

std::string Shortened(std::string_view word) {
  constexpr size_t kMaxLength = 40;
  std::string text(word.substr(0, kMaxLength));
  std::ranges::replace_if(
      text, [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

}  // namespace

void ListText::SkipBlanks() {
  while (at_ < text_.size() && IsSpace(text_[at_])) {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
}

void ListText::SkipLine() {
  while (at_ < text_.size() && text_[at_] != '\n') ++at_;
}

ListText::Item ListText::Next() {
  SkipBlanks();
  item_line_ = line_;
  if (at_ >= text_.size()) return {.word = {}, .is_end = false, .is_missing = true};
  const char first = text_[at_];
  if (first == '/') {
    ++at_;
    return {.word = {}, .is_end = true, .is_missing = false};
  }
  const size_t begin = at_;
  while (at_ < text_.size() && !IsSpace(text_[at_]) && text_[at_] != ',' && text_[at_] != '/') {
    ++at_;
  }
  const std::string_view word = text_.substr(begin, at_ - begin);
  while (at_ < text_.size() && IsSpace(text_[at_]) && text_[at_] != '\n') ++at_;
  if (at_ < text_.size() && text_[at_] == ',') ++at_;
  return {.word = word, .is_end = false, .is_missing = false};
}

Error ListText::Refuse(std::string_view message) const {
  return Error{std::string(name_) + ":" + std::to_string(item_line_) + ": " + std::string(message)};
}

Result<std::vector<std::optional<double>>> ListText::Numbers(size_t count, std::string_view what) {
  std::vector<std::optional<double>> numbers;
  while (numbers.size() < count) {
    const Item item = Next();
    if (item.is_missing) {
      return Refuse("the file ends, but " + std::string(what) + " is expected here");
    }
    if (item.is_end) break;
    std::string_view word = item.word;
    size_t repeats = 1;
    if (const size_t star = word.find('*'); star != std::string_view::npos) {
      const std::optional<int> times = ReadNumber<int>(word.substr(0, star));
      if (!times || *times < 1) {
        return Refuse("'" + Shortened(word) + "' is not a number; " + std::string(what) +
                      " is expected here");
      }
      repeats = std::min(static_cast<size_t>(*times), count - numbers.size());
      word.remove_prefix(star + 1);
    }
    std::optional<double> number;
    if (!word.empty()) {
      number = FortranNumber(word);
      if (!number) {
        return Refuse("'" + Shortened(word) + "' is not a number; " + std::string(what) +
                      " is expected here");
      }
    }
    numbers.insert(numbers.end(), repeats, number);
  }
  SkipLine();
  numbers.resize(count);
  return numbers;
}

Result<double> ListText::Number(std::string_view what) {
  Result<std::vector<std::optional<double>>> record = Numbers(1, what);
  if (!record.ok()) return Error{record.error()};
  if (!record->front()) return Refuse(std::string(what) + " is missing");
  return *record->front();
}

Result<int> ListText::Count(std::string_view what, int least, int most) {
  const Result<double> number = Number(what);
  if (!number.ok()) return Error{number.error()};
  if (!(*number >= least && *number <= most && *number == std::floor(*number))) {
    return Refuse(std::string(what) + " must be a whole number from " + std::to_string(least) +
                  " to " + std::to_string(most) + ", not " + ShortestText(*number));
  }
  return static_cast<int>(*number);
}

Result<std::vector<double>> ListText::Items(size_t count, std::string_view what) {
  std::vector<double> numbers;
  while (numbers.size() < count) {
    const Item item = Next();
    if (item.is_missing) {
      return Refuse("the file ends, but " + std::string(what) + " is expected here");
    }
    const std::optional<double> number = item.is_end ? std::nullopt : FortranNumber(item.word);
    if (!number) {
      return Refuse("'" + (item.is_end ? "/" : Shortened(item.word)) + "' is not a number; " +
                    std::string(what) + " is expected here");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

Result<std::string> ListText::Text(std::string_view what) {
  SkipBlanks();
  item_line_ = line_;
  if (at_ >= text_.size()) {
    return Refuse("the file ends, but " + std::string(what) + " is expected here");
  }
  const char quote = text_[at_];
  if (quote != '\'' && quote != '"') {
    const Item item = Next();
    SkipLine();
    return std::string(item.word);
  }
  const size_t end = text_.find(quote, at_ + 1);
  const size_t line_end = std::min(text_.find('\n', at_), text_.size());
  if (end == std::string_view::npos || end > line_end) {
    return Refuse(std::string(what) + ": the quote is not closed on its line");
  }
  std::string content(text_.substr(at_ + 1, end - at_ - 1));
  at_ = end + 1;
  SkipLine();
  return content;
}

bool ListText::IsAtEnd() const { return std::ranges::all_of(text_.substr(at_), IsSpace); }

}  // namespace shoal
