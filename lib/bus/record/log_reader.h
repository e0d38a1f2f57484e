// Reads an LCM event log of any length, event by event, even if it is damaged; a compressed one
// (frame_table.h) as if it were not.
//
//   Result<LogReader> reader = LogReader::Open("mission.lcm");
//   while (const auto event = reader->Next()) Use(*event);
//   if (!reader->error().empty()) return Fail(reader->error());
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/record/file_window.h"
#include "lib/bus/record/log_format.h"

namespace shoal {

enum class OnDamage {
  kStop,  ///< The first damage ends the reading; error() states where and what.
  kSkip,  ///< Reads all whole events, before and behind the damages, which damages() lists.
};

/// A part of a log that is not an event.
struct LogDamage {
  uint64_t begin = 0;  ///< Bytes of the log, [begin, end).
  uint64_t end = 0;
  std::string what;
};

/// Returns the log in the folder of a recording, `path`/mission.lcm or `path`/mission.lcm.zst;
/// where there is none, `path`.
[[nodiscard]] std::string LogFileOf(const std::string& path);

class LogReader {
 public:
  /// Opens a log, or that of LogFileOf. An empty file is a log without events.
  static Result<LogReader> Open(const std::string& path, OnDamage on_damage = OnDamage::kStop);

  /// Returns another reader of the same open file, at its begin, even if the path names another
  /// file by now. It reads `buffer_size` bytes at a time. Each reader may have a thread of its own.
  LogReader Another(size_t buffer_size = FileWindow::kBufferSize) const {
    return {path_, file_.Another(buffer_size), on_damage_};
  }

  /// Continues at `offset`. @pre an event begins there
  void Seek(uint64_t offset) { position_ = offset; }

  /// Returns the next event, or nothing at the end of what can be read.
  std::optional<LogEvent> Next();

  /// Why Next() ended before the end of the file, with the byte; empty: it did not.
  const std::string& error() const { return error_; }

  /// What was skipped so far, the first 1000 of num_damages().
  const std::vector<LogDamage>& damages() const { return damages_; }
  int64_t num_damages() const { return num_damages_; }

  uint64_t size() const { return file_.size(); }
  /// The stamp of the file as it was opened, and whether the file was changed since.
  const FileStamp& Stamp() const { return file_.Stamp(); }
  bool HasChanged() const { return file_.HasChanged(); }
  const std::string& path() const { return path_; }

 private:
  struct Header;

  LogReader(std::string path, FileWindow file, OnDamage on_damage)
      : path_(std::move(path)), file_(std::move(file)), on_damage_(on_damage) {}

  Header ReadHeader(uint64_t offset);
  bool EventMayBeginAt(uint64_t offset);
  bool IsEventAt(uint64_t offset);
  std::optional<uint64_t> FindEvent(uint64_t begin, uint64_t end, bool must_be_followed);
  void Skip(uint64_t end, std::string what);
  void NoteLostEnd();

  std::string path_;
  FileWindow file_;
  OnDamage on_damage_;
  uint64_t position_ = 0;
  std::string error_;
  std::vector<LogDamage> damages_;
  int64_t num_damages_ = 0;
  std::optional<std::pair<int64_t, int64_t>> last_event_;  ///< Number and time.
  bool has_noted_end_ = false;
};

}  // namespace shoal
