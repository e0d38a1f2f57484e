// One helm. Subscribes to NAV_<V> and HELM_COMMAND_<V>, publishes ACTUATORS_<V>, DESIRED_<V> and
// HELM_STATE_<V>. See helm --help.
#include "apps/helm/helm_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "helm",
    .purpose = "Guides one vehicle through its tasks: waypoints, loiter, station keeping, return.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[[vehicle]]
name = "alpha"
helm = "shoal"                        # "hand": started by you; "none": not run

[vehicle.helm_options]
nav_timeout_s = 2                     # all-stop when NAV is silent for longer
deploy_at_start = true

[[vehicle.task]]
name = "survey"
kind = "waypoints"
points = [[0, -50], [100, -50], [100, -100]]
speed_mps = 1.5
)",
};

}  // namespace

int RunHelm(int argc, char** argv) {
  return RunVehicleApp(kInfo, argc, argv,
                       [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                         return std::make_unique<HelmApp>(mission, vehicle, bus);
                       });
}

}  // namespace shoal
