// Remembers the smallest and the largest that a quantity ever was, and when.
#pragma once

#include <limits>

namespace shoal {

struct Extreme {
  double value = 0;
  double time_s = 0;  ///< The first time at which it was that.
};

class ExtremeWatch {
 public:
  /// Takes note of a value. NaN is ignored.
  void Look(double value, double time_s) {
    if (value < smallest_.value) smallest_ = {value, time_s};
    if (value > largest_.value) largest_ = {value, time_s};
  }

  bool has_seen() const { return smallest_.value <= largest_.value; }
  const Extreme& smallest() const { return smallest_; }
  const Extreme& largest() const { return largest_; }

 private:
  Extreme smallest_ = {.value = std::numeric_limits<double>::infinity()};
  Extreme largest_ = {.value = -std::numeric_limits<double>::infinity()};
};

}  // namespace shoal
