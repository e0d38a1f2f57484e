#include "apps/viewer/recorded_channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/time/seconds.h"
#include "lib/base/time/time_units.h"
#include "lib/bus/record/recorded_timeline.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

/// A rate is that of the last seconds.
constexpr double kRateWindow_s = 10;
/// Messages that are read one by one are mostly smaller than this.
constexpr size_t kBuffer_bytes = 4096;

}  // namespace

void RecordedChannels::Index() {
  if (is_indexed_) return;
  is_indexed_ = true;
  Result<RecordedLog> log = OpenRecordedLog(path_, mission_file_, {});
  if (!log.ok()) return;
  reader_ = log->reader.Another();
  RecordedTimeline line(PlausibleUtime(log->mission.start_utime));
  LogReader reader = reader_->Another();
  while (const auto event = reader.Next()) {
    if (const auto utime = MissionUtimeOf(*event, log->survey.stamps)) line.Advance(*utime);
    auto channel = channels_.find(event->channel);
    if (channel == channels_.end()) {
      if (channels_.size() == kMaxChannels) continue;
      channel = channels_.emplace(std::string(event->channel), Places{}).first;
    }
    Places& places = channel->second;
    if (places.num++ % stride_ != 0) continue;
    places.places.push_back({.line_us = line.now_us(), .offset = event->offset});
    if (++num_places_ > max_places_) Thin();
  }
}

void RecordedChannels::Thin() {
  num_places_ = 0;
  for (auto& [name, channel] : channels_) {
    size_t kept = 0;
    for (size_t i = 0; i < channel.places.size(); i += 2) {
      channel.places[kept++] = channel.places[i];
    }
    channel.places.resize(kept);
    num_places_ += kept;
  }
  stride_ *= 2;
}

size_t RecordedChannels::CountUntil(const Places& channel, double t_s) {
  const auto behind =
      std::partition_point(channel.places.begin(), channel.places.end(),
                           [&](const Place& place) { return Seconds(place.line_us) <= t_s; });
  return static_cast<size_t>(behind - channel.places.begin());
}

std::optional<ShownMessage> RecordedChannels::Read(const std::string& channel, const Place& place) {
  LogReader reader = reader_->Another(kBuffer_bytes);
  reader.Seek(place.offset);
  const auto event = reader.Next();
  if (!event || event->channel != channel) return std::nullopt;  // The file has changed.
  return ShownMessage{.channel = channel,
                      .t_s = Seconds(place.line_us),
                      .data = {event->data.begin(), event->data.end()}};
}

Result<const RecordedChannels::Places*> RecordedChannels::Find(const std::string& channel) {
  Index();
  const auto found = channels_.find(channel);
  if (found != channels_.end()) return &found->second;
  std::vector<std::string_view> names;
  for (const auto& [name, places] : channels_) names.push_back(name);
  return Error{
      fmt::format("the log has no channel {}{}", Quoted(channel), DidYouMean(channel, names))};
}

std::string RecordedChannels::ChannelsJson(double t_s) {
  const std::lock_guard lock(mutex_);
  Index();
  std::vector<ChannelFacts> facts;
  std::vector<std::string> types;
  for (const auto& [name, channel] : channels_) {
    const size_t until = CountUntil(channel, t_s);
    if (until == 0) continue;
    const double last_s = Seconds(channel.places[until - 1].line_us);
    const double now_s = std::min(t_s, last_s + kRateWindow_s);
    const size_t before = CountUntil(channel, now_s - kRateWindow_s);
    const auto recent = static_cast<double>(until - before) * static_cast<double>(stride_);
    facts.push_back({.name = name,
                     .count = std::min(static_cast<int64_t>(until) * stride_, channel.num),
                     .rate_hz = recent / std::clamp(now_s, 1.0, kRateWindow_s),
                     .last_s = last_s});
    const auto message = Read(name, channel.places[until - 1]);
    types.push_back(message ? TypeNameOf(message->data) : "");
  }
  return ChannelListJson(facts, types);
}

Result<std::string> RecordedChannels::MessageJson(const std::string& channel, double t_s) {
  const std::lock_guard lock(mutex_);
  const Result<const Places*> places = Find(channel);
  if (!places.ok()) return Error{places.error()};
  const size_t until = CountUntil(**places, t_s);
  const auto message = until == 0 ? std::nullopt : Read(channel, (*places)->places[until - 1]);
  if (!message) return Error{fmt::format("{} has no message yet at this time", channel)};
  return MessageJsonOf(*message);
}

std::string RecordedChannels::FieldsJson(const std::string& text, double t_s) {
  const std::lock_guard lock(mutex_);
  Index();
  FieldSearch search(text);
  for (const auto& [name, channel] : channels_) {
    const size_t until = CountUntil(channel, t_s);
    // A field may be looked for before its first message.
    const auto message = Read(name, channel.places[until == 0 ? 0 : until - 1]);
    if (message && !search.Take(name, message->data)) break;
  }
  return search.Json();
}

Result<std::string> RecordedChannels::SeriesJson(const std::string& field, double t_s,
                                                 double window_s) {
  const Result<FieldName> name = ParseFieldName(field);
  if (!name.ok()) return Error{name.error()};
  const std::lock_guard lock(mutex_);
  const Result<const Places*> places = Find(name->channel);
  if (!places.ok()) return Error{places.error()};
  const size_t end = CountUntil(**places, t_s);
  const size_t begin = std::min(CountUntil(**places, t_s - window_s), end);
  if (const auto last = Read(name->channel, (*places)->places[end == 0 ? 0 : end - 1])) {
    if (auto error = FindNoSuchField(*name, last->data)) return *std::move(error);
  }
  const size_t step = std::max<size_t>(1, (end - begin + kMaxPoints - 1) / kMaxPoints);
  std::vector<SeriesPoint> points;
  for (size_t i = begin; i < end; i += step) {
    const auto message = Read(name->channel, (*places)->places[i]);
    if (!message) continue;
    auto value = ValueAt(LeavesOf(message->data), name->path);
    if (value) points.push_back({.t_s = message->t_s, .value = std::move(*value)});
  }
  return SeriesJsonOf(field, points);
}

}  // namespace shoal
