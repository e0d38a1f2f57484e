// The broker at the shore. See shore_broker --help and --interface.
#include "apps/shore_broker/shore_broker_app.h"
#include "lib/run/broker/comms_example.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "shore_broker",
    .purpose =
        "Decides which vehicle receives which node reports, messages and acoustic packets, and "
        "why.",
    .per_vehicle = false,
    .can_live = true,
    .example = "# In a mission file. These are the defaults.\n" + CommsExample() + R"(
[acoustics]                           # docs/missions/mission_file.md has all keys
crc = true                            # false: damage is delivered
access_mode = "fdma"                  # or shared, tdma, tdma_lf
data_rate_bps = 1000
packet_loss = 0.02                    # at nominal_distance_m = 1000
bit_error_rate = 0.001

[[vehicle]]
name = "alpha"
stealth = 0.8                         # 0 to 1: received within comms_range x stealth
earange = 4.5                         # 1 to 10: receives within comms_range x earange
)",
};

}  // namespace

int RunShoreBroker(int argc, char** argv) {
  return RunMissionApp(kInfo, argc, argv, [](const auto& mission, auto& bus, const auto&) {
    return std::make_unique<ShoreBrokerApp>(mission, bus);
  });
}

}  // namespace shoal
