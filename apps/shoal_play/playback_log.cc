#include "apps/shoal_play/playback_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "lib/base/text/letters.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/run/run/reading_bar.h"

namespace shoal {

namespace {

/// A mission's log has all of its channels in the first steps.
constexpr int64_t kMaxEventsAtBegin = 20'000;
constexpr uint64_t kMaxBytesAtBegin = 16 << 20;
/// Vehicles publish messages of kHoldingTopics at least this often: older ones do not hold.
constexpr int64_t kHolds_us = 2'000'000;

/// Topics of vehicles that publish on change, or once per second.
constexpr std::array kHoldingTopics = {topics::kHelmState, topics::kGuidance, topics::kHelmDecision,
                                       topics::kSwarm, topics::kNavigation};

bool Holds(std::string_view channel) {
  return std::ranges::find(kHoldingChannels, channel) != kHoldingChannels.end() ||
         std::ranges::any_of(kHoldingTopics, [&](std::string_view topic) {
           return !VehicleOfChannel(channel, topic).empty();
         });
}

Bytes MessageOf(const LogEvent& event) {
  const std::span<const uint8_t> message = Unseal(event.data).message;
  return {message.begin(), message.end()};
}

}  // namespace

PlaybackLog::PlaybackLog(LogReader reader, LogTimes times)
    : reader_(std::move(reader)), times_(std::move(times)), line_(times_.places.front().line) {}

Result<PlaybackLog> PlaybackLog::Open(const std::string& path) {
  Result<LogReader> reader = LogReader::Open(path, OnDamage::kSkip);
  if (!reader.ok()) return Error{reader.error()};
  ReadingBar bar(reader->path());
  LogTimes times = TimesOf(*reader, [&](double share) { bar.Show(share); });
  if (times.num_events == 0) {
    return Error{path +
                 ": it holds no event that can be played; `shoal log info` shows what it is"};
  }
  if (std::abs(times.zero_utime) >= kFarthest_us) {
    return Error{fmt::format(
        "{}: its first event has a time that is farther than {} microseconds from 0, 3,170 years: "
        "`shoal log info` shows the times of each channel, `shoal log copy --from --to` takes a "
        "part",
        path, kFarthest_us)};
  }
  PlaybackLog log(std::move(*reader), std::move(times));
  log.LookAtBegin();
  return log;
}

void PlaybackLog::LookAtBegin() {
  LogReader reader = reader_.Another();
  for (int64_t i = 0; i < kMaxEventsAtBegin; ++i) {
    const auto event = reader.Next();
    if (!event || event->offset > kMaxBytesAtBegin) break;
    if (rules_.empty() && event->channel == topics::kCommsRules) rules_ = MessageOf(*event);
    const std::string_view vehicle = VehicleOfChannel(event->channel, topics::kNav);
    if (vehicle.empty()) continue;
    const std::string name = LowerCase(vehicle);
    if (std::ranges::find(vehicles_, name) == vehicles_.end()) vehicles_.push_back(name);
  }
}

std::optional<HoldingMessage> PlaybackLog::MessageAt(uint64_t offset) const {
  LogReader reader = reader_.Another();
  reader.Seek(offset);
  const auto event = reader.Next();
  if (!event || event->offset != offset || !Holds(event->channel)) return std::nullopt;
  return HoldingMessage{.channel = std::string(event->channel), .data = MessageOf(*event)};
}

std::optional<LogEvent> PlaybackLog::Next() {
  std::optional<LogEvent> event = reader_.Next();
  if (!event) return event;
  line_.Advance(event->utime);
  event->utime = times_.zero_utime + line_.now_us();
  return event;
}

void PlaybackLog::SeekTo(int64_t utime) {
  const int64_t line_us = utime - times_.zero_utime;
  const LogPlace& place = times_.PlaceBefore(line_us - kHolds_us - 1);
  std::map<std::string, uint64_t, std::less<>> last;  ///< Where the last message begins.
  for (size_t i = 0; i < kHoldingChannels.size(); ++i) {
    if (place.holding[i] != LogPlace::kNone) last.emplace(kHoldingChannels[i], place.holding[i]);
  }
  uint64_t offset = place.offset;
  line_ = place.line;
  reader_.Seek(offset);
  while (const auto event = reader_.Next()) {
    RecordedTimeline next = line_;
    next.Advance(event->utime);
    offset = event->offset;
    if (next.now_us() >= line_us) break;
    line_ = next;
    offset = reader_.size();
    if (Holds(event->channel)) last.insert_or_assign(std::string(event->channel), event->offset);
  }
  reader_.Seek(offset);
  std::vector<uint64_t> offsets;
  offsets.reserve(last.size());
  for (const auto& [channel, begin] : last) offsets.push_back(begin);
  std::ranges::sort(offsets);
  holding_.clear();
  for (const uint64_t begin : offsets) {
    std::optional<HoldingMessage> message = MessageAt(begin);
    if (!message) continue;
    if (message->channel == topics::kCommsRules) rules_ = message->data;
    holding_.push_back(*std::move(message));
  }
}

}  // namespace shoal
