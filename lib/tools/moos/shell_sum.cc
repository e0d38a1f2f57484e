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
      if (sign != '*' && next == 0) return 0;
      if (sign == '/') product /= next;
      if (sign == '%') product %= next;
    }
  }

  void Skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  static long long Bounded(long long value) {
    return std::clamp(value, -1'000'000'000LL, 1'000'000'000LL);
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
    if (const auto number = NumberIn(word)) {
      return Bounded(static_cast<long long>(std::clamp(*number, -1e9, 1e9)));
    }
    return Bounded(
        static_cast<long long>(std::clamp(NumberIn(value_of_(word)).value_or(0), -1e9, 1e9)));
  }

 private:
  std::string_view text_;
  const ShellValue& value_of_;
  size_t at_ = 0;
};

}  // namespace

long long ShellSum(std::string_view text, const ShellValue& value_of) {
  return Sum(text, value_of).AddAt(0);
}

}  // namespace shoal
