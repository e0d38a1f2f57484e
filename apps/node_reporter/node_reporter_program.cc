// One node reporter. Subscribes to NAV_<V> and HELM_STATE_<V>, publishes NODE_REPORT_LOCAL.
// See node_reporter --help.
#include "apps/node_reporter/node_reporter_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "node_reporter",
    .purpose = "Reports the state of one vehicle to the others, by way of the shore.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[[vehicle]]
name = "alpha"
node_reporter = "shoal"               # "hand": started by you; "none": not run

[vehicle.reporter]
rate_hz = 2
blackout_interval_s = 0               # at least this between reports
extrapolate = false                   # true: skip what dead reckoning predicts
extra = { PAYLOAD = "ctd" }           # your own fields
)",
};

}  // namespace

int RunNodeReporter(int argc, char** argv) {
  return RunVehicleApp(kInfo, argc, argv,
                       [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                         return std::make_unique<NodeReporterApp>(mission, vehicle, bus);
                       });
}

}  // namespace shoal
