// The table [netsim].
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "lib/mission/file/describe.h"
#include "lib/mission/netsim/netsim_options.h"

namespace shoal {
namespace {

constexpr int kMaxPort = 65'535;

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
  fields.SmallInteger("tcp_port", gps.tcp_port, 0, kMaxPort);
  fields.Text("path", gps.path, {.max_length = 1000});
}

void Describe(Fields& fields, NetsimVehicle& vehicle) {
  constexpr std::array<std::pair<std::string_view, NetsimModem>, 4> kModems = {{
      {"raw", NetsimModem::kRaw},
      {"micromodem", NetsimModem::kMicromodem},
      {"micromodem2", NetsimModem::kMicromodem2},
      {"none", NetsimModem::kNone},
  }};
  fields.Require("name", "name = \"outsider\", a vehicle of the mission");
  fields.Text("name", vehicle.name, {.min_length = 1});
  fields.Require("modem_tcp_port", "modem_tcp_port = 62000");
  fields.SmallInteger("modem_tcp_port", vehicle.modem_tcp_port, 1, kMaxPort);
  fields.Text("address", vehicle.address, {.min_length = 1});
  fields.Require("environment", "environment = \"bay\"");
  fields.Text("environment", vehicle.environment, {.min_length = 1});
  fields.Choice("modem", vehicle.modem, kModems);
  fields.Inline("gps", [&](Fields& gps) { Describe(gps, vehicle.gps); });
}

}  // namespace

void Describe(Fields& fields, NetsimOptions& options) {
  fields.SmallInteger("port", options.port, 1, kMaxPort);
  fields.Text("address", options.address, {.min_length = 1});
  fields.SmallInteger("max_connections", options.max_connections, 1, 10'000);
  fields.SmallInteger("max_line_bytes", options.max_line_bytes, 1024, 64 << 20);
  fields.Number("idle_timeout_s", options.idle_timeout_s, Between(0, 1e9));
  fields.Flag("allow_warp", options.allow_warp);
  fields.List("environment", options.environments,
              [](Fields& table, NetsimEnvironment& each) { Describe(table, each); });
  fields.List("vehicle", options.vehicles,
              [](Fields& table, NetsimVehicle& each) { Describe(table, each); });
}

}  // namespace shoal
