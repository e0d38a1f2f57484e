#include "lib/tools/view/live_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/tools/view/events_json.h"
#include "lib/tools/view/fates_json.h"
#include "lib/tools/view/frame_json.h"
#include "lib/tools/view/links_json.h"
#include "lib/tools/view/setup_json.h"
#include "lib/tools/view/vehicle_json.h"
#include "lib/tools/view/verdict_json.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

constexpr size_t kFatesOfLink = 50;

Error UnknownVehicle(std::string_view name) {
  return Error{fmt::format("the mission has no vehicle '{}'; /api/frame lists them",
                           name.substr(0, kMaxNameBytes))};
}

}  // namespace

LiveView::LiveView(std::string boot) : LiveView(Mission{}, std::move(boot)) {
  clock_.state = "waiting";
}

LiveView::LiveView(const Mission& mission, std::string boot, std::vector<std::string> notes)
    : scene_(mission),
      vehicle_histories_(mission.vehicles.size()),
      trails_(mission.vehicles.size()),
      events_(WatchedVehiclesOf(mission), PlannedEventsOf(mission)) {
  SetupFacts facts{.boot = std::move(boot), .end_s = mission.duration_s, .notes = std::move(notes)};
  const std::string floor = FloorJson(mission, &facts.notes);
  setup_json_ = shoal::SetupJson(mission, facts, floor);
  facts.commands = true;
  setup_json_commands_ = shoal::SetupJson(mission, facts, floor);
  backgrounds_ = BackgroundsOf(mission);
  clock_.state = "gathering";
  FollowRules();
}

void LiveView::Handle(std::string_view channel, std::span<const uint8_t> data) {
  const std::lock_guard lock(mutex_);
  ++num_changes_;
  if (channel == clock_channel_) {
    clock_state_t clock;
    if (!Decode(data, &clock)) return;
    clock_ = ViewClockOf(clock);
    has_clock_ = true;
    scene_.HandleClock(clock);
    return;
  }
  if (!has_clock_) clock_.state = "running";
  scene_.Handle(channel, data, this);
  FollowRules();
}

void LiveView::SetCommands(std::vector<CommandRecord> commands) {
  const std::lock_guard lock(mutex_);
  ++num_changes_;
  commands_ = std::move(commands);
}

void LiveView::SetClockGone(std::string_view state) {
  const std::lock_guard lock(mutex_);
  ++num_changes_;
  clock_ = {.state = std::string(state)};
  has_clock_ = true;
}

void LiveView::SetVerdict(MissionVerdict verdict) {
  const std::lock_guard lock(mutex_);
  ++num_changes_;
  verdict_ = std::move(verdict);
}

std::string LiveView::StreamFrameJson() {
  const std::lock_guard lock(mutex_);
  FrameParts parts = PartsOfNow();
  parts.pulses = scene_.pulses().TakeForStream(pulses_sent_, scene_.now_utime(), kMaxStreamPulses,
                                               &parts.pulses_left_out);
  parts.packets = scene_.packets().Since(packets_sent_, scene_.now_utime());
  pulses_sent_ = scene_.pulses().last_order();
  packets_sent_ = scene_.packets().last_order();
  return shoal::FrameJson(scene_, parts);
}

int64_t LiveView::num_changes() const {
  const std::lock_guard lock(mutex_);
  return num_changes_;
}

std::string LiveView::SetupJson(bool commands) {
  return commands ? setup_json_commands_ : setup_json_;
}

std::string LiveView::FrameJson(double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  return shoal::FrameJson(scene_, PartsOfNow());
}

std::string LiveView::TrailsJson() {
  const std::lock_guard lock(mutex_);
  return shoal::TrailsJson(scene_, trails_);
}

std::string LiveView::LinksJson(double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  return shoal::LinksJson(scene_);
}

Result<std::string> LiveView::MediumLinksJson(std::string_view medium, double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  return shoal::MediumLinksJson(scene_, medium);
}

std::string LiveView::FatesJson(const FateQuery& query, double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  return shoal::FatesJson(fates_, query, scene_);
}

std::string LiveView::VerdictJson() {
  const std::lock_guard lock(mutex_);
  return shoal::VerdictJson(verdict_);
}

std::string LiveView::EventsJson() {
  const std::lock_guard lock(mutex_);
  if (!verdict_) return shoal::EventsJson(events_.events(), scene_.start_utime());
  std::vector<ViewEvent> events = events_.events();
  const std::vector<ViewEvent> last = EventsOf(*verdict_, scene_.start_utime());
  events.insert(events.end(), last.begin(), last.end());
  return shoal::EventsJson(events, scene_.start_utime());
}

Result<std::string> LiveView::LinkJson(std::string_view from, std::string_view to, double /*t_s*/) {
  const std::lock_guard lock(mutex_);
  const LinkBook& book = scene_.links();
  const std::string* source = scene_.NameOf(from);
  const std::string* destination = scene_.NameOf(to);
  if (source == nullptr || destination == nullptr) {
    return UnknownVehicle(source == nullptr ? from : to);
  }
  LinkAnswer answer{.from = *source,
                    .to = *destination,
                    .counts = book.Find(book.names().Find(from), book.names().Find(to))};
  if (answer.counts != nullptr) {
    const auto link = static_cast<size_t>(answer.counts - book.links().data());
    answer.bins = link_histories_[link].Bins();
    answer.ranges.assign(link_histories_[link].ranges().begin(),
                         link_histories_[link].ranges().end());
    answer.fates = fates_.OfLink(answer.from, answer.to, kFatesOfLink);
  }
  return shoal::LinkJson(scene_, answer);
}

Result<std::string> LiveView::VehicleJson(std::string_view name, double /*t_s*/, double window_s) {
  const std::lock_guard lock(mutex_);
  const SceneVehicle* vehicle = scene_.Find(name);
  if (vehicle == nullptr) return UnknownVehicle(name);
  const auto place = static_cast<size_t>(vehicle - scene_.vehicles().data());
  std::vector<ChartPoint> points;
  if (place < vehicle_histories_.size()) {
    points = vehicle_histories_[place].Window(scene_.now_s(), window_s);
  }
  return shoal::VehicleJson(scene_, *vehicle, points);
}

void LiveView::OnNav(size_t vehicle, const nav_t& nav) {
  const double t_s = scene_.SecondsOf(nav.utime);
  trails_[vehicle].Add(t_s, nav.x_m, nav.y_m);
  vehicle_histories_[vehicle].Add(t_s, nav, LastOf<ShownDesired>(scene_.vehicles()[vehicle].shown));
  events_.OnNav(vehicle, nav.utime, nav.x_m, nav.y_m, nav.z_m, nav.altitude_m);
  events_.OnTime(scene_.now_utime());
}

void LiveView::OnHelm(size_t vehicle, const helm_state_t& helm) { events_.OnHelm(vehicle, helm); }

void LiveView::OnCommand(size_t vehicle, const helm_command_t& command) {
  events_.OnCommand(vehicle, command, scene_.now_utime());
}

void LiveView::OnDecision(size_t vehicle, const helm_decision_t& decision) {
  events_.OnDecision(vehicle, decision);
}

void LiveView::OnNavigation(size_t vehicle, const navigation_t& navigation) {
  events_.OnNavigation(vehicle, navigation);
}

void LiveView::OnReport(size_t vehicle, const ReceivedReport& report) {
  if (trails_.size() <= vehicle) trails_.resize(vehicle + 1);
  if (scene_.vehicles()[vehicle].nav) return;
  trails_[vehicle].Add(scene_.SecondsOf(report.received_utime), report.x_m, report.y_m);
}

void LiveView::OnFate(const FateView& fate, const LinkPlace& place) {
  fates_.Add(fate);
  if (place.link < 0) return;
  const NameTable& names = scene_.links().names();
  const size_t num_named = std::min(names.size(), EventWatch::kMaxNames);
  while (events_.num_names() < num_named) {
    const auto number = static_cast<int32_t>(events_.num_names());
    events_.SetName(number, names.at(number));
  }
  events_.OnFate(place.from, place.to, fate.facts.cause, fate.facts.utime);
  if (fate.facts.kind == Kind::kMessage) events_.OnMessage(place.from, place.to, fate);
  const auto link = static_cast<size_t>(place.link);
  if (link_histories_.size() <= link) link_histories_.resize(link + 1);
  link_histories_[link].Add(fate.facts, scene_.SecondsOf(fate.facts.utime));
}

void LiveView::FollowRules() {
  const double stale_time_s = scene_.rules() ? scene_.rules()->stale_time_s : -1;
  if (stale_time_s == stale_time_s_) return;
  stale_time_s_ = stale_time_s;
  events_.SetStaleTime(stale_time_s);
}

FrameParts LiveView::PartsOfNow() const {
  FrameParts parts = WholeFrame(scene_);
  parts.clock = clock_;
  parts.commands = commands_;
  parts.num_events = static_cast<int64_t>(events_.events().size() + (verdict_ ? 1 : 0));
  return parts;
}

}  // namespace shoal
