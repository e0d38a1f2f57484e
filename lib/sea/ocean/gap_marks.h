// Numbers that stand for no data in maps which do not state so: a hole of 9,999 m in a bay.
//
//   GapMarks marks;
//   for (const double number : numbers) marks.Count(number);
//   std::vector<double> gaps = marks.Found();
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shoal {

class GapMarks {
 public:
  /// @pre it is not NaN
  void Count(double number) {
    for (Mark& mark : marks_) {
      if (number == mark.number) {
        ++mark.count;
      } else if (std::abs(number - mark.number) <= mark.alone_m) {
        mark.is_alone = false;
      }
    }
  }
  /// Returns the marks that were counted and that no other number is near to: between a slope and
  /// its foot a map has numbers.
  [[nodiscard]] std::vector<double> Found() const {
    std::vector<double> found;
    for (const Mark& mark : marks_) {
      if (mark.count > 0 && mark.is_alone) found.push_back(mark.number);
    }
    return found;
  }

 private:
  struct Mark {
    double number = 0;
    double alone_m = 0;  ///< How far around it there must be no other number.
    size_t count = 0;
    bool is_alone = true;
  };
  /// Marks of common programs. Larger ones are no elevations, and refused as such.
  std::array<Mark, 4> marks_ = {{{.number = -9999, .alone_m = 1000},
                                 {.number = 9999, .alone_m = 1000},
                                 {.number = -999, .alone_m = 700},
                                 {.number = 999, .alone_m = 700}}};
};

}  // namespace shoal
