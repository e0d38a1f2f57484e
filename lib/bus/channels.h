// Every channel of shoal: its name, its type, who speaks and who listens. docs/channels.md is made
// from the table here (`shoal channels`).
//
// A name is <TOPIC> or <TOPIC>_<VEHICLE>, upper case. A channel with a vehicle's name lives in that
// vehicle's community, one without lives at the shore: that alone decides which LCM port carries it
// in the `communities` layout (lib/bus/layout.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus.h"
#include "lib/routing/control.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/acoustic_rx_t.hpp"
#include "shoal/acoustic_tx_t.hpp"
#include "shoal/actuators_t.hpp"
#include "shoal/appcast_req_t.hpp"
#include "shoal/appcast_t.hpp"
#include "shoal/clock_command_t.hpp"
#include "shoal/clock_state_t.hpp"
#include "shoal/comms_fates_t.hpp"
#include "shoal/comms_pulses_t.hpp"
#include "shoal/comms_rules_req_t.hpp"
#include "shoal/comms_rules_t.hpp"
#include "shoal/desired_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/modem_stats_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/resend_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/step_done_t.hpp"
#include "shoal/swarm_t.hpp"
#include "shoal/tick_t.hpp"
#include "shoal/unc_control_t.hpp"
#include "shoal/unc_controls_req_t.hpp"
#include "shoal/unc_controls_t.hpp"
#include "shoal/water_sample_t.hpp"

namespace shoal {

/// Returns `name` in upper case (ASCII), as channel names write vehicles.
std::string UpperCase(std::string_view name);

namespace channels {

// In a vehicle's community.
Channel<nav_t> Nav(std::string_view vehicle);
Channel<nav_t> MeasuredNav(std::string_view vehicle);
Channel<sonar_t> Sonar(std::string_view vehicle);
Channel<water_sample_t> WaterSample(std::string_view vehicle);
Channel<actuators_t> Actuators(std::string_view vehicle);
Channel<desired_t> Desired(std::string_view vehicle);
Channel<helm_state_t> HelmState(std::string_view vehicle);
Channel<helm_command_t> HelmCommand(std::string_view vehicle);
Channel<sim_command_t> SimCommand(std::string_view vehicle);
Channel<node_report_t> NodeReport(std::string_view vehicle);
Channel<node_message_t> NodeMessage(std::string_view vehicle);
Channel<node_message_t> MediatedMessage(std::string_view vehicle);
Channel<ack_message_t> AckMessageTo(std::string_view vehicle);
Channel<acoustic_rx_t> AcousticRx(std::string_view vehicle);
Channel<swarm_t> Swarm(std::string_view vehicle);

// At the shore.
Channel<helm_command_t> HelmCommandAll();
Channel<node_report_t> NodeReportLocal();
Channel<node_report_t> NodeReportFromOutside();
Channel<node_message_t> NodeMessageLocal();
Channel<node_message_t> NodeMessageFromOutside();
Channel<ack_message_t> AckMessage();
Channel<acoustic_tx_t> AcousticTx();
Channel<unc_control_t> Control(const ControlRow& row);
Channel<unc_controls_t> UncControls();
Channel<unc_controls_req_t> UncControlsReq();
Channel<node_report_t> NodeReportUnc();
Channel<comms_fates_t> CommsFates();
Channel<comms_rules_t> CommsRules();
Channel<comms_rules_t> CommsRulesNow();
Channel<comms_pulses_t> ViewCommsPulse();
Channel<modem_stats_t> ModemStats();
Channel<appcast_t> Appcast();

// On the stepping ports.
Channel<tick_t> Tick();
Channel<resend_t> Resend();
Channel<appcast_req_t> AppcastReq();
Channel<comms_rules_req_t> CommsRulesReq();
Channel<clock_state_t> ClockState();
Channel<step_done_t> StepDone();
Channel<clock_command_t> ClockCommand();

}  // namespace channels

/// Where a channel lives.
enum class ChannelHome { kTickPort, kDonePort, kShore, kVehicle };

/// One row of the channel table; docs and tests read it.
struct ChannelRow {
  std::string_view topic;  ///< Without the vehicle's name.
  ChannelHome home;
  std::string_view type;
  std::string_view said_by;
  std::string_view heard_by;
  std::string_view rate;
  bool logged;             ///< False: made for eyes or for stepping, left out of a mission's log.
  bool is_answer = false;  ///< To a request outside stepping: without effect on the mission.
};

const std::vector<ChannelRow>& ChannelTable();

/// True where a mission's log holds messages of `channel`; unknown channels are logged.
bool IsLogged(std::string_view channel);

/// True where `channel` holds answers to requests outside stepping, as APPCAST does.
bool IsAnswer(std::string_view channel);

}  // namespace shoal
