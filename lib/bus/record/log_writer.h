// Writes an LCM event log.
//
//   Result<LogWriter> writer = LogWriter::Create("mission.lcm");
//   writer->Append(utime, "NAV_ALPHA", bytes);
//   if (auto error = writer->Flush()) return Fail(*error);   // once per step
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

struct LogWriterCounters {
  int64_t events = 0;   ///< Appended, and not dropped.
  int64_t bytes = 0;    ///< Of these events, as they stand in the file.
  int64_t dropped = 0;  ///< After an error, or with a name or data that the format cannot hold.
};

class LogWriter {
 public:
  /// Makes the file, or empties it. The error names the path and what to try.
  static Result<LogWriter> Create(const std::string& path);

  LogWriter(LogWriter&&) = default;
  /// Flushes; call Close() before to get its errors.
  ~LogWriter();

  /// Takes one event, numbered from 0, into memory.
  void Append(int64_t utime, std::string_view channel, std::span<const uint8_t> data);

  /// Writes what was appended, whole events in one write(2), so that a process that is
  /// killed between two calls leaves a whole log. Where the file cannot take all, it is cut back to
  /// the events of the calls before; from then on everything is dropped and each call returns the
  /// same error, which names the path and what to try.
  [[nodiscard]] std::optional<Error> Flush();

  /// Flushes and closes; the last call.
  [[nodiscard]] std::optional<Error> Close();

  const LogWriterCounters& counters() const { return counters_; }
  const std::string& path() const { return path_; }

 private:
  LogWriter(std::string path, FileDescriptor file);
  Error Fail(int error_number);

  std::string path_;
  FileDescriptor file_;
  std::vector<uint8_t> pending_;
  int64_t pending_events_ = 0;
  int64_t next_number_ = 0;
  int64_t flushed_bytes_ = 0;
  LogWriterCounters counters_;
  std::optional<Error> error_;
};

}  // namespace shoal
