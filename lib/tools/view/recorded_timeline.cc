#include "lib/tools/view/recorded_timeline.h"

#include "lib/tools/view/fate_facts.h"

namespace shoal {

RecordedTimeline::RecordedTimeline(int64_t start_utime)
    : start_utime_(PlausibleUtime(start_utime)) {}

void RecordedTimeline::Advance(int64_t utime) {
  const int64_t line_us = PlausibleUtime(utime) - start_utime_ + shift_us_;
  const int64_t step_us = line_us - now_us_;
  const bool is_near = is_begun_ ? step_us >= -kBack_us && step_us <= kAhead_us
                                 : step_us >= -kFarAhead_us && step_us <= kFarAhead_us;
  if (!is_near) return DoubtTime(line_us);
  num_witnesses_ = 0;
  if (step_us > 0 || !is_begun_) now_us_ = line_us;
  is_begun_ = true;
}

void RecordedTimeline::DoubtTime(int64_t line_us) {
  ++num_odd_;
  const int64_t step_us = line_us - witness_us_;
  const bool agrees = num_witnesses_ > 0 && step_us >= -kBack_us && step_us <= kAhead_us;
  num_witnesses_ = agrees ? num_witnesses_ + 1 : 1;
  witness_us_ = line_us;
  if (num_witnesses_ < kWitnesses) return;
  num_witnesses_ = 0;
  if (is_begun_ && line_us > now_us_ && line_us - now_us_ <= kFarAhead_us) {
    now_us_ = line_us;  // nothing was recorded for a while
    return;
  }
  // The next times are counted from here; shifts stay within what times themselves can be.
  shift_us_ = PlausibleUtime(shift_us_ + now_us_ - line_us);
  is_begun_ = true;
  ++num_shifts_;
}

}  // namespace shoal
