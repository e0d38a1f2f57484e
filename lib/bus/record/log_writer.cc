#include "lib/bus/record/log_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "lib/bus/os/cannot_write.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/record/log_format.h"

namespace shoal {

namespace {

uint8_t* PutBigEndian(uint64_t value, int num_bytes, uint8_t* out) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
    *out++ = static_cast<uint8_t>(value >> shift);
  }
  return out;
}

}  // namespace

LogWriter::LogWriter(std::string path, FileDescriptor file, bool is_compressed)
    : path_(std::move(path)) {
  if (is_compressed) {
    frames_ = std::make_unique<FrameWriter>(std::move(file));
    pending_.reserve(kLogFrame_bytes);
  } else {
    file_ = std::move(file);
  }
}

Result<LogWriter> LogWriter::Create(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  if (!file.is_open()) return CannotWrite(path, errno);
  return LogWriter(path, std::move(file), path.ends_with(kCompressedSuffix));
}

LogWriter::LogWriter(LogWriter&& other) noexcept = default;

LogWriter::~LogWriter() {
  if (!is_open_) return;
  if (frames_) {
    CutFrame();
  } else if (file_.is_open()) {  // It is closed if this writer was moved from.
    (void)Flush();
  }
}

void LogWriter::Append(int64_t utime, std::string_view channel, std::span<const uint8_t> data) {
  if (Take(next_number_, utime, channel, data)) ++next_number_;
}

void LogWriter::AppendAs(const LogEvent& event) {
  (void)Take(event.number, event.utime, event.channel, event.data);
}

/// Returns false where the event was dropped.
bool LogWriter::Take(int64_t number, int64_t utime, std::string_view channel,
                     std::span<const uint8_t> data) {
  SHOAL_CHECK(is_open_, "an event for a log that is closed");
  if (error_ || channel.empty() || channel.size() > kMaxLogChannelLength ||
      data.size() > kMaxLogDataLength) {
    ++counters_.dropped;
    return false;
  }
  if (frames_) {
    const size_t size = pending_.size() + kLogHeaderSize + channel.size() + data.size();
    const bool is_old =
        pending_.size() >= kLeastLogFrame_bytes && utime - frame_utime_ >= kLogFrame_us;
    if (!pending_.empty() && (size > kLogFrame_bytes || is_old)) CutFrame();
    if (pending_.empty()) frame_utime_ = utime;
  }
  std::array<uint8_t, kLogHeaderSize + kMaxLogChannelLength> head;
  uint8_t* out = PutBigEndian(kLogMagic, 4, head.data());
  out = PutBigEndian(static_cast<uint64_t>(number), 8, out);
  out = PutBigEndian(static_cast<uint64_t>(utime), 8, out);
  out = PutBigEndian(channel.size(), 4, out);
  out = PutBigEndian(data.size(), 4, out);
  out = std::copy(channel.begin(), channel.end(), out);
  pending_.insert(pending_.end(), head.data(), out);
  pending_.insert(pending_.end(), data.begin(), data.end());
  ++pending_events_;
  ++counters_.events;
  counters_.bytes += static_cast<int64_t>(kLogHeaderSize + channel.size() + data.size());
  return true;
}

void LogWriter::CutFrame() {
  if (pending_.empty()) return;
  frames_->Add(&pending_, std::exchange(pending_events_, 0));
}

std::optional<Error> LogWriter::Flush() {
  SHOAL_CHECK(is_open_, "Flush() of a log that is closed");
  if (error_) return error_;
  if (!frames_) return FlushPlain();
  if (const int error_number = frames_->error_number(); error_number != 0) {
    return Fail(error_number);
  }
  return std::nullopt;
}

std::optional<Error> LogWriter::FlushPlain() {
  if (!WriteAll(file_.get(), {reinterpret_cast<const char*>(pending_.data()), pending_.size()})) {
    return Fail(errno);
  }
  flushed_bytes_ += static_cast<int64_t>(pending_.size());
  pending_.clear();
  pending_events_ = 0;
  return std::nullopt;
}

std::optional<Error> LogWriter::Close() {
  std::optional<Error> error = Flush();
  is_open_ = false;
  if (error) return error;
  if (frames_) {
    CutFrame();
    if (!frames_->Close()) return Fail(frames_->error_number());
    return std::nullopt;
  }
  if (!file_.Close()) return Fail(errno);
  return std::nullopt;
}

Error LogWriter::Fail(int error_number) {
  // The file keeps whole events. If the cut fails (as on a device), readers find the torn event.
  if (file_.is_open()) (void)!::ftruncate(file_.get(), flushed_bytes_);
  // Frames that wait are dropped too. They are counted after that.
  if (frames_) (void)frames_->Close();
  FrameWriter::Dropped dropped = frames_ ? frames_->dropped() : FrameWriter::Dropped();
  dropped.events += pending_events_;
  dropped.bytes += static_cast<int64_t>(pending_.size());
  counters_.dropped += dropped.events;
  counters_.events -= dropped.events;
  counters_.bytes -= dropped.bytes;
  pending_.clear();
  pending_events_ = 0;
  error_ = CannotWrite(path_, error_number);
  return *error_;
}

}  // namespace shoal
