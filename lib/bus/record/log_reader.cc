#include "lib/bus/record/log_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "lib/base/time/seconds.h"

namespace shoal {

namespace {

constexpr size_t kMaxDamagesListed = 1000;
/// A longer event is accepted only if another event, or the file's end, follows it.
constexpr uint64_t kMaxUnconfirmedSize = 16 << 20;

uint64_t BigEndian(std::span<const uint8_t> bytes) {
  uint64_t value = 0;
  for (const uint8_t byte : bytes) value = value << 8 | byte;
  return value;
}

}  // namespace

/// What is before an event's channel and data.
struct LogReader::Header {
  int64_t number = 0;
  int64_t utime = 0;
  size_t channel_length = 0;
  size_t data_length = 0;
  uint64_t end = 0;        ///< Of the event.
  std::string_view wrong;  ///< Empty: a whole event of these lengths may be here.
};

std::string LogFileOf(const std::string& path) {
  std::error_code error;
  for (const char* name : {"mission.lcm", "mission.lcm.zst"}) {
    const std::filesystem::path inside = std::filesystem::path(path) / name;
    if (std::filesystem::is_regular_file(inside, error)) return inside.string();
  }
  return path;
}

Result<LogReader> LogReader::Open(const std::string& path, OnDamage on_damage) {
  const std::string log = LogFileOf(path);
  std::error_code error;
  if (std::filesystem::is_directory(log, error)) {
    return Error{"cannot read " + path +
                 ": it is a folder without a mission.lcm, as `shoal run --record` writes it"};
  }
  Result<FileWindow> file = FileWindow::Open(log);
  if (!file.ok()) return Error{file.error()};
  return LogReader(log, std::move(*file), on_damage);
}

LogReader::Header LogReader::ReadHeader(uint64_t offset) {
  Header header;
  const auto bytes = file_.At(offset, kLogHeaderSize);
  if (bytes.size() >= 4 && BigEndian(bytes.first(4)) != kLogMagic) {
    header.wrong = offset == 0 ? "not an LCM event log: it does not begin with eda1da01"
                               : "no event begins here, though one ended here";
    return header;
  }
  if (bytes.size() < kLogHeaderSize) {
    header.wrong = "the log ends inside an event";
    return header;
  }
  header.number = static_cast<int64_t>(BigEndian(bytes.subspan(4, 8)));
  header.utime = static_cast<int64_t>(BigEndian(bytes.subspan(12, 8)));
  header.channel_length = static_cast<size_t>(BigEndian(bytes.subspan(20, 4)));
  header.data_length = static_cast<size_t>(BigEndian(bytes.subspan(24, 4)));
  header.end = offset + kLogHeaderSize + header.channel_length + header.data_length;
  if (header.channel_length == 0 || header.channel_length > kMaxLogChannelLength) {
    header.wrong = "an event's channel has an impossible length";
  } else if (header.data_length <= kMaxLogDataLength && header.end > file_.size()) {
    header.wrong = "the log ends inside an event";
  } else if (header.data_length > kMaxLogDataLength ||
             (header.data_length > kMaxUnconfirmedSize && !EventMayBeginAt(header.end))) {
    header.wrong = "an event's data has an impossible length";
  }
  return header;
}

bool LogReader::EventMayBeginAt(uint64_t offset) {
  return offset == file_.size() || file_.PeekUint32(offset) == kLogMagic;
}

/// Returns whether a whole event with a printable channel is at `offset`.
bool LogReader::IsEventAt(uint64_t offset) {
  const Header header = ReadHeader(offset);
  if (!header.wrong.empty()) return false;
  const auto channel = file_.At(offset + kLogHeaderSize, header.channel_length);
  return channel.size() == header.channel_length &&
         std::all_of(channel.begin(), channel.end(), [](uint8_t c) { return c > ' ' && c < 0x7f; });
}

std::optional<uint64_t> LogReader::FindEvent(uint64_t begin, uint64_t end, bool must_be_followed) {
  while (const auto found = file_.FindUint32(kLogMagic, begin, end)) {
    if (IsEventAt(*found) && (!must_be_followed || EventMayBeginAt(ReadHeader(*found).end))) {
      return found;
    }
    begin = *found + 1;
  }
  return std::nullopt;
}

void LogReader::Skip(uint64_t end, std::string what) {
  if (damages_.size() < kMaxDamagesListed) {
    damages_.push_back({.begin = position_, .end = end, .what = std::move(what)});
  }
  ++num_damages_;
  position_ = end;
}

/// Reports that the end of a compressed log is lost: its bytes alone do not show it.
void LogReader::NoteLostEnd() {
  if (file_.lost().empty() || has_noted_end_ || !error_.empty()) return;
  has_noted_end_ = true;
  std::string what(file_.lost());
  what += last_event_ ? fmt::format(": what came after event {}, at {:.6f} s, is lost",
                                    last_event_->first, Seconds(last_event_->second))
                      : std::string(": its events are lost");
  if (on_damage_ == OnDamage::kSkip) {
    Skip(position_, what);
  } else {
    error_ = path_ + ": byte " + std::to_string(position_) + ": " + what;
  }
}

std::optional<LogEvent> LogReader::Next() {
  while (position_ < file_.size() && error_.empty()) {
    const Header header = ReadHeader(position_);
    if (!header.wrong.empty()) {
      std::string what = file_.DamageAt(position_);
      if (what.empty()) what = header.wrong;
      if (on_damage_ == OnDamage::kStop) {
        error_ = path_ + ": byte " + std::to_string(position_) + ": " + what;
        break;
      }
      Skip(FindEvent(position_ + 1, file_.size(), false).value_or(file_.size()), what);
      continue;
    }
    if (on_damage_ == OnDamage::kSkip && !EventMayBeginAt(header.end)) {
      // Either foreign bytes follow this event, or its length is wrong.
      if (const auto inner = FindEvent(position_ + 1, header.end, true)) {
        Skip(*inner, "an event's length reaches over the events behind it");
        continue;
      }
    }
    const auto bytes = file_.At(position_, static_cast<size_t>(header.end - position_));
    if (bytes.size() < header.end - position_) continue;  // the file became shorter
    LogEvent event;
    event.number = header.number;
    event.utime = header.utime;
    const auto channel = bytes.subspan(kLogHeaderSize, header.channel_length);
    event.channel = {reinterpret_cast<const char*>(channel.data()), channel.size()};
    event.data = bytes.subspan(kLogHeaderSize + header.channel_length);
    event.offset = position_;
    last_event_ = {header.number, header.utime};
    position_ = header.end;
    return event;
  }
  NoteLostEnd();
  if (error_.empty() && !file_.error().empty()) {
    error_ = path_ + ": byte " + std::to_string(position_) + ": " + file_.error();
  }
  return std::nullopt;
}

}  // namespace shoal
