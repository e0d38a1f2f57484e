// A recording to be played: its begin and end, its vehicles, and its events from any time on. Times
// are those of the log's line (lib/bus/record/log_times.h): they never go back, and a jump of the
// log's clock does not change them.
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
  /// Opens a log, or the folder of a recording. It is an error if the log has no event that can be
  /// played, or its first time is impossible.
  [[nodiscard]] static Result<PlaybackLog> Open(const std::string& path);

  const std::string& path() const { return reader_.path(); }
  int64_t first_utime() const { return times_.zero_utime; }
  int64_t last_utime() const { return times_.zero_utime + times_.end_us; }
  const LogTimes& times() const { return times_; }
  /// The names V of the channels NAV_<V> in the log's begin, in lower case, in order of appearance.
  const std::vector<std::string>& vehicles() const { return vehicles_; }
  /// The COMMS_RULES in force at the present place, which a viewer needs; before the log's first
  /// ones, the first ones; empty: the log has none.
  const Bytes& rules() const { return rules_; }
  /// The messages from before the place of SeekTo that still hold there, in the order in which they
  /// were published: rules, and what vehicles publish on change or once per second.
  const std::vector<HoldingMessage>& holding() const { return holding_; }

  /// Continues with the first event that is not before `utime`.
  void SeekTo(int64_t utime);
  /// Returns the next event; skips and counts what is damaged.
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
