// netsim's TCP interface. Subscribes to ACOUSTIC_RX_<V> and COMMS_FATES, publishes NODE_REPORT,
// MODEM_TX and MODEM_STATS. See netsim_manager --help.
#include "apps/netsim_manager/netsim_manager_app.h"
#include "lib/run/run/run_app.h"

namespace shoal {

namespace {

const AppInfo kInfo = {
    .name = "netsim_manager",
    .purpose =
        "Lets vehicle simulators and modems from outside take part, over netsim's TCP "
        "interface.",
    .per_vehicle = false,
    .example = R"(# In a mission file:
[[vehicle]]
name = "outsider"
outside = true                        # it is simulated elsewhere

[netsim]
port = 61999                          # of NETSIM|...| lines
address = "127.0.0.1"                 # "0.0.0.0": other machines may connect too

[[netsim.environment]]
name = "bay"
lat_min_deg = 43.80
lat_max_deg = 43.85
lon_min_deg = -70.36
lon_max_deg = -70.30
depth_max_m = 100

[[netsim.vehicle]]
name = "outsider"
modem_tcp_port = 62000
environment = "bay"
modem = "micromodem"                  # or "micromodem2", "raw", "none"
)",
};

}  // namespace

int RunNetsimManager(int argc, char** argv) {
  return RunMissionApp(kInfo, argc, argv, [](const auto& mission, auto& bus, const auto&) {
    return std::make_unique<NetsimManagerApp>(mission, bus);
  });
}

}  // namespace shoal
