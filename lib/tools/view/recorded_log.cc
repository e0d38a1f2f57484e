#include "lib/tools/view/recorded_log.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/mission/file/load.h"
#include "lib/mission/file/recorded_mission.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// A mission begins no more than a day before or after its log.
constexpr int64_t kMissionsApart_us = 86'400'000'000;

struct FoundMission {
  std::optional<Mission> mission;
  std::vector<std::string> notes;
};

Result<FoundMission> FindMission(const std::string& log, const std::string& mission_file,
                                 const std::vector<std::string>& overrides) {
  FoundMission found;
  if (!mission_file.empty()) {
    LoadedMission loaded = LoadMission(mission_file, overrides);
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

}  // namespace

Result<RecordedLog> OpenRecordedLog(const std::string& path, const std::string& mission_file,
                                    const std::vector<std::string>& overrides) {
  const std::string file = LogFileOf(path);
  Result<LogReader> reader = LogReader::Open(file, OnDamage::kSkip);
  if (!reader.ok()) {
    return Error{
        fmt::format("{}; name a log of `shoal sim --log`, `shoal run --record` or "
                    "lcm-logger",
                    reader.error())};
  }
  Result<FoundMission> found = FindMission(file, mission_file, overrides);
  if (!found.ok()) return Error{found.error()};

  LogSurvey survey = SurveyLog(reader->Another(), !found->mission);
  if (!survey.has_events && reader->size() > 0) {
    return Error{
        fmt::format("{} holds no event of an LCM log; `shoal log info {}` "
                    "shows more",
                    file, file)};
  }
  const bool knows_mission = found->mission.has_value();
  Mission mission = knows_mission ? std::move(*found->mission) : std::move(survey.mission);
  if (!knows_mission) mission.name = fs::path(file).stem().string();
  const int64_t apart_us = survey.first_utime - PlausibleUtime(mission.start_utime);
  if (survey.has_events && std::abs(apart_us) > kMissionsApart_us) {
    found->notes.push_back(fmt::format(
        "the log begins {:.0f} s from start_utime of {}: is it the log of another mission? Times "
        "count from its first event",
        Seconds(apart_us), mission.file));
    mission.start_utime = survey.first_utime;
  }
  return RecordedLog{.reader = std::move(*reader),
                     .survey = std::move(survey),
                     .mission = std::move(mission),
                     .knows_mission = knows_mission,
                     .notes = std::move(found->notes)};
}

void NoteTroubles(const LogReader& reader, const LogSurvey& survey, const LogIndex& index,
                  std::vector<std::string>* notes) {
  const auto note = [&]<class... Args>(fmt::format_string<Args...> text, Args&&... args) {
    notes->push_back(fmt::format(text, std::forward<Args>(args)...));
  };
  if (reader.size() == 0) note("the log is empty");
  if (const int64_t count = reader.num_damages(); count > 0) {
    uint64_t skipped = 0;
    for (const LogDamage& damage : reader.damages()) skipped += damage.end - damage.begin;
    note("the log is damaged in {} place{}; {}{} bytes were skipped, the first at byte {}: {}",
         count, count == 1 ? "" : "s",
         count > static_cast<int64_t>(reader.damages().size()) ? "more than " : "", skipped,
         reader.damages().front().begin, reader.damages().front().what);
  }
  if (!reader.error().empty()) note("{}", reader.error());
  if (survey.stamps == LogStamps::kWall) {
    note(
        "the log has wall times, as lcm-logger writes them: times shown are those in the messages");
  }
  if (index.num_shifts > 0) {
    note("the log's clock jumped in {} place{}: what follows is shown right behind",
         index.num_shifts, index.num_shifts == 1 ? "" : "s");
  }
  if (index.num_odd_times > 0) {
    note("{} events have times that do not fit between the others", index.num_odd_times);
  }
  if (index.num_undecodable > 0) {
    note("{} messages do not decode: was the log recorded by another version of shoal?",
         index.num_undecodable);
  }
  for (const std::string& line : index.strange_rules) note("{}", line);
  if (survey.has_events && !index.has_nav) {
    note("the log has no NAV of these vehicles: their positions are not known");
  }
  if (survey.num_left_out > 0) {
    note("{} vehicles are left out, those behind the first {}", survey.num_left_out,
         LogSurvey::kMaxVehicles);
  }
}

}  // namespace shoal
