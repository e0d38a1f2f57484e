#include "lib/tools/moos/shell_sum.h"

#include <algorithm>
#include <cstddef>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

class Sum {
 public:
  Sum(std::string_view text, const ShellValue& value_of) : text_(text), value_of_(value_of) {}

  long long AddAt(int depth) {
    long long sum = MultiplyAt(depth);
    while (true) {
      Skip();
      if (at_ >= text_.size() || (text_[at_] != '+' && text_[at_] != '-')) return sum;
      const bool is_minus = text_[at_++] == '-';
      const long long next = MultiplyAt(depth);
      sum = Bounded(is_minus ? sum - next : sum + next);
    }
  }

  long long MultiplyAt(int depth) {
    long long product = OneAt(depth);
    while (true) {
      Skip();
      if (at_ >= text_.size() || (text_[at_] != '*' && text_[at_] != '/' && text_[at_] != '%')) {
        return product;
      }
      const char sign = text_[at_++];
      const long long next = OneAt(depth);
      if (sign == '*') product = Bounded(product * next);
      if (sign != '*' && next == 0) {
        is_exact_ = false;
        return 0;
      }
      if (sign == '/') product /= next;
      if (sign == '%') product %= next;
    }
  }

  void Skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  long long Bounded(long long value) {
    const long long bounded = std::clamp(value, -kMost, kMost);
    is_exact_ = is_exact_ && bounded == value;
    return bounded;
  }
  /// A number as it is written.
  long long Whole(double value) {
    constexpr double kMostWritten = 2.0 * kMost;
    return Bounded(static_cast<long long>(std::clamp(value, -kMostWritten, kMostWritten)));
  }

  long long OneAt(int depth) {
    constexpr int kDeepestSum = 20;
    Skip();
    if (at_ >= text_.size() || depth > kDeepestSum) return 0;
    if (text_[at_] == '-') return ++at_, -OneAt(depth + 1);
    if (text_[at_] == '(') {
      ++at_;
      const long long value = AddAt(depth + 1);
      Skip();
      if (at_ < text_.size() && text_[at_] == ')') ++at_;
      return value;
    }
    const size_t begin = at_;
    while (at_ < text_.size() && IsNameCharacter(text_[at_])) ++at_;
    if (at_ == begin) return ++at_, 0;
    const std::string_view word = text_.substr(begin, at_ - begin);
    if (const auto number = NumberIn(word)) return Whole(*number);
    return Whole(NumberIn(value_of_(word)).value_or(0));
  }

  [[nodiscard]] bool is_exact() const { return is_exact_; }

 private:
  static constexpr long long kMost = 1'000'000'000;

  std::string_view text_;
  const ShellValue& value_of_;
  size_t at_ = 0;
  bool is_exact_ = true;
};

}  // namespace

long long ShellSum(std::string_view text, const ShellValue& value_of, bool* is_exact) {
  Sum sum(text, value_of);
  const long long value = sum.AddAt(0);
  if (is_exact != nullptr) *is_exact = sum.is_exact();
  return value;
}

}  // namespace shoal
