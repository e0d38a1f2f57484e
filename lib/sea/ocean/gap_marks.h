// Numbers that stand for no data in maps which do not state so: a hole of 9,999 m in a bay.
//
//   GapMarks marks;
//   for (const double number : numbers) marks.Count(number);
//   std::vector<float> gaps = marks.Found();
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shoal {

class GapMarks {
 public:
  /// Marks of numbers that are multiplied by `scale` when they are read, and then have `offset`
  /// added; what is read has the precision of a float. @pre finite
  explicit GapMarks(double scale = 1, double offset = 0) {
    for (Mark& mark : marks_) {
      mark.number = static_cast<float>(mark.number * scale + offset);
      mark.alone *= std::abs(scale);
    }
  }

  /// @pre it is not NaN
  void Count(double number) {
    for (Mark& mark : marks_) {
      if (static_cast<float>(number) == mark.number) {
        ++mark.count;
      } else if (std::abs(number - mark.number) <= mark.alone) {
        mark.is_alone = false;
      }
    }
  }
  /// Returns the marks that were counted and that no other number is near to: on the way down to a
  /// real depth a map has some.
  [[nodiscard]] std::vector<float> Found() const {
    std::vector<float> found;
    for (const Mark& mark : marks_) {
      if (mark.count > 0 && mark.is_alone) found.push_back(mark.number);
    }
    return found;
  }

 private:
  struct Mark {
    float number = 0;
    double alone = 0;  ///< How far around it there must be no other number.
    size_t count = 0;
    bool is_alone = true;
  };
  /// Marks of common programs. Larger ones are neither depths nor currents, and refused as such,
  /// but as packed integers they may be.
  std::array<Mark, 6> marks_ = {{{.number = -9999, .alone = 1000},
                                 {.number = 9999, .alone = 1000},
                                 {.number = -999, .alone = 700},
                                 {.number = 999, .alone = 700},
                                 {.number = 32767, .alone = 1000},
                                 {.number = -32768, .alone = 1000}}};
};

}  // namespace shoal
