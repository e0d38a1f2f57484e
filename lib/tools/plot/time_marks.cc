#include "lib/tools/plot/time_marks.h"

#include <array>
#include <cmath>
#include <utility>

namespace shoal {

namespace {

/// Each is a multiple of the one before.
constexpr std::array<int64_t, 13> kMarkSteps_s = {1,    2,    10,   20,    60,    120,  600,
                                                  1200, 3600, 7200, 14400, 28800, 86400};
/// Larger times of a log are not times of a mission.
constexpr double kLatestMark_s = 1e12;

}  // namespace

void TimeMarks::Add(double time_s, CurvePoint at) {
  if (std::abs(time_s) > kLatestMark_s) return;
  const double steps = std::floor(time_s / static_cast<double>(step_s_) + 1e-9);
  const int64_t mark_s = static_cast<int64_t>(steps) * step_s_;
  const int64_t last_s = marks_.empty() ? 0 : marks_.back().time_s;  // The start has its own mark.
  if (mark_s <= last_s || time_s - static_cast<double>(mark_s) > 1) return;
  marks_.push_back({.time_s = mark_s, .at = at});
  for (const int64_t step_s : kMarkSteps_s) {
    if (marks_.size() <= kMaxMarks) break;
    if (step_s <= step_s_) continue;
    step_s_ = step_s;
    marks_ = MultiplesOf(step_s);
  }
  if (marks_.size() > kMaxMarks) marks_.pop_back();  // More than two weeks.
}

std::vector<TimeMark> TimeMarks::MultiplesOf(int64_t step_s) const {
  std::vector<TimeMark> kept = marks_;
  std::erase_if(kept, [&](const TimeMark& mark) { return mark.time_s % step_s != 0; });
  return kept;
}

}  // namespace shoal
