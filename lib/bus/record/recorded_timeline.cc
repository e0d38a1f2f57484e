#include "lib/bus/record/recorded_timeline.h"

#include <limits>
#include <type_traits>

#include "lib/base/time/time_units.h"

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

void RecordedTimeline::AppendTo(std::vector<uint8_t>* bytes) const {
  for (const int64_t number : {start_utime_, shift_us_, now_us_, witness_us_, num_odd_, num_shifts_,
                               int64_t{num_witnesses_}, int64_t{is_begun_}}) {
    AppendLittleEndian(number, bytes);
  }
}

bool RecordedTimeline::TakeFrom(LittleEndianReader* reader) {
  constexpr int64_t kFarthestOnLine_us = 4 * kFarthest_us;
  const auto take = [&](int64_t least, int64_t most, auto* number) {
    int64_t taken = 0;
    if (!reader->Take(&taken) || taken < least || taken > most) return false;
    *number = static_cast<std::remove_pointer_t<decltype(number)>>(taken);
    return true;
  };
  constexpr int64_t kMost = std::numeric_limits<int64_t>::max() / 2;
  return take(-kFarthest_us, kFarthest_us, &start_utime_) &&
         take(-kFarthest_us, kFarthest_us, &shift_us_) &&
         take(-kFarthestOnLine_us, kFarthestOnLine_us, &now_us_) &&
         take(-kFarthestOnLine_us, kFarthestOnLine_us, &witness_us_) && take(0, kMost, &num_odd_) &&
         take(0, kMost, &num_shifts_) && take(0, kWitnesses, &num_witnesses_) &&
         take(0, 1, &is_begun_);
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
