// The table [netsim].
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/describe.h"
#include "lib/netsim/netsim_options.h"

namespace shoal {
namespace {

constexpr int kMostPort = 65'535;

void Describe(Fields& fields, NetsimEnvironment& environment) {
  fields.Require("name", "name = \"bay\"");
  fields.Text("name", environment.name, {.min_length = 1});
  for (const std::string_view key :
       {"lat_min_deg", "lat_max_deg", "lon_min_deg", "lon_max_deg", "depth_max_m"}) {
    fields.Require(key, std::string(key) + " = 43.8");
  }
  fields.Number("lat_min_deg", environment.lat_min_deg, Between(-90, 90));
  fields.Number("lat_max_deg", environment.lat_max_deg, Between(-90, 90));
  fields.Number("lon_min_deg", environment.lon_min_deg, Between(-360, 360));
  fields.Number("lon_max_deg", environment.lon_max_deg, Between(-360, 360));
  fields.Number("depth_min_m", environment.depth_min_m, Between(-12'000, 12'000));
  fields.Number("depth_max_m", environment.depth_max_m, Between(-12'000, 12'000));
}

void Describe(Fields& fields, NetsimGps& gps) {
  fields.SmallInteger("tcp_port", gps.tcp_port, 0, kMostPort);
  fields.Text("path", gps.path, {.max_length = 1000});
}

void Describe(Fields& fields, NetsimVehicle& vehicle, const Mission& mission) {
  constexpr std::array<std::pair<std::string_view, NetsimModem>, 3> kModems = {{
      {"raw", NetsimModem::kRaw},
      {"micromodem", NetsimModem::kMicromodem},
      {"none", NetsimModem::kNone},
  }};
  fields.Require("name", "name = \"outsider\", a vehicle of the mission");
  fields.Text("name", vehicle.name, {.min_length = 1});
  ResolveVehicle(fields, "name", vehicle.name, mission, false);
  fields.Require("modem_tcp_port", "modem_tcp_port = 62000");
  fields.SmallInteger("modem_tcp_port", vehicle.modem_tcp_port, 1, kMostPort);
  fields.Text("address", vehicle.address, {.min_length = 1});
  fields.Require("environment", "environment = \"bay\"");
  fields.Text("environment", vehicle.environment, {.min_length = 1});
  fields.Choice("modem", vehicle.modem, kModems);
  fields.Inline("gps", [&](Fields& gps) { Describe(gps, vehicle.gps); });
  if (!fields.reading()) return;
  const Vehicle* simulated = mission.FindVehicle(vehicle.name);
  const bool is_elsewhere = simulated == nullptr || (simulated->sim == Provider::kNone &&
                                                     simulated->reporter == Provider::kNone);
  if (!is_elsewhere) {
    fields.Refuse("name",
                  fmt::format("shoal simulates {} itself: write vehicle_sim = \"none\", helm = "
                              "\"none\" and node_reporter = \"none\" in its [[vehicle]]",
                              vehicle.name));
  }
  if (vehicle.modem != NetsimModem::kNone && !mission.acoustics.is_used) {
    fields.Refuse("modem", "a modem talks through the water: write [acoustics] as well");
  }
}

/// Where FindNetsimProblems finds a problem of this table.
std::string WhereOf(std::string_view table, std::string_view name) {
  return fmt::format("netsim.{} '{}'", table, name);
}

void Refuse(Fields& fields, const std::string& where, const std::vector<NetsimProblem>& problems) {
  fields.SkipRest();
  for (const NetsimProblem& problem : problems) {
    if (problem.where != where) continue;
    const std::string key = problem.key == "gps_tcp_port" ? "gps" : problem.key;
    fields.Refuse(key, problem.key + " " + problem.message);
  }
}

}  // namespace

void DescribeNetsim(Fields& file, Mission& mission) {
  if (!file.Has("netsim", mission.netsim.has_value())) return;
  NetsimOptions options = mission.netsim.value_or(NetsimOptions());
  file.Below("netsim", [&](Fields& fields) {
    fields.SmallInteger("port", options.port, 1, kMostPort);
    fields.Text("address", options.address, {.min_length = 1});
    fields.SmallInteger("max_connections", options.max_connections, 1, 10'000);
    fields.SmallInteger("max_line_bytes", options.max_line_bytes, 1024, 64 << 20);
    fields.Number("idle_timeout_s", options.idle_timeout_s, Between(0, 1e9));
    fields.Flag("allow_warp", options.allow_warp);
    fields.List("environment", options.environments,
                [](Fields& table, NetsimEnvironment& each) { Describe(table, each); });
    fields.List("vehicle", options.vehicles,
                [&](Fields& table, NetsimVehicle& each) { Describe(table, each, mission); });
    if (!fields.reading() || !fields.IsSound()) return;
    const std::vector<NetsimProblem> problems = FindNetsimProblems(options);
    if (problems.empty()) return;
    fields.List("environment", options.environments, [&](Fields& table, NetsimEnvironment& each) {
      Refuse(table, WhereOf("environment", each.name), problems);
    });
    fields.List("vehicle", options.vehicles, [&](Fields& table, NetsimVehicle& each) {
      Refuse(table, WhereOf("vehicle", each.name), problems);
    });
    Refuse(fields, "netsim", problems);
  });
  if (file.reading()) mission.netsim = options;
}

}  // namespace shoal
