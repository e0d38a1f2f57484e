// One simulated vehicle. Subscribes to ACTUATORS_<V>, publishes NAV_<V>. See vehicle_sim --help.
#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "vehicle_sim",
    .purpose = "Simulates one vehicle: subscribes to its actuators, publishes its position.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[[vehicle]]
name = "alpha"
model = "surface_craft"
start = { x_m = 0, y_m = -20, heading_deg = 180, speed_mps = 0 }
vehicle_sim = "shoal"                 # "hand": started by you; "none": not run

[vehicle.surface_craft]
turn_rate_degps = 35                  # at full rudder
max_acceleration_mps2 = 0.5
)",
};

}  // namespace

int RunVehicleSim(int argc, char** argv) {
  return RunVehicleApp(kInfo, argc, argv,
                       [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                         return std::make_unique<VehicleSimApp>(mission, vehicle, bus);
                       });
}

}  // namespace shoal
