#include "apps/shoal_play/play_command.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "lib/base/check/result.h"
#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/multicast_fault.h"
#include "lib/bus/record/log_source.h"
#include "lib/mission/file/recorded_mission.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"
#include "lib/run/launch/launch_plan.h"
#include "lib/run/launch/launch_signals.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// A log without a mission has no steps: its messages are published in steps of this length, or of
/// a longer one where there would be more than kMostSteps.
constexpr int64_t kTickOfOtherLogs_us = 20'000;
constexpr int64_t kMostSteps = 10'000'000;

int Refuse(int code, const std::string& why) {
  fmt::print(stderr, "shoal: {}\n", why);
  return code;
}

std::string Stem(const std::string& path) {
  std::string name = fs::path(path).filename().string();
  return name.substr(0, name.find('.'));
}

/// Returns what is wrong with the names of participants; empty: nothing is.
std::string ProblemOfParticipants(const std::vector<std::string>& names) {
  for (size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    if (const std::string problem = NameProblem(name); !problem.empty()) {
      return fmt::format("--participant: {}", problem);
    }
    const std::string key = LowerCase(name);
    if (key == kPlaybackName) {
      return fmt::format("--participant {}: that is the playback itself", Quoted(name));
    }
    if (std::any_of(names.begin(), names.begin() + static_cast<ptrdiff_t>(i),
                    [&](const std::string& other) { return LowerCase(other) == key; })) {
      return fmt::format("--participant {} is there twice: each needs a name of its own",
                         Quoted(name));
    }
  }
  return {};
}

/// Prints how participants are started beside the playback.
void PrintHandCommands(const PlayOptions& options, const Mission& mission, const PortPlan& ports,
                       int64_t mission_id) {
  const RunOptions run;
  const LaunchContext context = {.options = run,
                                 .mission = mission,
                                 .ports = ports,
                                 .mission_id = mission_id,
                                 .log_dir = {},
                                 .log_path = {}};
  for (const std::string& name : options.participants) {
    fmt::print("Start {} with:\n  {} COMMAND\n", Quoted(name),
               ShellVariables(ParticipantEnvironment(name, context)));
  }
}

}  // namespace

Mission MissionToPlay(const PlaybackLog& log) {
  RecordedMission recorded = FindMissionBeside(log.path());
  if (recorded.mission) {
    Mission mission = std::move(*recorded.mission);
    mission.name = "playback of " + mission.name;
    return mission;
  }
  for (const std::string& error : recorded.errors) {
    fmt::print(stderr, "shoal: the mission beside the log does not load: {}\n", error);
  }
  Mission mission;
  mission.name = "playback of " + Stem(log.path());
  mission.tick_us =
      std::max(kTickOfOtherLogs_us, (log.last_utime() - log.first_utime()) / kMostSteps);
  if (mission.tick_us > kTickOfOtherLogs_us) {
    fmt::print(
        stderr,
        "shoal: {} is {:.0f} s long: what falls into the same {:.3f} s is published at once; "
        "`shoal log copy --from --to` makes a shorter one\n",
        log.path(), Seconds(log.last_utime() - log.first_utime()), Seconds(mission.tick_us));
  }
  mission.start_utime = log.first_utime();
  mission.duration_s = Seconds(log.last_utime() - log.first_utime());
  for (const std::string& name : log.vehicles()) {
    Vehicle vehicle;
    vehicle.name = name;
    mission.vehicles.push_back(std::move(vehicle));
  }
  return mission;
}

int RunPlay(const PlayOptions& options) {
  Result<PlaybackLog> log = PlaybackLog::Open(options.path);
  if (!log.ok()) return Refuse(kExitEnvironment, log.error());
  const double length_s = Seconds(log->last_utime() - log->first_utime());
  if (options.from_s > length_s) {
    return Refuse(kExitUsage, fmt::format("--from {} is behind the end: {} has {:.1f} s",
                                          options.from_s, log->path(), length_s));
  }
  if (const std::string problem = ProblemOfParticipants(options.participants); !problem.empty()) {
    return Refuse(kExitUsage, problem);
  }
  if (!ReportUnmatched(log->path(), options.channels, log->times().channels, std::cerr)) {
    return kExitUsage;
  }
  for (const std::string& warning : TimeWarnings(log->times(), log->path())) {
    fmt::print(stderr, "shoal: {}\n", warning);
  }
  if (const std::string fault = MulticastFault(); !fault.empty()) {
    return Refuse(kExitEnvironment, fault);
  }
  const Mission mission = MissionToPlay(*log);
  std::vector<std::string> vehicles;
  for (const Vehicle& vehicle : mission.vehicles) vehicles.push_back(vehicle.name);
  const Layout layout = PortPlan::Suggest(static_cast<int>(vehicles.size()));
  const int num_ports = PortPlan::NumPorts(layout, static_cast<int>(vehicles.size()));
  const Result<int> base = ClaimPorts(options.port_base, num_ports);
  if (!base.ok()) return Refuse(kExitEnvironment, base.error());
  std::optional<LogWriter> answers;
  if (!options.answers_path.empty()) {
    std::error_code error;
    if (fs::equivalent(options.answers_path, log->path(), error)) {
      return Refuse(kExitUsage, fmt::format("--answers {} is the log itself; name another file",
                                            options.answers_path));
    }
    Result<LogWriter> made = LogWriter::Create(options.answers_path);
    if (!made.ok()) return Refuse(kExitEnvironment, made.error());
    answers.emplace(std::move(*made));
  }
  const std::string played = fs::absolute(log->path()).lexically_normal().string();
  const RunningMission running{.name = mission.name,
                               .file = mission.file.empty()
                                           ? played
                                           : fs::absolute(mission.file).lexically_normal().string(),
                               .folder = WorkingFolder(),
                               .mission_id = RandomPlaybackId(),
                               .port_base = *base,
                               .layout = layout,
                               .pid = getpid(),
                               .vehicles = vehicles,
                               .playback_of = played,
                               .groups = GroupsOf(mission)};
  fmt::print("{}: {:.1f} s of {}, LCM ports {} to {} ({})\n", mission.name, length_s, log->path(),
             *base, *base + num_ports - 1, Name(layout));
  PrintHandCommands(options, mission, running.Ports(), running.mission_id);
  std::fflush(stdout);
  int code = 0;
  {
    const int signal_fd = BlockSignals();
    Player player(options, &*log, mission, running, answers ? &*answers : nullptr, signal_fd);
    code = player.Run();
    close(signal_fd);
  }
  Unregister(*base);
  if (!answers) return code;
  if (const auto failed = answers->Close()) return Refuse(kExitEnvironment, failed->message);
  fmt::print("Answers: {} messages in {}\n", answers->counters().events, options.answers_path);
  return code;
}

}  // namespace shoal
