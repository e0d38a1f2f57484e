// The broker at the shore. Hears NODE_REPORT_LOCAL, says NODE_REPORT_<V> and COMMS_FATES. See
// shore_broker --help.
#include "apps/shore_broker/shore_broker_app.h"
#include "lib/run/run_app.h"

namespace {

const shoal::AppInfo kInfo = {
    .name = "shore_broker",
    .purpose = "Decides who hears whose node reports, and says why.",
    .per_vehicle = false,
    .example = R"(# In a mission file:
[comms]
comms_range = 250                     # metres; negative: no limit
stale_time = 5                        # seconds; a vehicle silent for longer hears nothing
stale_forget_s = 100
)",
};

}  // namespace

int main(int argc, char** argv) {
  return shoal::RunMissionApp(kInfo, argc, argv, [](const auto& mission, auto& bus, const auto&) {
    return std::make_unique<shoal::ShoreBrokerApp>(mission, bus);
  });
}
