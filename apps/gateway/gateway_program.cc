// A gateway between media. See gateway --help and --interface.
#include "apps/gateway/gateway_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "gateway",
    .purpose = "Forwards what its vehicle receives by one medium over others.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[[medium]]
name = "vhf"
kind = "radio"
range_m = 3000

[[vehicle]]
name = "buoy"
model = "buoy"
media = ["vhf", "acoustic"]

[vehicle.gateway]
from = ["acoustic"]                   # what comes by these ...
to = ["vhf"]                          # ... goes on over the first of these that can work
queue = 50                            # at most this many wait
rate_hz = 10                          # and this many leave in a second
max_hops = 3
)",
    .misfit = [](const Mission&, const Vehicle& vehicle) -> std::string {
      if (vehicle.media.gateway.exists) return "";
      return vehicle.name + " is not a gateway: it has no [vehicle.gateway]";
    },
};

}  // namespace

int RunGateway(int argc, char** argv) {
  return RunVehicleApp(kInfo, argc, argv,
                       [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                         return std::make_unique<GatewayApp>(mission, vehicle, bus);
                       });
}

}  // namespace shoal
