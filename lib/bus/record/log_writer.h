// Writes an LCM event log, compressed where its name ends in ".zst" (frame_table.h).
//
//   Result<LogWriter> writer = LogWriter::Create("mission.lcm");    // or "mission.lcm.zst"
//   writer->Append(utime, "NAV_ALPHA", bytes);
//   if (auto error = writer->Flush()) return Fail(*error);   // once per step
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/record/frame_writer.h"
#include "lib/bus/record/log_format.h"

namespace shoal {

/// A log whose name ends in this is compressed.
inline constexpr std::string_view kCompressedSuffix = ".zst";

/// A compressed log is cut into frames between events. A frame ends before it would be longer than
/// kLogFrame_bytes, or when it is longer than kLeastLogFrame_bytes and its first event is
/// kLogFrame_us old. If the process is killed, the events that are in no whole frame are lost.
inline constexpr size_t kLogFrame_bytes = size_t{2} << 20;
inline constexpr size_t kLeastLogFrame_bytes = size_t{64} << 10;
inline constexpr int64_t kLogFrame_us = 10'000'000;

struct LogWriterCounters {
  int64_t events = 0;   ///< Appended, and not dropped.
  int64_t bytes = 0;    ///< Of these events in the log, before they are compressed.
  int64_t dropped = 0;  ///< After an error, or with a name or data that the format cannot hold.
};

class LogWriter {
 public:
  /// Makes the file, or empties it. The error names the path and what to try.
  static Result<LogWriter> Create(const std::string& path);

  LogWriter(LogWriter&& other) noexcept;
  /// Flushes; call Close() before to get its errors.
  ~LogWriter();

  /// Takes one event, numbered from 0, into memory.
  void Append(int64_t utime, std::string_view channel, std::span<const uint8_t> data);
  /// The same with the event's own number, as another log has it.
  void AppendAs(const LogEvent& event);

  /// Writes what was appended, whole events in one write(2), so that a process that is killed
  /// between two calls leaves a whole log. If the file cannot take all, it is cut back to the
  /// events of the calls before; from then on everything is dropped, and each call returns the same
  /// error, which names the path and what to try. A compressed log is different: another thread
  /// writes each frame when it is full, and this call only returns the error of that thread.
  [[nodiscard]] std::optional<Error> Flush();

  /// Flushes and closes; the last call.
  [[nodiscard]] std::optional<Error> Close();

  const LogWriterCounters& counters() const { return counters_; }
  const std::string& path() const { return path_; }

 private:
  LogWriter(std::string path, FileDescriptor file, bool is_compressed);
  std::optional<Error> FlushPlain();
  bool Take(int64_t number, int64_t utime, std::string_view channel, std::span<const uint8_t> data);
  void CutFrame();
  Error Fail(int error_number);

  std::string path_;
  FileDescriptor file_;                  ///< Of a plain log.
  std::unique_ptr<FrameWriter> frames_;  ///< Of a compressed one.
  bool is_open_ = true;
  int64_t frame_utime_ = 0;  ///< Of the first event that is pending.
  std::vector<uint8_t> pending_;
  int64_t pending_events_ = 0;
  int64_t next_number_ = 0;
  int64_t flushed_bytes_ = 0;
  LogWriterCounters counters_;
  std::optional<Error> error_;
};

}  // namespace shoal
