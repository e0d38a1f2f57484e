// The broker at the shore. See shore_broker --help and --interface.
#include "apps/shore_broker/shore_broker_app.h"
#include "lib/run/run_app.h"

namespace {

const shoal::AppInfo kInfo = {
    .name = "shore_broker",
    .purpose = "Decides who hears whose node reports, messages and acoustic packets, and says why.",
    .per_vehicle = false,
    .can_live = true,
    .example = R"(# In a mission file:
[comms]
comms_range = 100                     # metres; "nolimit": everywhere. These are the defaults.
critical_range = 30                   # metres; closer than this, reports get through anyway
stale_time = 5                        # seconds; a vehicle silent for longer hears nothing
stale_forget_s = 100                  # seconds; 20 x stale_time

max_msg_length = 1000                 # bytes of a message's text; 0: no limit
min_msg_interval = 30                 # seconds between two messages of a vehicle
min_rpt_interval = -1                 # seconds between two reports from one to another; -1: off

groups = false                        # true: reports only within a group
msg_groups = false                    # true: messages only within a group
ignore_group = ""                     # reports of this group are ignored
drop_percentage = 0                   # 0 to 100: lost at random

shared_node_reports = false           # true, or seconds: repeat reports on NODE_REPORT_UNC
pulse_duration = 10                   # seconds
view_node_rpt_pulses = true           # pulses of reports, not only of messages
msg_color = "white"
msg_repeat_color = "light_green"

reports_over = "direct"               # "acoustic": through the acoustic network
messages_over = "direct"

[acoustics]                           # docs/mission_file.md has all keys
crc = true                            # false: damage is delivered
access_mode = "fdma"                  # or shared, tdma, tdma_lf
data_rate_bps = 1000
packet_loss = 0.02                    # at nominal_distance_m = 1000
bit_error_rate = 0.001

[[vehicle]]
name = "alpha"
stealth = 0.8                         # 0 to 1: heard within comms_range x stealth
earange = 4.5                         # 1 to 10: hears within comms_range x earange
)",
};

}  // namespace

int main(int argc, char** argv) {
  return shoal::RunMissionApp(kInfo, argc, argv, [](const auto& mission, auto& bus, const auto&) {
    return std::make_unique<shoal::ShoreBrokerApp>(mission, bus);
  });
}
