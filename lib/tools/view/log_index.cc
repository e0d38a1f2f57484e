#include "lib/tools/view/log_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <unordered_map>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/tools/view/wire_reader.h"

namespace shoal {

namespace {

/// A pulse that lasts longer is not shown after a seek behind its begin.
constexpr double kLongestPulse_s = 60;

/// How the index treats a channel.
struct ChannelUse {
  enum class Topic { kState, kReports, kRules, kFates, kPulses, kDrawings };
  Topic topic = Topic::kState;
  int32_t slot = -1;  ///< Of its standing message; -1: none yet.
};

ChannelUse::Topic TopicOf(std::string_view channel) {
  using enum ChannelUse::Topic;
  if (channel == topics::kNodeReportLocal || channel == topics::kNodeReport) return kReports;
  if (channel == topics::kCommsRules) return kRules;
  if (channel == topics::kCommsFates || channel == topics::kCommsMedia) return kFates;
  if (channel == topics::kViewCommsPulse) return kPulses;
  if (std::ranges::count(DrawingBook::Topics(), channel) > 0) return kDrawings;
  return kState;
}

/// Returns the vehicle of an encoded node_report_t.
std::string_view ReporterOf(std::span<const uint8_t> report) {
  WireReader reader(report);
  reader.Int64();  // fingerprint
  reader.Int64();  // utime
  return reader.Text();
}

struct TextHash {
  using is_transparent = void;
  size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

class IndexBuilder : private SceneObserver {
 public:
  IndexBuilder(Scene* scene, const Mission& mission, LogStamps stamps, uint64_t log_size)
      : scene_(*scene),
        stamps_(stamps),
        watch_(WatchedVehiclesOf(mission), PlannedEventsOf(mission)),
        gap_bytes_(std::max(LogIndex::kLeastGap_bytes, log_size / LogIndex::kMaxKeyframes)),
        next_(KeyframeAtStart(scene_)) {
    for (const std::string& channel : Scene::Channels(mission)) {
      channels_.emplace(channel, ChannelUse{.topic = TopicOf(channel)});
    }
    index_.trails.resize(mission.vehicles.size());
    index_.charts.resize(mission.vehicles.size());
    if (scene_.rules()) watch_.SetStaleTime(scene_.rules()->stale_time_s);
    TakePulseDuration(mission.comms.pulse_duration_s);
    AddKeyframe(0);
  }

  void Take(const LogEvent& event) {
    if (event.offset >= index_.keyframes.back().offset + gap_bytes_) AddKeyframe(event.offset);
    ++index_.num_events;
    if (const auto utime = MissionUtimeOf(event, stamps_)) {
      const bool was_begun = next_.timeline.is_begun();
      next_.timeline.Advance(*utime);
      if (!was_begun) index_.begin_us = next_.timeline.now_us();
    }
    const auto use = channels_.find(event.channel);
    if (use != channels_.end()) TakeKnown(event, &use->second);
  }

  LogIndex Finish() {
    watch_.OnTime(scene_.now_utime());
    watch_.Finish();
    KeepEvents();
    std::stable_sort(index_.events.begin(), index_.events.end(),
                     [](const ViewEvent& a, const ViewEvent& b) { return a.utime < b.utime; });
    index_.end_us = next_.timeline.now_us();
    index_.num_odd_times = next_.timeline.num_odd();
    index_.num_shifts = next_.timeline.num_shifts();
    index_.num_undecodable = scene_.num_undecodable();
    return std::move(index_);
  }

 private:
  using Topic = ChannelUse::Topic;

  static Keyframe KeyframeAtStart(const Scene& scene) {
    return {.timeline = RecordedTimeline(scene.start_utime()),
            .links = {},
            .media_links = {},
            .standing = {}};
  }

  void TakeKnown(const LogEvent& event, ChannelUse* use) {
    if (use->topic == Topic::kPulses) return;
    const auto data = Unseal(event.data).message;
    const int64_t num_refused = scene_.num_undecodable() + scene_.num_left_out();
    scene_.Handle(event.channel, data, this);
    watch_.OnTime(scene_.now_utime());
    KeepEvents();
    if (num_refused != scene_.num_undecodable() + scene_.num_left_out()) return;
    switch (use->topic) {
      case Topic::kReports:
        Stand(event, &reporters_.try_emplace(VehicleKey(ReporterOf(data)), -1).first->second);
        break;
      case Topic::kRules:
        TakeRules();
        [[fallthrough]];
      case Topic::kState:
        Stand(event, &use->slot);
        break;
      case Topic::kDrawings:
        StandDrawing(event, data);
        break;
      case Topic::kFates:
      case Topic::kPulses:
        break;
    }
  }

  /// Each drawing stands by itself; of very many those that came first.
  void StandDrawing(const LogEvent& event, std::span<const uint8_t> data) {
    const auto drawing = ReadDrawing(event.channel, data);
    if (!drawing) return;
    std::string key = fmt::format("{}\n{}\n{}", event.channel, drawing->owner, drawing->label);
    auto found = drawings_.find(key);
    if (found == drawings_.end()) {
      if (drawings_.size() == DrawingBook::kMaxDrawings) return;
      found = drawings_.emplace(std::move(key), -1).first;
    }
    Stand(event, &found->second);
  }

  void Stand(const LogEvent& event, int32_t* slot) {
    if (*slot < 0) {
      *slot = static_cast<int32_t>(next_.standing.size());
      next_.standing.emplace_back();
    }
    next_.standing[static_cast<size_t>(*slot)] = {.offset = event.offset,
                                                  .scene_utime = scene_.now_utime()};
  }

  void TakeRules() {
    if (!scene_.rules()) return;
    watch_.SetStaleTime(scene_.rules()->stale_time_s);
    TakePulseDuration(scene_.rules()->pulse_duration_s);
    if (index_.strange_rules.empty()) index_.strange_rules = scene_.rules()->strange;
  }

  void TakePulseDuration(double duration_s) {
    if (!(duration_s > 0)) return;
    index_.longest_pulse_us = std::max(
        index_.longest_pulse_us, static_cast<int64_t>(std::min(duration_s, kLongestPulse_s) * 1e6));
  }

  double Line_s() const { return Seconds(next_.timeline.now_us()); }

  void OnNav(size_t vehicle, const nav_t& nav) override {
    index_.has_nav = true;
    index_.trails[vehicle].Add(Line_s(), nav.x_m, nav.y_m);
    index_.charts[vehicle].Add(Line_s(), nav,
                               LastOf<ShownDesired>(scene_.vehicles()[vehicle].shown));
    watch_.OnNav(vehicle, nav.utime, nav.x_m, nav.y_m, nav.z_m, nav.altitude_m);
  }

  void OnHelm(size_t vehicle, const helm_state_t& helm) override { watch_.OnHelm(vehicle, helm); }

  void OnCommand(size_t vehicle, const helm_command_t& command) override {
    watch_.OnCommand(vehicle, command, scene_.now_utime());
  }
  void OnDecision(size_t vehicle, const helm_decision_t& decision) override {
    watch_.OnDecision(vehicle, decision);
  }
  void OnNavigation(size_t vehicle, const navigation_t& navigation) override {
    watch_.OnNavigation(vehicle, navigation);
  }

  void OnReport(size_t vehicle, const ReceivedReport& report) override {
    if (index_.trails.size() <= vehicle) index_.trails.resize(vehicle + 1);
    if (scene_.vehicles()[vehicle].nav) return;
    index_.trails[vehicle].Add(Line_s(), report.x_m, report.y_m);
  }

  void OnFate(const FateView& fate, const LinkPlace& place) override {
    ++next_.num_fates;
    next_.kinds_seen[static_cast<size_t>(fate.facts.kind)] = true;
    next_.causes_seen[static_cast<size_t>(fate.facts.cause)] = true;
    if (place.link < 0) return;
    const NameTable& names = scene_.links().names();
    const size_t num_named = std::min(names.size(), EventWatch::kMaxNames);
    while (watch_.num_names() < num_named) {
      const auto number = static_cast<int32_t>(watch_.num_names());
      watch_.SetName(number, names.at(number));
    }
    watch_.OnFate(place.from, place.to, fate.facts.cause, fate.facts.utime);
    if (fate.facts.kind == Kind::kMessage) watch_.OnMessage(place.from, place.to, fate);
  }

  /// Puts what the watch has found on the timeline.
  void KeepEvents() {
    const auto& found = watch_.events();
    const int64_t zero_utime = next_.timeline.UtimeOf(0);
    while (index_.events.size() < found.size()) {
      ViewEvent event = found[index_.events.size()];
      const int64_t line_us = PlausibleUtime(event.utime) - zero_utime;
      event.utime = scene_.start_utime() +
                    std::clamp(line_us, std::min(index_.begin_us, next_.timeline.now_us()),
                               next_.timeline.now_us());
      index_.events.push_back(std::move(event));
    }
  }

  void AddKeyframe(uint64_t offset) {
    next_.offset = offset;
    next_.scene_utime = scene_.now_utime();
    Keyframe& keyframe = index_.keyframes.emplace_back(next_);
    keyframe.links = scene_.links();
    keyframe.media_links = scene_.media_links();
    num_links_ += NumLinks(keyframe);
    while (index_.keyframes.size() > 2 && (index_.keyframes.size() > LogIndex::kMaxKeyframes ||
                                           num_links_ > LogIndex::kMaxLinks)) {
      ThinKeyframes();
    }
  }

  static size_t NumLinks(const Keyframe& keyframe) {
    return keyframe.links.links().size() + keyframe.media_links.num_links();
  }

  /// Drops every other keyframe, but never the first.
  void ThinKeyframes() {
    auto& keyframes = index_.keyframes;
    num_links_ = 0;
    size_t kept = 0;
    for (size_t i = 0; i < keyframes.size(); i += 2) {
      if (kept != i) keyframes[kept] = std::move(keyframes[i]);
      num_links_ += NumLinks(keyframes[kept++]);
    }
    keyframes.erase(keyframes.begin() + static_cast<ptrdiff_t>(kept), keyframes.end());
    gap_bytes_ *= 2;
  }

  Scene& scene_;
  LogStamps stamps_;
  EventWatch watch_;
  uint64_t gap_bytes_;
  Keyframe next_;  ///< All of it but the links, which are the scene's.
  std::unordered_map<std::string, ChannelUse, TextHash, std::equal_to<>> channels_;
  std::unordered_map<std::string, int32_t> reporters_;  ///< Their slots, by key.
  std::unordered_map<std::string, int32_t> drawings_;   ///< Likewise, by channel, owner and label.
  size_t num_links_ = 0;                                ///< In all keyframes.
  LogIndex index_;
};

}  // namespace

const Keyframe& LogIndex::KeyframeBefore(int64_t line_us) const {
  const auto later = std::partition_point(
      keyframes.begin() + 1, keyframes.end(),
      [&](const Keyframe& keyframe) { return keyframe.timeline.now_us() <= line_us; });
  return *(later - 1);
}

LogIndex BuildLogIndex(LogReader* reader, Scene* scene, const Mission& mission, LogStamps stamps,
                       const IndexProgress& progress) {
  constexpr int64_t kEventsBetweenLooks = 4096;
  IndexBuilder builder(scene, mission, stamps, reader->size());
  for (int64_t num_events = 1;; ++num_events) {
    const auto event = reader->Next();
    if (!event) break;
    builder.Take(*event);
    if (!progress || num_events % kEventsBetweenLooks != 0) continue;
    const auto size = static_cast<double>(std::max<uint64_t>(reader->size(), 1));
    if (!progress(static_cast<double>(event->offset) / size)) break;
  }
  return builder.Finish();
}

}  // namespace shoal
