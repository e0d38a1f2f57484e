#include "lib/bus/bus/channels.h"

#include <algorithm>

#include "lib/base/text/letters.h"

namespace shoal {

std::string_view VehicleOfChannel(std::string_view channel, std::string_view topic) {
  const size_t begin = topic.size() + 1;
  if (channel.size() <= begin || !channel.starts_with(topic) || channel[topic.size()] != '_') {
    return {};
  }
  const bool is_topic = std::any_of(ChannelTable().begin(), ChannelTable().end(),
                                    [&](const ChannelRow& row) { return row.topic == channel; });
  return is_topic ? std::string_view() : channel.substr(begin);
}

namespace channels {
namespace {
std::string Of(std::string_view topic, std::string_view vehicle) {
  return std::string(topic) + "_" + UpperCase(vehicle);
}
}  // namespace

Channel<nav_t> Nav(std::string_view vehicle) { return {Of(topics::kNav, vehicle)}; }
Channel<nav_t> MeasuredNav(std::string_view vehicle) { return {Of(topics::kMeasuredNav, vehicle)}; }
Channel<nav_t> EstimatedNav(std::string_view vehicle) {
  return {Of(topics::kEstimatedNav, vehicle)};
}
Channel<navigation_t> Navigation(std::string_view vehicle) {
  return {Of(topics::kNavigation, vehicle)};
}
Channel<sonar_t> Sonar(std::string_view vehicle) { return {Of(topics::kSonar, vehicle)}; }
Channel<water_sample_t> WaterSample(std::string_view vehicle) {
  return {Of(topics::kWaterSample, vehicle)};
}
Channel<actuators_t> Actuators(std::string_view vehicle) {
  return {Of(topics::kActuators, vehicle)};
}
Channel<desired_t> Desired(std::string_view vehicle) { return {Of(topics::kDesired, vehicle)}; }
Channel<helm_state_t> HelmState(std::string_view vehicle) {
  return {Of(topics::kHelmState, vehicle)};
}
Channel<guidance_t> Guidance(std::string_view vehicle) { return {Of(topics::kGuidance, vehicle)}; }
Channel<helm_decision_t> HelmDecision(std::string_view vehicle) {
  return {Of(topics::kHelmDecision, vehicle)};
}
Channel<helm_command_t> HelmCommand(std::string_view vehicle) {
  return {Of(topics::kHelmCommand, vehicle)};
}
Channel<sim_command_t> SimCommand(std::string_view vehicle) {
  return {Of(topics::kSimCommand, vehicle)};
}
Channel<node_report_t> NodeReport(std::string_view vehicle) {
  return {Of(topics::kNodeReport, vehicle)};
}
Channel<node_message_t> NodeMessage(std::string_view vehicle) {
  return {Of(topics::kNodeMessage, vehicle)};
}
Channel<node_message_t> MediatedMessage(std::string_view vehicle) {
  return {Of(topics::kMediatedMessage, vehicle)};
}
Channel<ack_message_t> AckMessageTo(std::string_view vehicle) {
  return {Of(topics::kAckMessage, vehicle)};
}
Channel<acoustic_rx_t> AcousticRx(std::string_view vehicle) {
  return {Of(topics::kAcousticRx, vehicle)};
}
Channel<acoustic_rx_on_t> AcousticRxOn(std::string_view vehicle) {
  return {Of(topics::kAcousticRxOn, vehicle)};
}
Channel<swarm_t> Swarm(std::string_view vehicle) { return {Of(topics::kSwarm, vehicle)}; }
Channel<relay_t> RelayRx(std::string_view vehicle) { return {Of(topics::kRelayRx, vehicle)}; }
Channel<acomms_t> Acomms(std::string_view vehicle) { return {Of(topics::kAcomms, vehicle)}; }

Channel<helm_command_t> HelmCommandAll() { return {std::string(topics::kHelmCommand)}; }
Channel<node_report_t> NodeReportLocal() { return {std::string(topics::kNodeReportLocal)}; }
Channel<node_report_t> NodeReportFromOutside() { return {std::string(topics::kNodeReport)}; }
Channel<node_message_t> NodeMessageLocal() { return {std::string(topics::kNodeMessageLocal)}; }
Channel<node_message_t> NodeMessageFromOutside() { return {std::string(topics::kNodeMessage)}; }
Channel<ack_message_t> AckMessage() { return {std::string(topics::kAckMessage)}; }
Channel<acoustic_tx_t> AcousticTx() { return {std::string(topics::kAcousticTx)}; }
Channel<acoustic_tx_on_t> AcousticTxOn() { return {std::string(topics::kAcousticTxOn)}; }
Channel<modem_tx_t> ModemTx() { return {std::string(topics::kModemTx)}; }
Channel<relay_t> RelayTx() { return {std::string(topics::kRelayTx)}; }
Channel<unc_control_t> Control(const ControlRow& row) { return {std::string(row.channel)}; }
Channel<unc_controls_t> UncControls() { return {std::string(topics::kUncControls)}; }
Channel<unc_controls_req_t> UncControlsReq() { return {std::string(topics::kUncControlsReq)}; }
Channel<node_report_t> NodeReportUnc() { return {std::string(topics::kNodeReportUnc)}; }
Channel<comms_fates_t> CommsFates() { return {std::string(topics::kCommsFates)}; }
Channel<comms_fate_columns_t> CommsFateColumns() { return {std::string(topics::kCommsFates)}; }
Channel<comms_media_t> CommsMedia() { return {std::string(topics::kCommsMedia)}; }
Channel<comms_arrivals_t> CommsArrivals() { return {std::string(topics::kCommsArrivals)}; }
Channel<broker_rules_t> CommsRules() { return {std::string(topics::kCommsRules)}; }
Channel<broker_rules_t> CommsRulesNow() { return {std::string(topics::kCommsRulesNow)}; }
Channel<comms_pulses_t> ViewCommsPulse() { return {std::string(topics::kViewCommsPulse)}; }
Channel<comms_pulse_columns_t> ViewCommsPulseColumns() {
  return {std::string(topics::kViewCommsPulse)};
}
Channel<view_point_t> ViewPoint() { return {std::string(topics::kViewPoint)}; }
Channel<view_polygon_t> ViewPolygon() { return {std::string(topics::kViewPolygon)}; }
Channel<view_seglist_t> ViewSeglist() { return {std::string(topics::kViewSeglist)}; }
Channel<view_circle_t> ViewCircle() { return {std::string(topics::kViewCircle)}; }
Channel<view_text_t> ViewText() { return {std::string(topics::kViewText)}; }
Channel<modem_stats_t> ModemStats() { return {std::string(topics::kModemStats)}; }
Channel<appcast_t> Appcast() { return {std::string(topics::kAppcast)}; }

Channel<tick_t> Tick() { return {std::string(topics::kTick)}; }
Channel<resend_t> Resend() { return {std::string(topics::kResend)}; }
Channel<appcast_req_t> AppcastReq() { return {std::string(topics::kAppcastReq)}; }
Channel<comms_rules_req_t> CommsRulesReq() { return {std::string(topics::kCommsRulesReq)}; }
Channel<clock_state_t> ClockState() { return {std::string(topics::kClockState)}; }
Channel<step_done_t> StepDone() { return {std::string(topics::kStepDone)}; }
Channel<step_dones_t> StepDones() { return {std::string(topics::kStepDones)}; }
Channel<clock_command_t> ClockCommand() { return {std::string(topics::kClockCommand)}; }

}  // namespace channels

namespace {

std::vector<ChannelRow> MakeTable() {
  using enum ChannelHome;
  std::vector<ChannelRow> table = {
      {topics::kNav, kVehicle, "nav_t", "vehicle_sim",
       "helm, node_reporter, acomms, vehicle_sim of others, shore_broker, shoal, viewer",
       "every step", true},
      {topics::kMeasuredNav, kVehicle, "nav_t", "vehicle_sim", "helm, node_reporter, acomms",
       "every step, with [vehicle.sensors]", true},
      {topics::kEstimatedNav, kVehicle, "nav_t", "vehicle_sim",
       "helm, node_reporter, acomms, shoal", "every step, with [vehicle.navigation]", true},
      {topics::kNavigation, kVehicle, "navigation_t", "vehicle_sim", "helm, node_reporter, viewer",
       "[vehicle.navigation] report_every_s", true},
      {topics::kSonar, kVehicle, "sonar_t", "vehicle_sim", "helm", "[vehicle.sonar] rate_hz", true},
      {topics::kWaterSample, kVehicle, "water_sample_t", "vehicle_sim", "your programs",
       "every step, with [environment.plume]", true},
      {topics::kActuators, kVehicle, "actuators_t", "helm", "vehicle_sim, acomms", "every step",
       true},
      {topics::kDesired, kVehicle, "desired_t", "helm", "viewer, (people)", "every step", true},
      {topics::kHelmState, kVehicle, "helm_state_t", "helm", "node_reporter, acomms, shoal, viewer",
       "on change, at least 1 Hz", true},
      {topics::kGuidance, kVehicle, "guidance_t", "helm", "viewer, (people)",
       "under water: on change of waypoint, at least 1 Hz", true},
      {topics::kHelmDecision, kVehicle, "helm_decision_t", "helm", "viewer, (people)",
       "with behaviors: on change, at least 1 Hz", true},
      {topics::kHelmCommand, kVehicle, "helm_command_t",
       "shoal (events), shoal send, shore_broker, vehicle_sim (collision)", "helm, viewer",
       "when needed", true},
      {topics::kSimCommand, kVehicle, "sim_command_t", "shoal (events), shoal send", "vehicle_sim",
       "when needed", true},
      {topics::kNodeReport, kVehicle, "node_report_t", "shore_broker", "helm",
       "one per report that got through", true},
      {topics::kNodeMessage, kVehicle, "node_message_t", "shore_broker",
       "helm, node_reporter, your programs", "one per message that got through", true},
      {topics::kAckMessage, kVehicle, "ack_message_t", "shore_broker",
       "node_reporter, your programs", "one per ack that got through", true},
      {topics::kAcousticRx, kVehicle, "acoustic_rx_t", "shore_broker",
       "acomms, netsim_manager, vehicle_sim, your programs", "one per packet that arrived", true},
      {topics::kAcousticRxOn, kVehicle, "acoustic_rx_on_t", "shore_broker", "your programs",
       "one per packet that arrived and whose sender chose the channel", true},
      {topics::kSwarm, kVehicle, "swarm_t", "acomms", "helm, shoal, viewer",
       "when a message arrives, at least 1 Hz", true},
      {topics::kRelayRx, kVehicle, "relay_t", "shore_broker", "gateway",
       "one per report, message or ack that a gateway receives", true},
      {topics::kAcomms, kVehicle, "acomms_t", "acomms", "(people)",
       "when a message was recovered or rejected, or a count changed", true},
      {topics::kMediatedMessage, kVehicle, "node_message_t",
       "shoal (events), shoal send, your programs", "node_reporter", "when needed", true},
      {topics::kHelmCommand, kShore, "helm_command_t", "any program", "shore_broker", "when needed",
       true},
      {topics::kNodeReportLocal, kShore, "node_report_t", "node_reporter", "shore_broker",
       "[vehicle.reporter] rate_hz", true},
      {topics::kNodeReport, kShore, "node_report_t", "netsim_manager, vehicles from outside",
       "shore_broker", "theirs", true},
      {topics::kNodeMessageLocal, kShore, "node_message_t",
       "node_reporter, shoal (events), shoal send, your programs", "shore_broker", "when needed",
       true},
      {topics::kNodeMessage, kShore, "node_message_t", "vehicles from outside", "shore_broker",
       "theirs", true},
      {topics::kAckMessage, kShore, "ack_message_t", "node_reporter, vehicles from outside",
       "shore_broker", "one per message received that asks for it", true},
      {topics::kAcousticTx, kShore, "acoustic_tx_t", "acomms, your programs", "shore_broker, shoal",
       "when needed", true},
      {topics::kAcousticTxOn, kShore, "acoustic_tx_on_t", "your programs", "shore_broker, shoal",
       "when needed", true},
      {topics::kModemTx, kShore, "modem_tx_t", "netsim_manager", "shore_broker, shoal",
       "when needed", true},
      {topics::kRelayTx, kShore, "relay_t", "gateway", "shore_broker",
       "one per report, message or ack that it has received", true},
      {topics::kCommsFates, kShore, "comms_fate_columns_t", "shore_broker",
       "netsim_manager, shoal, viewer", "steps with decisions", true},
      {topics::kCommsMedia, kShore, "comms_media_t", "shore_broker", "viewer, (shoal log comms)",
       "with [[medium]]: steps with decisions", true},
      {topics::kCommsArrivals, kShore, "comms_arrivals_t", "shore_broker", "",
       "where sound bends: steps with acoustic decisions", true},
      {topics::kCommsRules, kShore, "broker_rules_t", "shore_broker", "viewer, (shoal rebroker)",
       "at its start and when a rule changes", true},
      {topics::kViewCommsPulse, kShore, "comms_pulse_columns_t", "shore_broker", "viewer",
       "steps with deliveries", true},
      {topics::kViewPoint, kShore, "view_point_t", "your programs", "viewer, (shoal plot)",
       "when needed", true},
      {topics::kViewPolygon, kShore, "view_polygon_t", "your programs", "viewer, (shoal plot)",
       "when needed", true},
      {topics::kViewSeglist, kShore, "view_seglist_t", "your programs", "viewer, (shoal plot)",
       "when needed", true},
      {topics::kViewCircle, kShore, "view_circle_t", "your programs", "viewer, (shoal plot)",
       "when needed", true},
      {topics::kViewText, kShore, "view_text_t", "your programs", "viewer, (shoal plot)",
       "when needed", true},
      {topics::kModemStats, kShore, "modem_stats_t", "netsim_manager", "viewer, (people)",
       "when a client reports it", true},
      {topics::kNodeReportUnc, kShore, "node_report_t", "shore_broker", "(people)",
       "shared_node_reports", false},
  };
  for (const ControlRow& row : ControlTable()) {
    table.push_back({row.channel, kShore, "unc_control_t", "shoal (events), shoal send",
                     "shore_broker, shoal", "when needed", true});
  }
  const std::vector<ChannelRow> rest = {
      {topics::kUncControlsReq, kShore, "unc_controls_req_t", "shore_broker", "shoal",
       "when it starts in mid-mission", true},
      {topics::kUncControls, kShore, "unc_controls_t", "shoal", "shore_broker", "when asked", true},
      {topics::kCommsRulesNow, kShore, "broker_rules_t", "shore_broker", "viewer", "when asked",
       false, true},
      {topics::kAppcast, kShore, "appcast_t", "every app", "shoal status, viewer", "when asked",
       false, true},
      {topics::kTick, kTickPort, "tick_t", "shoal", "every participant", "every step", false},
      {topics::kResend, kTickPort, "resend_t", "participants", "participants",
       "when a message is missing", false},
      {topics::kAppcastReq, kTickPort, "appcast_req_t", "shoal status, viewer", "every app",
       "when needed", false},
      {topics::kCommsRulesReq, kTickPort, "comms_rules_req_t", "viewer", "shore_broker",
       "when a viewer joins", false},
      {topics::kClockState, kTickPort, "clock_state_t", "shoal", "shoal send, viewer",
       "on change, and 2 Hz of wall time", false},
      {topics::kStepDone, kDonePort, "step_done_t", "every participant", "shoal", "every step",
       false},
      {topics::kStepDones, kDonePort, "step_dones_t", "processes of several participants", "shoal",
       "every step", false},
      {topics::kClockCommand, kDonePort, "clock_command_t", "shoal send, viewer", "shoal",
       "when needed", false},
  };
  table.insert(table.end(), rest.begin(), rest.end());
  return table;
}

}  // namespace

const std::vector<ChannelRow>& ChannelTable() {
  static const std::vector<ChannelRow> table = MakeTable();
  return table;
}

bool IsLogged(std::string_view channel) {
  return std::none_of(ChannelTable().begin(), ChannelTable().end(),
                      [&](const ChannelRow& row) { return !row.logged && row.topic == channel; });
}

bool IsAnswer(std::string_view channel) {
  return std::any_of(ChannelTable().begin(), ChannelTable().end(),
                     [&](const ChannelRow& row) { return row.is_answer && row.topic == channel; });
}

}  // namespace shoal
