// One vehicle's acoustic messages. Hears ACOUSTIC_RX_<V>, says ACOUSTIC_TX and SWARM_<V>.
// See acomms --help.
#include "apps/acomms/acomms_app.h"
#include "lib/run/run_app.h"

namespace {

const shoal::AppInfo kInfo = {
    .name = "acomms",
    .purpose = "Speaks and hears for one vehicle of a swarm, through the acoustic network.",
    .per_vehicle = true,
    .example = R"(# In a mission file:
[acoustics]
access_mode = "fdma"                  # a channel for each vehicle

[swarm]
leader = "alpha"                      # whom the followers' target_track tasks name
episode_s = 5                         # each speaks once in so many seconds
frames = false                        # true: a sequence number and a checksum with each message

[[vehicle]]
name = "bravo"
model = "remus100"
acomms = "shoal"                      # "hand": started by you; "none": nobody

[[vehicle.task]]
kind = "target_track"
target = "alpha"
swarm = "acoustic"

[vehicle.recovery]
reporter_pos = ["predict", "previous"]
)",
    .misfit = [](const shoal::Mission& mission, const shoal::Vehicle& vehicle) -> std::string {
      if (mission.IsInSwarm(vehicle)) return "";
      return vehicle.name + " is neither the leader nor a follower of [swarm]";
    },
};

}  // namespace

int main(int argc, char** argv) {
  return shoal::RunVehicleApp(kInfo, argc, argv,
                              [](const auto& mission, const auto& vehicle, auto& bus, const auto&) {
                                return std::make_unique<shoal::AcommsApp>(mission, vehicle, bus);
                              });
}
