// One vehicle's acoustic messages. Subscribes to ACOUSTIC_RX_<V>, publishes ACOUSTIC_TX and
// SWARM_<V> and ACOMMS_<V>. See acomms --help.
#include "apps/acomms/acomms_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "acomms",
    .purpose =
        "Sends and receives the messages of one vehicle of a swarm over the acoustic network.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[acoustics]
access_mode = "fdma"                  # a channel for each vehicle

[swarm]
leader = "alpha"                      # the target of the followers' target_track tasks
episode_s = 5                         # each member sends once per episode
frames = false                        # true: a sequence number and a checksum with each message

[[vehicle]]
name = "bravo"
model = "remus100"
acomms = "shoal"                      # "hand": started by you; "none": not run

[[vehicle.task]]
kind = "target_track"
target = "alpha"
swarm = "acoustic"

[vehicle.recovery]
reporter_pos = ["predict", "previous"]
)",
    .misfit = [](const Mission& mission, const Vehicle& vehicle) -> std::string {
      if (mission.SwarmOf(vehicle) != nullptr) return "";
      return vehicle.name + " is neither the leader nor a follower of [swarm]";
    },
};

}  // namespace

int RunAcomms(int argc, char** argv) {
  return RunVehicleApp(kInfo, argc, argv,
                       [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                         return std::make_unique<AcommsApp>(mission, vehicle, bus);
                       });
}

}  // namespace shoal
