#include "apps/viewer/live_channels.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

constexpr size_t kTimesKept = 32;
/// If no page has asked for a series for this long, another one may take its place.
constexpr int64_t kSeriesLasts_us = 60'000'000;

}  // namespace

bool LiveChannels::Wants() {
  const std::lock_guard lock(mutex_);
  return asked_us_ != INT64_MIN && now_us_() - asked_us_ < kLookLasts_us;
}

void LiveChannels::Take(std::string_view name, std::span<const uint8_t> data, double t_s) {
  if (data.size() > kMaxMessage_bytes) return;
  const std::lock_guard lock(mutex_);
  auto found = channels_.find(name);
  if (found == channels_.end()) {
    if (channels_.size() == kMaxChannels) return;
    found = channels_.emplace(std::string(name), Channel{}).first;
  }
  Channel& channel = found->second;
  ++channel.count;
  channel.times_s.push_back(t_s);
  if (channel.times_s.size() > kTimesKept) channel.times_s.pop_front();
  channel.last.assign(data.begin(), data.end());
  std::vector<Leaf> leaves;
  for (auto& [field, series] : series_) {
    if (series.name.channel != name) continue;
    if (leaves.empty()) leaves = LeavesOf(data);
    auto value = ValueAt(leaves, series.name.path);
    if (!value) continue;
    series.points.push_back({.t_s = t_s, .value = std::move(*value)});
    if (series.points.size() > kMaxKept) series.points.pop_front();
  }
}

std::string LiveChannels::ChannelsJson(double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  asked_us_ = now_us_();
  std::vector<ChannelFacts> facts;
  std::vector<std::string> types;
  for (const auto& [name, channel] : channels_) {
    const std::deque<double>& times = channel.times_s;
    const double span_s = times.back() - times.front();
    facts.push_back({.name = name,
                     .count = channel.count,
                     .rate_hz = span_s > 0 ? static_cast<double>(times.size() - 1) / span_s : 0,
                     .last_s = times.back()});
    types.push_back(TypeNameOf(channel.last));
  }
  return ChannelListJson(facts, types);
}

Result<std::string> LiveChannels::MessageJson(const std::string& name, double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  asked_us_ = now_us_();
  const auto channel = channels_.find(name);
  if (channel == channels_.end()) {
    return Error{fmt::format("nothing has come on the channel {} since a page asked for channels",
                             Quoted(name))};
  }
  return MessageJsonOf(
      {.channel = name, .t_s = channel->second.times_s.back(), .data = channel->second.last});
}

std::string LiveChannels::FieldsJson(const std::string& text, double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  asked_us_ = now_us_();
  FieldSearch search(text);
  for (const auto& [name, channel] : channels_) {
    if (!search.Take(name, channel.last)) break;
  }
  return search.Json();
}

Result<std::string> LiveChannels::SeriesJson(const std::string& field, double /*t_s*/,
                                             double window_s) {
  Result<FieldName> name = ParseFieldName(field);
  if (!name.ok()) return Error{name.error()};
  const std::lock_guard lock(mutex_);
  asked_us_ = now_us_();
  if (!series_.contains(field) && series_.size() == kMaxSeries) {
    std::erase_if(series_, [&](const auto& each) {
      return asked_us_ - each.second.asked_us > kSeriesLasts_us;
    });
    if (series_.size() == kMaxSeries) {
      return Error{fmt::format("pages draw {} fields already; close some charts", kMaxSeries)};
    }
  }
  if (const auto channel = channels_.find(name->channel); channel != channels_.end()) {
    if (auto error = FindNoSuchField(*name, channel->second.last)) return *std::move(error);
  }
  Series& series = series_[field];
  series.name = std::move(*name);
  series.asked_us = asked_us_;
  std::vector<SeriesPoint> points;
  if (!series.points.empty()) {
    const double begin_s = series.points.back().t_s - window_s;
    const auto begin =
        std::partition_point(series.points.begin(), series.points.end(),
                             [&](const SeriesPoint& point) { return point.t_s < begin_s; });
    const auto num = static_cast<size_t>(series.points.end() - begin);
    const size_t step = std::max<size_t>(1, (num + kMaxPoints - 1) / kMaxPoints);
    for (size_t i = 0; i < num; i += step) points.push_back(begin[static_cast<ptrdiff_t>(i)]);
  }
  return SeriesJsonOf(field, points);
}

}  // namespace shoal
