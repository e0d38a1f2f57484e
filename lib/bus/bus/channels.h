// Every channel of shoal: its name, its type, which apps publish it and which subscribe to it.
// docs/reference/channels.md is made from the table here (`shoal channels`).
//
// A name is <TOPIC> or <TOPIC>_<VEHICLE>, upper case. A channel with a vehicle's name lives in that
// vehicle's community, one without lives at the shore: that alone decides which LCM port carries it
// in the `communities` layout (lib/bus/bus/layout.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/fate_columns.h"
#include "lib/bus/bus/pulse_columns.h"
#include "lib/comms/routing/control.h"
#include "shoal/ack_message_t.hpp"
#include "shoal/acomms_t.hpp"
#include "shoal/acoustic_rx_on_t.hpp"
#include "shoal/acoustic_rx_t.hpp"
#include "shoal/acoustic_tx_on_t.hpp"
#include "shoal/acoustic_tx_t.hpp"
#include "shoal/actuators_t.hpp"
#include "shoal/appcast_req_t.hpp"
#include "shoal/appcast_t.hpp"
#include "shoal/broker_rules_t.hpp"
#include "shoal/clock_command_t.hpp"
#include "shoal/clock_state_t.hpp"
#include "shoal/comms_arrivals_t.hpp"
#include "shoal/comms_media_t.hpp"
#include "shoal/comms_rules_req_t.hpp"
#include "shoal/desired_t.hpp"
#include "shoal/guidance_t.hpp"
#include "shoal/helm_command_t.hpp"
#include "shoal/helm_decision_t.hpp"
#include "shoal/helm_state_t.hpp"
#include "shoal/modem_stats_t.hpp"
#include "shoal/modem_tx_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/navigation_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/relay_t.hpp"
#include "shoal/resend_t.hpp"
#include "shoal/sim_command_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/step_done_t.hpp"
#include "shoal/step_dones_t.hpp"
#include "shoal/swarm_t.hpp"
#include "shoal/tick_t.hpp"
#include "shoal/unc_control_t.hpp"
#include "shoal/unc_controls_req_t.hpp"
#include "shoal/unc_controls_t.hpp"
#include "shoal/view_circle_t.hpp"
#include "shoal/view_point_t.hpp"
#include "shoal/view_polygon_t.hpp"
#include "shoal/view_seglist_t.hpp"
#include "shoal/view_text_t.hpp"
#include "shoal/water_sample_t.hpp"

namespace shoal {

/// Names of channels without the vehicle's. They stand nowhere else in the code
/// (tests/house_test.cc sees to it), but for those of the broker's rules, which ControlTable() has.
namespace topics {
inline constexpr std::string_view kNav = "NAV";
inline constexpr std::string_view kMeasuredNav = "MEASURED_NAV";
inline constexpr std::string_view kEstimatedNav = "ESTIMATED_NAV";
inline constexpr std::string_view kNavigation = "NAVIGATION";
inline constexpr std::string_view kSonar = "SONAR";
inline constexpr std::string_view kWaterSample = "WATER_SAMPLE";
inline constexpr std::string_view kActuators = "ACTUATORS";
inline constexpr std::string_view kDesired = "DESIRED";
inline constexpr std::string_view kHelmState = "HELM_STATE";
inline constexpr std::string_view kGuidance = "GUIDANCE";
inline constexpr std::string_view kHelmDecision = "HELM_DECISION";
inline constexpr std::string_view kHelmCommand = "HELM_COMMAND";
inline constexpr std::string_view kSimCommand = "SIM_COMMAND";
inline constexpr std::string_view kNodeReport = "NODE_REPORT";
inline constexpr std::string_view kNodeMessage = "NODE_MESSAGE";
inline constexpr std::string_view kMediatedMessage = "MEDIATED_MESSAGE";
inline constexpr std::string_view kAckMessage = "ACK_MESSAGE";
inline constexpr std::string_view kAcousticRx = "ACOUSTIC_RX";
inline constexpr std::string_view kAcousticRxOn = "ACOUSTIC_RX_ON";
inline constexpr std::string_view kSwarm = "SWARM";
inline constexpr std::string_view kRelayRx = "RELAY_RX";
inline constexpr std::string_view kAcomms = "ACOMMS";
inline constexpr std::string_view kNodeReportLocal = "NODE_REPORT_LOCAL";
inline constexpr std::string_view kNodeMessageLocal = "NODE_MESSAGE_LOCAL";
inline constexpr std::string_view kAcousticTx = "ACOUSTIC_TX";
inline constexpr std::string_view kAcousticTxOn = "ACOUSTIC_TX_ON";
inline constexpr std::string_view kModemTx = "MODEM_TX";
inline constexpr std::string_view kRelayTx = "RELAY_TX";
inline constexpr std::string_view kUncControls = "UNC_CONTROLS";
inline constexpr std::string_view kUncControlsReq = "UNC_CONTROLS_REQ";
inline constexpr std::string_view kNodeReportUnc = "NODE_REPORT_UNC";
inline constexpr std::string_view kCommsFates = "COMMS_FATES";
inline constexpr std::string_view kCommsMedia = "COMMS_MEDIA";
inline constexpr std::string_view kCommsArrivals = "COMMS_ARRIVALS";
inline constexpr std::string_view kCommsRules = "COMMS_RULES";
inline constexpr std::string_view kViewCommsPulse = "VIEW_COMMS_PULSE";
inline constexpr std::string_view kViewPoint = "VIEW_POINT";
inline constexpr std::string_view kViewPolygon = "VIEW_POLYGON";
inline constexpr std::string_view kViewSeglist = "VIEW_SEGLIST";
inline constexpr std::string_view kViewCircle = "VIEW_CIRCLE";
inline constexpr std::string_view kViewText = "VIEW_TEXT";
inline constexpr std::string_view kModemStats = "MODEM_STATS";
inline constexpr std::string_view kAppcast = "APPCAST";
inline constexpr std::string_view kCommsRulesNow = "COMMS_RULES_NOW";
inline constexpr std::string_view kCommsRulesReq = "COMMS_RULES_REQ";
inline constexpr std::string_view kTick = "TICK";
inline constexpr std::string_view kResend = "RESEND";
inline constexpr std::string_view kAppcastReq = "APPCAST_REQ";
inline constexpr std::string_view kClockState = "CLOCK_STATE";
inline constexpr std::string_view kStepDone = "STEP_DONE";
inline constexpr std::string_view kStepDones = "STEP_DONES";
inline constexpr std::string_view kClockCommand = "CLOCK_COMMAND";
}  // namespace topics

/// Returns the vehicle, in upper case, where `channel` is that of `topic` for one vehicle ("ALPHA"
/// of NAV_ALPHA for kNav); empty for all others, NODE_REPORT_LOCAL and NODE_REPORT_UNC included.
std::string_view VehicleOfChannel(std::string_view channel, std::string_view topic);

namespace channels {

// In a vehicle's community.
Channel<nav_t> Nav(std::string_view vehicle);
Channel<nav_t> MeasuredNav(std::string_view vehicle);
Channel<nav_t> EstimatedNav(std::string_view vehicle);
Channel<navigation_t> Navigation(std::string_view vehicle);
Channel<sonar_t> Sonar(std::string_view vehicle);
Channel<water_sample_t> WaterSample(std::string_view vehicle);
Channel<actuators_t> Actuators(std::string_view vehicle);
Channel<desired_t> Desired(std::string_view vehicle);
Channel<helm_state_t> HelmState(std::string_view vehicle);
Channel<guidance_t> Guidance(std::string_view vehicle);
Channel<helm_decision_t> HelmDecision(std::string_view vehicle);
Channel<helm_command_t> HelmCommand(std::string_view vehicle);
Channel<sim_command_t> SimCommand(std::string_view vehicle);
Channel<node_report_t> NodeReport(std::string_view vehicle);
Channel<node_message_t> NodeMessage(std::string_view vehicle);
Channel<node_message_t> MediatedMessage(std::string_view vehicle);
Channel<ack_message_t> AckMessageTo(std::string_view vehicle);
Channel<acoustic_rx_t> AcousticRx(std::string_view vehicle);
Channel<acoustic_rx_on_t> AcousticRxOn(std::string_view vehicle);
Channel<swarm_t> Swarm(std::string_view vehicle);
Channel<relay_t> RelayRx(std::string_view vehicle);
Channel<acomms_t> Acomms(std::string_view vehicle);

// At the shore.
Channel<helm_command_t> HelmCommandAll();
Channel<node_report_t> NodeReportLocal();
Channel<node_report_t> NodeReportFromOutside();
Channel<node_message_t> NodeMessageLocal();
Channel<node_message_t> NodeMessageFromOutside();
Channel<ack_message_t> AckMessage();
Channel<acoustic_tx_t> AcousticTx();
Channel<acoustic_tx_on_t> AcousticTxOn();
Channel<modem_tx_t> ModemTx();
Channel<relay_t> RelayTx();
Channel<unc_control_t> Control(const ControlRow& row);
Channel<unc_controls_t> UncControls();
Channel<unc_controls_req_t> UncControlsReq();
Channel<node_report_t> NodeReportUnc();
Channel<comms_fates_t> CommsFates();               ///< To subscribe to: lib/bus/bus/fate_columns.h.
Channel<comms_fate_columns_t> CommsFateColumns();  ///< The same, to publish.
Channel<comms_media_t> CommsMedia();
Channel<comms_arrivals_t> CommsArrivals();
Channel<broker_rules_t> CommsRules();
Channel<broker_rules_t> CommsRulesNow();
Channel<comms_pulses_t> ViewCommsPulse();  ///< To subscribe to: lib/bus/bus/pulse_columns.h.
Channel<comms_pulse_columns_t> ViewCommsPulseColumns();  ///< The same, to publish.
Channel<view_point_t> ViewPoint();
Channel<view_polygon_t> ViewPolygon();
Channel<view_seglist_t> ViewSeglist();
Channel<view_circle_t> ViewCircle();
Channel<view_text_t> ViewText();
Channel<modem_stats_t> ModemStats();
Channel<appcast_t> Appcast();

// On the stepping ports.
Channel<tick_t> Tick();
Channel<resend_t> Resend();
Channel<appcast_req_t> AppcastReq();
Channel<comms_rules_req_t> CommsRulesReq();
Channel<clock_state_t> ClockState();
Channel<step_done_t> StepDone();
Channel<step_dones_t> StepDones();
Channel<clock_command_t> ClockCommand();

}  // namespace channels

/// Where a channel lives.
enum class ChannelHome { kTickPort, kDonePort, kShore, kVehicle };

/// One row of the channel table; docs and tests read it.
struct ChannelRow {
  std::string_view topic;  ///< Without the vehicle's name.
  ChannelHome home;
  std::string_view type;
  std::string_view publishers;
  std::string_view subscribers;
  std::string_view rate;
  bool logged;  ///< False: made for display or for stepping, left out of a mission's log.
  bool is_answer = false;  ///< To a request outside stepping: without effect on the mission.
};

const std::vector<ChannelRow>& ChannelTable();

/// True where a mission's log holds messages of `channel`; unknown channels are logged.
bool IsLogged(std::string_view channel);

/// True where `channel` holds answers to requests outside stepping, as APPCAST does.
bool IsAnswer(std::string_view channel);

}  // namespace shoal
