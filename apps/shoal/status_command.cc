#include "apps/shoal/status_command.h"

#include <fmt/format.h>

#include <map>

#include "lib/base/check/result.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/lcm_bus.h"
#include "lib/run/run/appcast.h"
#include "lib/run/run/run_app.h"
#include "lib/run/run/run_registry.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// Answers come within a millisecond; a busy machine may need longer. Collecting ends after this
/// long without a further page.
constexpr int64_t kQuiet_us = 300'000;
constexpr int64_t kPagePatience_us = 2'000'000;
constexpr int64_t kRequestInterval_us = 150'000;
constexpr int kRequestsOfAll = 2;

}  // namespace

Result<std::map<std::string, appcast_t>> CollectPages(const PortPlan& ports,
                                                      const std::string& app) {
  LcmBus bus(ports);
  std::map<std::string, appcast_t> pages;
  int64_t last = MonotonicMicroseconds();
  Subscribe(bus, channels::Appcast(), [&](const appcast_t& page) {
    pages[page.app] = page;
    last = MonotonicMicroseconds();
  });
  appcast_req_t request{};
  request.app = app;
  const int64_t begin = last;
  int64_t next_request = begin;
  int num_requests = 0;
  while (true) {
    const int64_t now = MonotonicMicroseconds();
    // A participant that has just answered another request ignores this one, so it is repeated.
    const bool is_complete = app != "all" ? pages.contains(app) : num_requests >= kRequestsOfAll;
    if (!is_complete && now >= next_request) {
      Publish(bus, channels::AppcastReq(), request);
      if (!bus.error().empty()) return Error{bus.error()};
      next_request = now + kRequestInterval_us;
      ++num_requests;
    }
    const int64_t patience = pages.empty() ? kPagePatience_us : kQuiet_us;
    if (now - last > patience || now - begin > 2 * kPagePatience_us) break;
    if (app != "all" && pages.contains(app)) break;
    bus.Poll(20'000);
  }
  return pages;
}

int RunStatus(const StatusOptions& options) {
  const Result<RunningMission> mission = FindRunningMission(options.port_base);
  if (!mission.ok()) {
    fmt::print(stderr, "shoal: {}\n", mission.error());
    return kExitEnvironment;
  }
  const bool one_line_each = options.app.empty();
  const std::string wanted = one_line_each ? "all" : options.app;
  for (const std::string& vehicle : mission->vehicles) {
    if (wanted == vehicle) {
      fmt::print(stderr,
                 "shoal: {0} is a vehicle; ask for helm_{0}, vehicle_sim_{0}, "
                 "node_reporter_{0} or, in a swarm, acomms_{0}\n",
                 vehicle);
      return kExitUsage;
    }
  }
  const auto collected = CollectPages(mission->Ports(), wanted);
  if (!collected.ok()) {
    fmt::print(stderr, "shoal: {}\n", collected.error());
    return kExitEnvironment;
  }
  const std::map<std::string, appcast_t>& pages = *collected;
  if (pages.empty()) {
    fmt::print(stderr,
               "shoal: no answer from {} of {}; `shoal status` without a name lists all "
               "participants\n",
               wanted, Describe(*mission));
    return kExitEnvironment;
  }
  fmt::print("{}, {} layout, grouping {}\n\n", Describe(*mission), Name(mission->layout),
             mission->grouping);
  if (!one_line_each) {
    for (const auto& [name, page] : pages) {
      fmt::print("{}\n", TerminalText(Format(PageOf(page), name, page.step)));
    }
    return kExitOk;
  }
  fmt::print("{:<32} {:>9} {:>8}  warnings (config/run)\n", "participant", "time [s]", "step");
  for (const auto& [name, page] : pages) {
    fmt::print("{:<32} {:>9.1f} {:>8}  {}/{}\n", TerminalLine(name), Seconds(page.utime), page.step,
               page.num_config_warnings, page.num_run_warnings);
    for (const std::string& warning : page.run_warnings) {
      fmt::print("    {}\n", TerminalLine(warning));
    }
  }
  return kExitOk;
}

Result<std::string> UrlOf(int port_base, const std::string& vehicle) {
  const Result<RunningMission> mission = FindRunningMission(port_base);
  if (!mission.ok()) return Error{mission.error()};
  const PortPlan ports = mission->Ports();
  if (vehicle.empty()) return LcmUrl(ports.shore_port());
  for (const std::string& name : mission->vehicles) {
    if (UpperCase(name) == UpperCase(vehicle)) {
      return LcmUrl(ports.PortOf(channels::Nav(vehicle).name));
    }
  }
  return Error{fmt::format("no vehicle '{}' in {}; it has: {}", vehicle, mission->name,
                           fmt::join(mission->vehicles, ", "))};
}

int RunUrl(int port_base, const std::string& vehicle) {
  const Result<std::string> url = UrlOf(port_base, vehicle);
  if (!url.ok()) {
    fmt::print(stderr, "shoal: {}\n", url.error());
    return url.error().starts_with("no vehicle") ? kExitUsage : kExitEnvironment;
  }
  fmt::print("{}\n", *url);
  return kExitOk;
}

}  // namespace shoal
