#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "lib/mission/load.h"
#include "lib/mission/recorded_mission.h"
#include "lib/view/events_json.h"
#include "lib/view/recorded_view.h"
#include "lib/view/setup_json.h"
#include "lib/view/vehicle_json.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// As many pages may look at moments of their own without disturbing one another.
constexpr size_t kMaxIdleScenes = 12;
constexpr size_t kMaxIdleFates = 6;
/// A mission does not begin so long before or after its log.
constexpr int64_t kMissionsApart_us = 86'400'000'000;

struct FoundMission {
  std::optional<Mission> mission;
  std::vector<std::string> notes;
};

Result<FoundMission> FindMission(const std::string& log, const RecordedViewOptions& options) {
  FoundMission found;
  if (!options.mission_file.empty()) {
    LoadedMission loaded = LoadMission(options.mission_file, options.overrides);
    if (!loaded.errors.empty()) return Error{fmt::format("{}", fmt::join(loaded.errors, "\n"))};
    found.mission = std::move(loaded.mission);
    return found;
  }
  RecordedMission recorded = FindMissionBeside(log);
  found.mission = std::move(recorded.mission);
  for (const std::string& error : recorded.errors) found.notes.push_back(error);
  if (!found.mission) {
    found.notes.push_back(
        recorded.errors.empty()
            ? "the log has no mission.toml beside it: vehicles are those of its messages, their "
              "tasks are not known; name the mission file: --mission FILE"
            : "the log is shown without its mission; name one that loads: --mission FILE");
  }
  return found;
}

Result<std::string> LogFileOf(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return path;
  const fs::path inside = fs::path(path) / "mission.lcm";
  if (fs::is_regular_file(inside, error)) return inside.string();
  return Error{fmt::format(
      "{} is a folder without a mission.lcm; name a log, or a folder of `shoal run --record`",
      path)};
}

Scene BlankScene(const Mission& mission, bool knows_rules) {
  Scene scene(mission);
  if (!knows_rules) scene.ForgetRules();
  return scene;
}

}  // namespace

Result<std::unique_ptr<RecordedView>> RecordedView::Open(const std::string& path,
                                                         const RecordedViewOptions& options) {
  const Result<std::string> file = LogFileOf(path);
  if (!file.ok()) return Error{file.error()};
  Result<LogReader> reader = LogReader::Open(*file, OnDamage::kSkip);
  if (!reader.ok()) {
    return Error{
        fmt::format("{}; name a log of `shoal sim --log`, `shoal run --record` or "
                    "lcm-logger",
                    reader.error())};
  }
  Result<FoundMission> found = FindMission(*file, options);
  if (!found.ok()) return Error{found.error()};

  LogSurvey survey = SurveyLog(reader->Another(), !found->mission);
  if (!survey.has_events && reader->size() > 0) {
    return Error{
        fmt::format("{} holds no event of an LCM log: is it one? `shoal log info {}` "
                    "tells more",
                    *file, *file)};
  }
  const bool knows_mission = found->mission.has_value();
  Mission mission = knows_mission ? std::move(*found->mission) : std::move(survey.mission);
  if (!knows_mission) mission.name = fs::path(*file).stem().string();
  const int64_t apart_us = survey.first_utime - PlausibleUtime(mission.start_utime);
  if (survey.has_events && std::abs(apart_us) > kMissionsApart_us) {
    found->notes.push_back(fmt::format(
        "the log begins {:.0f} s from start_utime of {}: is it the log of another mission? Times "
        "count from its first event",
        static_cast<double>(apart_us) / 1e6, mission.file));
    mission.start_utime = survey.first_utime;
  }
  std::unique_ptr<RecordedView> view(
      new RecordedView(std::move(*reader), survey.stamps, std::move(mission), knows_mission));
  view->notes_ = std::move(found->notes);
  Scene scene = view->blank_;
  view->index_ = BuildLogIndex(&view->reader_, &scene, view->mission_, survey.stamps);
  view->Note(survey);
  const std::string floor = FloorJson(view->mission_, &view->notes_);
  Mission shown = view->mission_;
  if (!knows_mission) shown.duration_s = view->end_s();
  view->setup_json_ = shoal::SetupJson(shown,
                                       {.mode = "recorded",
                                        .boot = options.boot,
                                        .knows_models = knows_mission,
                                        .begin_s = view->begin_s(),
                                        .end_s = view->end_s(),
                                        .notes = view->notes_},
                                       floor);
  view->trails_json_ = shoal::TrailsJson(scene, view->index_.trails);
  view->events_json_ = shoal::EventsJson(view->index_.events, view->blank_.start_utime());
  return view;
}

RecordedView::RecordedView(LogReader reader, LogStamps stamps, Mission mission, bool knows_rules)
    : reader_(std::move(reader)),
      stamps_(stamps),
      mission_(std::move(mission)),
      blank_(BlankScene(mission_, knows_rules)),
      idle_scenes_(kMaxIdleScenes),
      idle_fates_(kMaxIdleFates) {}

void RecordedView::Note(const LogSurvey& survey) {
  const auto note = [&]<class... Args>(fmt::format_string<Args...> text, Args&&... args) {
    notes_.push_back(fmt::format(text, std::forward<Args>(args)...));
  };
  if (reader_.size() == 0) note("the log is empty");
  if (const int64_t count = reader_.num_damages(); count > 0) {
    uint64_t skipped = 0;
    for (const LogDamage& damage : reader_.damages()) skipped += damage.end - damage.begin;
    note("the log is damaged in {} place{}; {}{} bytes were skipped, the first at byte {}: {}",
         count, count == 1 ? "" : "s",
         count > static_cast<int64_t>(reader_.damages().size()) ? "more than " : "", skipped,
         reader_.damages().front().begin, reader_.damages().front().what);
  }
  if (!reader_.error().empty()) note("{}", reader_.error());
  if (stamps_ == LogStamps::kWall) {
    note(
        "the log has wall times, as lcm-logger writes them: times shown are those in the messages");
  }
  if (index_.num_shifts > 0) {
    note("the log's clock jumped in {} place{}: what follows is shown right behind",
         index_.num_shifts, index_.num_shifts == 1 ? "" : "s");
  }
  if (index_.num_odd_times > 0) {
    note("{} events have times that do not fit between the others", index_.num_odd_times);
  }
  if (index_.num_undecodable > 0) {
    note("{} messages do not decode: was the log recorded by another version of shoal?",
         index_.num_undecodable);
  }
  if (survey.has_events && !index_.has_nav) {
    note("the log has no NAV of these vehicles: nobody knows where they were");
  }
  if (survey.num_left_out > 0) {
    note("{} vehicles are left out, those behind the first {}", survey.num_left_out,
         LogSurvey::kMaxVehicles);
  }
}

}  // namespace shoal
