#include "lib/tools/view/recorded_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lib/base/time/seconds.h"
#include "lib/bus/record/index_file.h"
#include "lib/tools/view/events_json.h"
#include "lib/tools/view/fates_json.h"
#include "lib/tools/view/frame_json.h"
#include "lib/tools/view/kept_index.h"
#include "lib/tools/view/links_json.h"
#include "lib/tools/view/recorded_log.h"
#include "lib/tools/view/setup_json.h"
#include "lib/tools/view/vehicle_json.h"
#include "lib/tools/view/verdict_json.h"

namespace shoal {

namespace {

/// At most this many pages at different moments do not slow each other.
constexpr size_t kMaxIdleScenes = 12;
constexpr size_t kMaxIdleFates = 6;
constexpr size_t kLinkFates = 50;
constexpr size_t kMaxNamesShown = 20;

Scene BlankScene(const Mission& mission, bool knows_rules) {
  Scene scene(mission);
  if (!knows_rules) scene.ForgetRules();
  return scene;
}

/// Returns the index that is kept beside the log, or reads the log and keeps its index.
KeptIndex IndexOf(LogReader* reader, const Scene& blank, const Mission& mission,
                  const LogSurvey& survey, const RecordedViewOptions& options) {
  const std::string key = IndexKey(blank, mission, survey.stamps);
  if (const auto bytes =
          ReadIndexPart(*reader, IndexPart::kView, key, options.least_indexed_bytes)) {
    if (std::optional<KeptIndex> kept = IndexFrom(*bytes, blank, reader->size())) {
      return *std::move(kept);
    }
  }
  Scene scene = blank;
  bool is_whole = true;
  KeptIndex kept;
  kept.index = BuildLogIndex(reader, &scene, mission, survey.stamps, [&](double share) {
    is_whole = !options.progress || options.progress(share);
    return is_whole;
  });
  for (const SceneVehicle& vehicle : scene.vehicles()) kept.vehicles.push_back(vehicle.name);
  NoteTroubles(*reader, survey, kept.index, &kept.troubles);
  if (is_whole && reader->size() >= options.least_indexed_bytes) {
    if (const auto bytes = IndexBytes(&kept); !bytes.empty()) {
      KeepIndexPart(*reader, IndexPart::kView, key, bytes, options.least_indexed_bytes);
    }
  }
  return kept;
}

}  // namespace

Result<std::unique_ptr<RecordedView>> RecordedView::Open(const std::string& path,
                                                         const RecordedViewOptions& options) {
  Result<RecordedLog> log = OpenRecordedLog(path, options.mission_file, options.overrides);
  if (!log.ok()) return Error{log.error()};
  std::unique_ptr<RecordedView> view(new RecordedView(std::move(log->reader), log->survey.stamps,
                                                      std::move(log->mission), log->knows_mission));
  view->notes_ = std::move(log->notes);
  KeptIndex kept = IndexOf(&view->reader_, view->blank_, view->mission_, log->survey, options);
  view->notes_.insert(view->notes_.end(), kept.troubles.begin(), kept.troubles.end());
  view->index_ = std::move(kept.index);
  view->floor_json_ = FloorJson(view->mission_, &view->notes_);
  view->shown_ = view->mission_;
  view->knows_mission_ = log->knows_mission;
  if (!log->knows_mission) view->shown_.duration_s = view->end_s();
  view->setup_json_ = view->MakeSetupJson(options.boot, view->notes_);
  view->trails_json_ = shoal::TrailsJson(kept.vehicles, view->index_.trails);
  const std::optional<MissionVerdict> verdict = VerdictBeside(LogFileOf(path));
  std::vector<ViewEvent> events = view->index_.events;
  if (verdict) {
    for (ViewEvent& event : EventsOf(*verdict, view->blank_.start_utime())) {
      events.push_back(std::move(event));
    }
  }
  view->events_json_ = shoal::EventsJson(events, view->blank_.start_utime());
  view->verdict_json_ = shoal::VerdictJson(verdict);
  return view;
}

RecordedView::RecordedView(LogReader reader, LogStamps stamps, Mission mission, bool knows_rules)
    : reader_(std::move(reader)),
      stamps_(stamps),
      mission_(std::move(mission)),
      blank_(BlankScene(mission_, knows_rules)),
      idle_scenes_(kMaxIdleScenes),
      idle_fates_(kMaxIdleFates) {}

int64_t RecordedView::LineOf(double t_s) const {
  if (std::isnan(t_s)) return index_.begin_us;
  const double clamped_s = std::clamp(t_s, begin_s(), end_s());
  return std::clamp(Microseconds(clamped_s) + 0LL, 0LL + index_.begin_us, 0LL + index_.end_us);
}

std::unique_ptr<SceneCursor> RecordedView::SceneAt(int64_t line_us) {
  // What is not over at this moment began behind the keyframe.
  constexpr int64_t kStep_us = 1'000'000;
  const int64_t lasting_us = std::max(index_.longest_pulse_us, PacketBook::kMemory_us) + kStep_us;
  const Keyframe& keyframe = index_.KeyframeBefore(line_us - lasting_us);
  auto cursor = idle_scenes_.Take(line_us, keyframe.offset);
  if (!cursor) {
    cursor = std::make_unique<SceneCursor>(reader_.Another(), stamps_, keyframe, blank_);
  }
  cursor->GoTo(line_us);
  return cursor;
}

std::unique_ptr<FateCursor> RecordedView::FatesAt(int64_t line_us) {
  const Keyframe& near = index_.KeyframeBefore(line_us);
  const auto first_kept = near.num_fates - static_cast<int64_t>(FateHistory::kMaxFates);
  const auto behind = std::partition_point(
      index_.keyframes.begin() + 1, index_.keyframes.end(),
      [&](const Keyframe& keyframe) { return keyframe.num_fates <= first_kept; });
  const Keyframe& keyframe = *(behind - 1);
  // A cursor that begins with a later fate, or is behind, cannot be used.
  auto cursor = idle_fates_.Take(line_us, keyframe.offset);
  if (!cursor) cursor = std::make_unique<FateCursor>(reader_.Another(), stamps_, keyframe);
  cursor->GoTo(line_us);
  return cursor;
}

std::string RecordedView::MakeSetupJson(const std::string& boot,
                                        const std::vector<std::string>& notes) const {
  return shoal::SetupJson(shown_,
                          {.mode = "recorded",
                           .boot = boot,
                           .knows_models = knows_mission_,
                           .begin_s = begin_s(),
                           .end_s = end_s(),
                           .notes = notes},
                          floor_json_);
}

std::string RecordedView::SetupJsonWith(const std::string& boot, const std::string& note) const {
  std::vector<std::string> notes = notes_;
  notes.insert(notes.begin(), note);
  return MakeSetupJson(boot, notes);
}

std::string RecordedView::SetupJson(bool /*commands*/) { return setup_json_; }
std::string RecordedView::TrailsJson() { return trails_json_; }
std::string RecordedView::EventsJson() { return events_json_; }
std::string RecordedView::VerdictJson() { return verdict_json_; }

std::string RecordedView::FrameJson(double t_s) {
  const int64_t line_us = LineOf(t_s);
  auto cursor = SceneAt(line_us);
  FrameParts parts = WholeFrame(cursor->scene());
  parts.t_s = Seconds(line_us);
  parts.clock.state = "recorded";
  const auto later = std::partition_point(
      index_.events.begin(), index_.events.end(),
      [&](const ViewEvent& event) { return event.utime <= blank_.start_utime() + line_us; });
  parts.num_events = later - index_.events.begin();
  std::string json = shoal::FrameJson(cursor->scene(), parts);
  idle_scenes_.Return(std::move(cursor));
  return json;
}

std::string RecordedView::LinksJson(double t_s) {
  auto cursor = SceneAt(LineOf(t_s));
  std::string json = shoal::LinksJson(cursor->scene());
  idle_scenes_.Return(std::move(cursor));
  return json;
}

Result<std::string> RecordedView::MediumLinksJson(std::string_view medium, double t_s) {
  auto cursor = SceneAt(LineOf(t_s));
  Result<std::string> json = shoal::MediumLinksJson(cursor->scene(), medium);
  idle_scenes_.Return(std::move(cursor));
  return json;
}

std::string RecordedView::FatesJson(const FateQuery& query, double t_s) {
  auto cursor = FatesAt(LineOf(t_s));
  std::string json = shoal::FatesJson(cursor->fates(), query, blank_);
  idle_fates_.Return(std::move(cursor));
  return json;
}

Result<std::string> RecordedView::LinkJson(std::string_view from, std::string_view to, double t_s) {
  const int64_t line_us = LineOf(t_s);
  auto scene = SceneAt(line_us);
  auto fates = FatesAt(line_us);
  const LinkBook& links = scene->scene().links();
  const std::string* source = scene->scene().NameOf(from);
  const std::string* destination = scene->scene().NameOf(to);
  Result<std::string> result = NoSuchVehicle(source == nullptr ? from : to);
  if (source != nullptr && destination != nullptr) {
    LinkAnswer answer{.from = *source,
                      .to = *destination,
                      .counts = links.Find(links.names().Find(from), links.names().Find(to)),
                      .bins = {},
                      .ranges = {},
                      .fates = {}};
    if (answer.counts != nullptr) answer.bins = RatioBins(*answer.counts, line_us);
    answer.fates = fates->fates().OfLink(from, to, FateHistory::kMaxFates);
    LinkHistory history;
    for (auto fate = answer.fates.rbegin(); fate != answer.fates.rend(); ++fate) {
      history.Add((*fate)->facts, blank_.SecondsOf((*fate)->facts.utime));
    }
    answer.ranges.assign(history.ranges().begin(), history.ranges().end());
    if (answer.fates.size() > kLinkFates) answer.fates.resize(kLinkFates);
    result = shoal::LinkJson(scene->scene(), answer);
  }
  idle_fates_.Return(std::move(fates));
  idle_scenes_.Return(std::move(scene));
  return result;
}

std::vector<RatioBin> RecordedView::RatioBins(const LinkCounts& link, int64_t line_us) const {
  struct Sum {
    int64_t line_us = 0;
    uint64_t received = 0;
    uint64_t offered = 0;
  };
  // Sums at keyframes up to now, not more than there may be bins, and now.
  const size_t num_before =
      static_cast<size_t>(&index_.KeyframeBefore(line_us) - index_.keyframes.data()) + 1;
  const size_t stride = num_before / LinkHistory::kMaxBins + 1;
  std::vector<Sum> sums;
  for (size_t i = 0; i < num_before; i += stride) {
    const Keyframe& keyframe = index_.keyframes[i];
    const LinkCounts* then = keyframe.links.Find(link.from, link.to);
    Sum sum{.line_us = i == 0 ? index_.begin_us : keyframe.timeline.now_us()};
    if (then != nullptr) {
      sum.received = then->Received();
      sum.offered = then->Offered();
    }
    sums.push_back(sum);
  }
  sums.push_back({.line_us = line_us, .received = link.Received(), .offered = link.Offered()});
  std::vector<RatioBin> bins;
  for (size_t i = 0; i + 1 < sums.size(); ++i) {
    const auto offered = static_cast<int64_t>(sums[i + 1].offered - sums[i].offered);
    if (offered == 0) continue;
    bins.push_back({.begin_s = Seconds(sums[i].line_us),
                    .received = static_cast<int64_t>(sums[i + 1].received - sums[i].received),
                    .offered = offered});
  }
  return bins;
}

Result<std::string> RecordedView::VehicleJson(std::string_view name, double t_s, double window_s) {
  constexpr double kShortestWindow_s = 1;
  constexpr double kLongestWindow_s = 3600;
  const int64_t line_us = LineOf(t_s);
  auto cursor = SceneAt(line_us);
  const Scene& scene = cursor->scene();
  const SceneVehicle* vehicle = scene.Find(name);
  Result<std::string> result = NoSuchVehicle(name);
  if (vehicle != nullptr) {
    const auto place = static_cast<size_t>(vehicle - scene.vehicles().data());
    std::vector<ChartPoint> points;
    if (place < index_.charts.size()) {
      window_s = std::isnan(window_s) ? kLongestWindow_s
                                      : std::clamp(window_s, kShortestWindow_s, kLongestWindow_s);
      points = index_.charts[place].Window(Seconds(line_us), window_s);
    }
    result = shoal::VehicleJson(scene, *vehicle, points);
  }
  idle_scenes_.Return(std::move(cursor));
  return result;
}

Error RecordedView::NoSuchVehicle(std::string_view name) const {
  std::vector<std::string_view> names;
  for (const Vehicle& vehicle : mission_.vehicles) names.push_back(vehicle.name);
  const bool is_cut = names.size() > kMaxNamesShown;
  if (is_cut) names.resize(kMaxNamesShown);
  constexpr size_t kMaxShown = 64;
  return {fmt::format("no vehicle '{}' in the log; there are: {}{}", name.substr(0, kMaxShown),
                      names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")),
                      is_cut ? ", ..." : "")};
}

}  // namespace shoal
