#include "apps/shoal_play/playback_log.h"

#include <algorithm>

#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

namespace {

/// A mission's log has all of its channels in the first steps.
constexpr int64_t kMaxEventsAtBegin = 20'000;
constexpr uint64_t kMaxBytesAtBegin = 16 << 20;
/// No log of missions has an event that is larger.
constexpr uint64_t kBytesAtEnd = 4 << 20;
constexpr uint64_t kShortSearch_bytes = 256 << 10;

}  // namespace

Result<PlaybackLog> PlaybackLog::Open(const std::string& path) {
  Result<LogReader> reader = LogReader::Open(path, OnDamage::kSkip);
  if (!reader.ok()) return Error{reader.error()};
  PlaybackLog log(std::move(*reader));
  const auto first = log.reader_.Another().Next();
  if (!first) {
    return Error{path +
                 ": it holds no event that can be played; `shoal log info` shows what it is"};
  }
  log.first_utime_ = log.last_utime_ = first->utime;
  log.LookAtBegin();
  log.LookAtEnd();
  return log;
}

void PlaybackLog::LookAtBegin() {
  LogReader reader = reader_.Another();
  for (int64_t i = 0; i < kMaxEventsAtBegin; ++i) {
    const auto event = reader.Next();
    if (!event || event->offset > kMaxBytesAtBegin) break;
    last_utime_ = std::max(last_utime_, event->utime);
    if (rules_.empty() && event->channel == topics::kCommsRules) {
      rules_.assign(event->data.begin(), event->data.end());
    }
    const std::string_view vehicle = VehicleOfChannel(event->channel, topics::kNav);
    if (vehicle.empty()) continue;
    const std::string name = LowerCase(vehicle);
    if (std::ranges::find(vehicles_, name) == vehicles_.end()) vehicles_.push_back(name);
  }
}

void PlaybackLog::LookAtEnd() {
  LogReader reader = reader_.Another();
  reader.Seek(reader.size() > kBytesAtEnd ? reader.size() - kBytesAtEnd : 0);
  while (const auto event = reader.Next()) last_utime_ = std::max(last_utime_, event->utime);
}

void PlaybackLog::SeekTo(int64_t utime) {
  uint64_t low = 0;
  uint64_t high = reader_.size();
  LogReader probe = reader_.Another();
  while (high - low > kShortSearch_bytes) {
    const uint64_t middle = low + (high - low) / 2;
    probe.Seek(middle);
    const auto event = probe.Next();
    if (!event || event->offset >= high || event->utime >= utime) {
      high = middle;
    } else {
      low = event->offset;
    }
  }
  reader_.Seek(low);
  uint64_t offset = low;
  while (const auto event = reader_.Next()) {
    offset = event->offset;
    if (event->utime >= utime) break;
    offset = reader_.size();
  }
  reader_.Seek(offset);
}

}  // namespace shoal
