// A recording to be played: where it begins and ends, which vehicles it has, and its events from
// any time on.
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

namespace shoal {

class PlaybackLog {
 public:
  /// Opens a log, or the folder of a recording. A log without an event that can be played is an
  /// error.
  [[nodiscard]] static Result<PlaybackLog> Open(const std::string& path);

  const std::string& path() const { return reader_.path(); }
  int64_t first_utime() const { return first_utime_; }
  int64_t last_utime() const { return last_utime_; }
  /// As the channels NAV_<V> of the log's begin have them, in lower case, in their order.
  const std::vector<std::string>& vehicles() const { return vehicles_; }
  /// The first COMMS_RULES, which a viewer needs wherever the playing begins; empty: there is none.
  const Bytes& rules() const { return rules_; }

  /// Continues with the first event that is not before `utime`. Times must not fall in the log: of
  /// one where they do, some events may be skipped.
  void SeekTo(int64_t utime);
  /// Returns the next event; what is damaged is skipped, and counted.
  std::optional<LogEvent> Next() { return reader_.Next(); }
  int64_t num_damages() const { return reader_.num_damages(); }

 private:
  explicit PlaybackLog(LogReader reader) : reader_(std::move(reader)) {}
  void LookAtBegin();
  void LookAtEnd();

  LogReader reader_;
  int64_t first_utime_ = 0;
  int64_t last_utime_ = 0;
  std::vector<std::string> vehicles_;
  Bytes rules_;
};

}  // namespace shoal
