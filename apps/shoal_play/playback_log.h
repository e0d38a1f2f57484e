// A recording to be played: where it begins and ends, which vehicles it has, and its events from
// any time on. Times are those of the log's line (lib/bus/record/log_times.h): they never fall, and
// a clock that jumps does not move them.
//
//   Result<PlaybackLog> log = PlaybackLog::Open("runs/mine");
//   log->SeekTo(log->first_utime() + 60'000'000);
//   while (const auto event = log->Next()) ...
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/record/log_reader.h"
#include "lib/bus/record/log_times.h"

namespace shoal {

/// A message that was published before a place in the log and holds there.
struct HoldingMessage {
  std::string channel;
  Bytes data;
};

class PlaybackLog {
 public:
  /// Opens a log, or the folder of a recording. A log without an event that can be played, or with
  /// times that none can have, is an error.
  [[nodiscard]] static Result<PlaybackLog> Open(const std::string& path);

  const std::string& path() const { return reader_.path(); }
  int64_t first_utime() const { return times_.zero_utime; }
  int64_t last_utime() const { return times_.zero_utime + times_.end_us; }
  const LogTimes& times() const { return times_; }
  /// As the channels NAV_<V> of the log's begin have them, in lower case, in their order.
  const std::vector<std::string>& vehicles() const { return vehicles_; }
  /// The COMMS_RULES in force where it is, which a viewer needs; before the first ones, these;
  /// empty: there are none.
  const Bytes& rules() const { return rules_; }
  /// What was published before the place that SeekTo went to and holds there, in the order in which
  /// it was published: rules, and what vehicles publish on change or once per second.
  const std::vector<HoldingMessage>& holding() const { return holding_; }

  /// Continues with the first event that is not before `utime`.
  void SeekTo(int64_t utime);
  /// Returns the next event; what is damaged is skipped, and counted.
  std::optional<LogEvent> Next();
  int64_t num_damages() const { return reader_.num_damages(); }

 private:
  PlaybackLog(LogReader reader, LogTimes times);
  void LookAtBegin();
  std::optional<HoldingMessage> MessageAt(uint64_t offset) const;

  LogReader reader_;
  LogTimes times_;
  RecordedTimeline line_;
  std::vector<std::string> vehicles_;
  Bytes rules_;
  std::vector<HoldingMessage> holding_;
};

}  // namespace shoal
