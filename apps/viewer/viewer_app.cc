#include "apps/viewer/viewer_app.h"

#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <thread>

#include "apps/viewer/access.h"
#include "apps/viewer/event_hub.h"
#include "apps/viewer/growing_log.h"
#include "apps/viewer/listening_socket.h"
#include "apps/viewer/mission_follower.h"
#include "apps/viewer/outside_tiles.h"
#include "apps/viewer/page_export.h"
#include "apps/viewer/page_files.h"
#include "apps/viewer/recorded_channels.h"
#include "apps/viewer/view_site.h"
#include "apps/viewer/web_server.h"
#include "lib/base/check/result.h"
#include "lib/mission/file/load.h"
#include "lib/run/run/run_app.h"
#include "lib/tools/view/planned_view.h"

namespace shoal {

namespace {

/// Less than a mission's processes have: a viewer must not slow a mission that runs as fast as the
/// machine can.
constexpr int kNiceness = 5;

int Fail(int exit_code, const std::string& why) {
  fmt::print(stderr, "shoal-viewer: {}\n", why);
  return exit_code;
}

std::string HostName() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "localhost";
  return name.data();
}

/// Blocks the signals, to wait for them; called before there are threads, which inherit the mask.
sigset_t BlockStopSignals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, number);
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signal(SIGPIPE, SIG_IGN);
  return set;
}

AccessRules RulesOf(const ViewerOptions& options) {
  AccessRules rules = {.allow_commands = options.allow_commands,
                       .reading_needs_token = !IsLoopback(options.listen)};
  if (rules.reading_needs_token) rules.names = {options.listen, HostName()};
  if (rules.allow_commands || rules.reading_needs_token) rules.token = NewToken();
  return rules;
}

ListeningOptions ListeningOf(const ViewerOptions& options) {
  const int port = options.http_port.value_or(kFirstHttpPort);
  return {.address = options.listen,
          .port = port,
          .last_port = options.http_port ? port : port + kMoreHttpPorts};
}

/// Serves `parts` until a signal comes; `follower`, where there is one, fills `hub`.
int Serve(const ViewerOptions& options, ViewSiteParts parts, EventHub& hub,
          MissionFollower* follower) {
  Result<ListeningSocket> socket = ListenOn(ListeningOf(options));
  if (!socket.ok()) return Fail(kExitEnvironment, socket.error());
  fmt::print("viewer: {}\n", PageUrl(options.listen, socket->port, parts.access.token, HostName()));
  std::fflush(stdout);

  const sigset_t signals = BlockStopSignals();
  ViewSite site(std::move(parts));
  WebServerOptions serving_options;
  if (!options.outside_tiles.empty()) {
    serving_options.outside_origin = OriginOf(options.outside_tiles);
  }
  WebServer server(std::move(*socket), serving_options, hub, site);
  std::thread serving([&] { server.Run(); });
  int exit_code = kExitOk;
  std::thread following;
  if (follower != nullptr) {
    following = std::thread([&] {
      exit_code = follower->Run();
      if (exit_code != kExitOk) kill(getpid(), SIGTERM);
    });
  }
  int number = 0;
  sigwait(&signals, &number);
  server.Stop();
  serving.join();
  if (follower != nullptr) {
    follower->Stop();
    following.join();
  }
  return exit_code;
}

/// Returns the file of a recorded mission; empty: it is not known.
std::string MissionFileOf(const ViewerOptions& options) {
  namespace fs = std::filesystem;
  if (!options.mission_file.empty()) return options.mission_file;
  std::error_code error;
  const fs::path log(options.log);
  const fs::path file = (fs::is_directory(log, error) ? log : log.parent_path()) / "mission.toml";
  return fs::is_regular_file(file, error) ? file.string() : "";
}

int ServeLog(const ViewerOptions& options, ViewSiteParts parts) {
  Result<std::unique_ptr<GrowingLog>> log =
      GrowingLog::Open(options.log, options.mission_file, MonotonicMicroseconds);
  if (!log.ok()) return Fail(kExitUsage, log.error());
  parts.source = [&shown = **log] { return shown.source(); };
  parts.channels = [channels = std::make_shared<RecordedChannels>(
                        options.log, options.mission_file)] { return channels; };
  const std::string mission_file = MissionFileOf(options);
  parts.plan = std::make_shared<PlanDesk>(options.allow_commands,
                                          [mission_file] { return PlanFile{mission_file}; });
  EventHub hub;
  return Serve(options, std::move(parts), hub, nullptr);
}

/// Shows a mission before it runs.
int ServePlan(const ViewerOptions& options, ViewSiteParts parts) {
  const LoadedMission loaded = LoadMission(options.plan);
  if (!loaded.errors.empty()) {
    for (const std::string& error : loaded.errors) fmt::print(stderr, "{}\n", error);
    return kExitUsage;
  }
  const auto view = std::make_shared<PlannedView>(loaded.mission, NewToken());
  parts.source = [view] { return view; };
  parts.plan = std::make_shared<PlanDesk>(options.allow_commands,
                                          [file = options.plan] { return PlanFile{file}; });
  EventHub hub;
  return Serve(options, std::move(parts), hub, nullptr);
}

int ServeRunningMission(const ViewerOptions& options, ViewSiteParts parts) {
  EventHub hub;
  MissionFollower follower(
      {.port_base = options.port_base, .allow_commands = options.allow_commands}, hub);
  parts.is_live = true;
  parts.source = [&follower] { return follower.source(); };
  parts.channels = [&follower] { return follower.channels(); };
  parts.plan = std::make_shared<PlanDesk>(options.allow_commands,
                                          [&follower] { return follower.plan_file(); });
  parts.status = [&follower] { return follower.StatusJson(); };
  parts.command = [&follower](const CommandWords& words) { return follower.Command(words); };
  return Serve(options, std::move(parts), hub, &follower);
}

}  // namespace

int RunViewer(const ViewerOptions& options) {
  setpriority(PRIO_PROCESS, 0, kNiceness);
  // A viewer that wakes never preempts a participant.
  const sched_param batch{};
  sched_setscheduler(0, SCHED_BATCH, &batch);
  ViewSiteParts parts = {.access = RulesOf(options)};
  if (options.web_folder.empty()) {
    parts.files = EmbeddedPageFiles();
  } else {
    Result<PageFiles> files = LoadPageFiles(options.web_folder);
    if (!files.ok()) return Fail(kExitUsage, files.error());
    parts.files = std::move(*files);
  }
  if (!options.export_path.empty()) {
    return ExportPage(parts.files, {.log = options.log,
                                    .mission_file = options.mission_file,
                                    .path = options.export_path,
                                    .step_s = options.export_step_s});
  }
  parts.outside_tiles = options.outside_tiles;
  if (!options.plan.empty()) return ServePlan(options, std::move(parts));
  return options.log.empty() ? ServeRunningMission(options, std::move(parts))
                             : ServeLog(options, std::move(parts));
}

int RunShoalViewer(int argc, char** argv) {
  return RunViewer(ParseViewerOptionsOrExit(argc, argv));
}

}  // namespace shoal
