// Makes a monotonic timeline of the times in a log.
//
//   RecordedTimeline line(start_utime);
//   while (const auto event = reader.Next()) line.Advance(event->utime);
//   line.now_us();    // since the mission's start
//
// A time that is earlier by more than a second, or later by more than an hour, is accepted only
// when kWitnesses in a row agree; until then, and where they do not, nothing moves. A clock that
// went back, or ahead by more than a day, continues on the timeline where it was.
#pragma once

#include <cstdint>
#include <vector>

#include "lib/base/codec/little_endian.h"

namespace shoal {

class RecordedTimeline {
 public:
  static constexpr int64_t kBack_us = 1'000'000;
  static constexpr int64_t kAhead_us = 3'600'000'000;
  static constexpr int64_t kFarAhead_us = 24 * kAhead_us;
  static constexpr int kWitnesses = 16;

  /// `start_utime` is 0 on the line.
  explicit RecordedTimeline(int64_t start_utime);

  /// Takes the time of the next event, any number.
  void Advance(int64_t utime);

  bool is_begun() const { return is_begun_; }
  /// The time of the last event; 0 before the first.
  int64_t now_us() const { return now_us_; }
  /// Returns the time of the log's clock at `line_us`, by the current shift.
  int64_t UtimeOf(int64_t line_us) const { return line_us + start_utime_ - shift_us_; }

  int64_t num_odd() const { return num_odd_; }        ///< Times that did not move the line.
  int64_t num_shifts() const { return num_shifts_; }  ///< Clocks that went on from elsewhere.

  /// Appends all of it, for an index that is kept (lib/bus/record/index_file.h).
  void AppendTo(std::vector<uint8_t>* bytes) const;
  /// Becomes what AppendTo has appended. Returns false for bytes that no line can have made.
  [[nodiscard]] bool TakeFrom(LittleEndianReader* reader);

 private:
  void DoubtTime(int64_t line_us);

  int64_t start_utime_;
  int64_t shift_us_ = 0;  ///< Added to the log's times.
  int64_t now_us_ = 0;
  bool is_begun_ = false;
  int num_witnesses_ = 0;
  int64_t witness_us_ = 0;  ///< The time of the last of them.
  int64_t num_odd_ = 0;
  int64_t num_shifts_ = 0;
};

}  // namespace shoal
