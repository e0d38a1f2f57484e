// Points of a track at round times, as few as a figure has room for.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/tools/plot/plot_curve.h"

namespace shoal {

/// Where a vehicle was at a whole multiple of the interval between marks.
struct TimeMark {
  int64_t time_s = 0;
  CurvePoint at;
};

/// Marks a track at multiples of a step that grows, from a second to a day, with its length.
class TimeMarks {
 public:
  static constexpr size_t kMaxMarks = 15;

  /// Takes the next point of the track. The first point at or after a multiple of the step, by at
  /// most one second, becomes a mark. The start of the track is not a mark.
  void Add(double time_s, CurvePoint at);

  /// Returns the present time between two marks.
  int64_t step_s() const { return step_s_; }

  /// Returns the marks at multiples of `step_s`. @pre a multiple of step_s()
  std::vector<TimeMark> MultiplesOf(int64_t step_s) const;

 private:
  int64_t step_s_ = 1;
  std::vector<TimeMark> marks_;
};

}  // namespace shoal
