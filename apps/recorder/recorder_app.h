// Writes everything that is published on a bus into an LCM event log, in the fixed order, stamped
// with mission time. In its own process (`shoal run --record`) and in `shoal sim --log`.
//
//   RecorderApp recorder({.path = "mission.lcm", .start_utime = mission.start_utime}, bus);
//   if (!recorder.error().empty()) ...                  // the file could not be made
//   ... after each Tick() and after End(): if (!recorder.error().empty()) end, exit code 3
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lib/bus/bus/bus.h"
#include "lib/bus/record/channel_choice.h"
#include "lib/bus/record/log_writer.h"
#include "lib/run/run/app.h"

namespace shoal {

struct RecorderOptions {
  std::string path;
  int64_t start_utime = 0;      ///< Mission time of the first step.
  ChannelChoice channels = {};  ///< Of what IsLogged() takes.
  bool log_all = false;         ///< Also channels that IsLogged() leaves out of a mission's log.
};

class RecorderApp : public App {
 public:
  /// Makes the log, or empties it; error() is empty if that worked.
  RecorderApp(const RecorderOptions& options, Bus& bus);

  /// Writes what was published in the step before, stamped with the time of that step.
  void Tick(int64_t utime) override;

  /// Writes the last messages and closes the log.
  void End() override;

  std::string Fault() const override { return error_; }
  StatusPage Status() const override;

  /// Why the log is not complete, with the remedy; empty: it is complete. Messages after an error
  /// are dropped and counted.
  const std::string& error() const { return error_; }

 private:
  struct ChannelCount {
    bool is_logged = true;
    int64_t events = 0;
    int64_t bytes = 0;
  };

  void Record(const Message& message);
  ChannelCount& CountOf(std::string_view channel);
  void Note(const std::optional<Error>& error);

  const RecorderOptions options_;
  std::optional<LogWriter> writer_;  ///< Absent: it could not be made, or End() closed it.
  LogWriterCounters counters_;       ///< Of the writer.
  int64_t utime_;                    ///< Of the step whose messages are being handled.
  int64_t dropped_ = 0;              ///< Without a writer.
  using Channels = std::map<std::string, ChannelCount, std::less<>>;
  Channels channels_;
  /// Of the last message. The messages of a step come in order of channels: the next one is here,
  /// or right after it.
  Channels::iterator last_;
  std::string error_;
  StatusLog log_;
};

}  // namespace shoal
