#include "lib/bus/channels.h"

#include <algorithm>
#include <cctype>

namespace shoal {

std::string UpperCase(std::string_view name) {
  std::string upper(name);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

namespace channels {
namespace {
std::string Of(std::string_view topic, std::string_view vehicle) {
  return std::string(topic) + "_" + UpperCase(vehicle);
}
}  // namespace

Channel<nav_t> Nav(std::string_view vehicle) { return {Of("NAV", vehicle)}; }
Channel<nav_t> MeasuredNav(std::string_view vehicle) { return {Of("MEASURED_NAV", vehicle)}; }
Channel<sonar_t> Sonar(std::string_view vehicle) { return {Of("SONAR", vehicle)}; }
Channel<water_sample_t> WaterSample(std::string_view vehicle) {
  return {Of("WATER_SAMPLE", vehicle)};
}
Channel<actuators_t> Actuators(std::string_view vehicle) { return {Of("ACTUATORS", vehicle)}; }
Channel<desired_t> Desired(std::string_view vehicle) { return {Of("DESIRED", vehicle)}; }
Channel<helm_state_t> HelmState(std::string_view vehicle) { return {Of("HELM_STATE", vehicle)}; }
Channel<helm_command_t> HelmCommand(std::string_view vehicle) {
  return {Of("HELM_COMMAND", vehicle)};
}
Channel<sim_command_t> SimCommand(std::string_view vehicle) { return {Of("SIM_COMMAND", vehicle)}; }
Channel<node_report_t> NodeReport(std::string_view vehicle) { return {Of("NODE_REPORT", vehicle)}; }
Channel<node_message_t> NodeMessage(std::string_view vehicle) {
  return {Of("NODE_MESSAGE", vehicle)};
}
Channel<node_message_t> MediatedMessage(std::string_view vehicle) {
  return {Of("MEDIATED_MESSAGE", vehicle)};
}
Channel<ack_message_t> AckMessageTo(std::string_view vehicle) {
  return {Of("ACK_MESSAGE", vehicle)};
}
Channel<acoustic_rx_t> AcousticRx(std::string_view vehicle) { return {Of("ACOUSTIC_RX", vehicle)}; }
Channel<swarm_t> Swarm(std::string_view vehicle) { return {Of("SWARM", vehicle)}; }

Channel<helm_command_t> HelmCommandAll() { return {"HELM_COMMAND"}; }
Channel<node_report_t> NodeReportLocal() { return {"NODE_REPORT_LOCAL"}; }
Channel<node_report_t> NodeReportFromOutside() { return {"NODE_REPORT"}; }
Channel<node_message_t> NodeMessageLocal() { return {"NODE_MESSAGE_LOCAL"}; }
Channel<node_message_t> NodeMessageFromOutside() { return {"NODE_MESSAGE"}; }
Channel<ack_message_t> AckMessage() { return {"ACK_MESSAGE"}; }
Channel<acoustic_tx_t> AcousticTx() { return {"ACOUSTIC_TX"}; }
Channel<unc_control_t> Control(const ControlRow& row) { return {std::string(row.channel)}; }
Channel<unc_controls_t> UncControls() { return {"UNC_CONTROLS"}; }
Channel<unc_controls_req_t> UncControlsReq() { return {"UNC_CONTROLS_REQ"}; }
Channel<node_report_t> NodeReportUnc() { return {"NODE_REPORT_UNC"}; }
Channel<comms_fates_t> CommsFates() { return {"COMMS_FATES"}; }
Channel<comms_rules_t> CommsRules() { return {"COMMS_RULES"}; }
Channel<comms_rules_t> CommsRulesNow() { return {"COMMS_RULES_NOW"}; }
Channel<comms_pulses_t> ViewCommsPulse() { return {"VIEW_COMMS_PULSE"}; }
Channel<modem_stats_t> ModemStats() { return {"MODEM_STATS"}; }
Channel<appcast_t> Appcast() { return {"APPCAST"}; }

Channel<tick_t> Tick() { return {"TICK"}; }
Channel<resend_t> Resend() { return {"RESEND"}; }
Channel<appcast_req_t> AppcastReq() { return {"APPCAST_REQ"}; }
Channel<comms_rules_req_t> CommsRulesReq() { return {"COMMS_RULES_REQ"}; }
Channel<clock_state_t> ClockState() { return {"CLOCK_STATE"}; }
Channel<step_done_t> StepDone() { return {"STEP_DONE"}; }
Channel<clock_command_t> ClockCommand() { return {"CLOCK_COMMAND"}; }

}  // namespace channels

namespace {

std::vector<ChannelRow> MakeTable() {
  using enum ChannelHome;
  std::vector<ChannelRow> table = {
      {"NAV", kVehicle, "nav_t", "vehicle_sim",
       "helm, node_reporter, acomms, vehicle_sim of others, shoal, viewer", "every step", true},
      {"MEASURED_NAV", kVehicle, "nav_t", "vehicle_sim", "helm, node_reporter, acomms",
       "every step, with [vehicle.sensors]", true},
      {"SONAR", kVehicle, "sonar_t", "vehicle_sim", "helm", "[vehicle.sonar] rate_hz", true},
      {"WATER_SAMPLE", kVehicle, "water_sample_t", "vehicle_sim", "your programs",
       "every step, with [environment.plume]", true},
      {"ACTUATORS", kVehicle, "actuators_t", "helm", "vehicle_sim", "every step", true},
      {"DESIRED", kVehicle, "desired_t", "helm", "viewer, (people)", "every step", true},
      {"HELM_STATE", kVehicle, "helm_state_t", "helm", "node_reporter, acomms, shoal, viewer",
       "on change, at least 1 Hz", true},
      {"HELM_COMMAND", kVehicle, "helm_command_t", "shoal (events), shoal send, shore_broker",
       "helm", "when needed", true},
      {"SIM_COMMAND", kVehicle, "sim_command_t", "shoal (events), shoal send", "vehicle_sim",
       "when needed", true},
      {"NODE_REPORT", kVehicle, "node_report_t", "shore_broker", "helm",
       "one per report that got through", true},
      {"NODE_MESSAGE", kVehicle, "node_message_t", "shore_broker",
       "helm, node_reporter, your programs", "one per message that got through", true},
      {"ACK_MESSAGE", kVehicle, "ack_message_t", "shore_broker", "node_reporter, your programs",
       "one per ack that got through", true},
      {"ACOUSTIC_RX", kVehicle, "acoustic_rx_t", "shore_broker",
       "acomms, netsim_manager, your programs", "one per packet that arrived", true},
      {"SWARM", kVehicle, "swarm_t", "acomms", "helm, shoal, viewer",
       "when a message arrives, at least 1 Hz", true},
      {"MEDIATED_MESSAGE", kVehicle, "node_message_t", "shoal (events), shoal send, your programs",
       "node_reporter", "when needed", true},
      {"HELM_COMMAND", kShore, "helm_command_t", "anybody", "shore_broker", "when needed", true},
      {"NODE_REPORT_LOCAL", kShore, "node_report_t", "node_reporter", "shore_broker",
       "[vehicle.reporter] rate_hz", true},
      {"NODE_REPORT", kShore, "node_report_t", "netsim_manager, vehicles from outside",
       "shore_broker", "theirs", true},
      {"NODE_MESSAGE_LOCAL", kShore, "node_message_t",
       "node_reporter, shoal (events), shoal send, your programs", "shore_broker", "when needed",
       true},
      {"NODE_MESSAGE", kShore, "node_message_t", "vehicles from outside", "shore_broker", "theirs",
       true},
      {"ACK_MESSAGE", kShore, "ack_message_t", "node_reporter, vehicles from outside",
       "shore_broker", "one per message heard that asks for it", true},
      {"ACOUSTIC_TX", kShore, "acoustic_tx_t", "acomms, netsim_manager, your programs",
       "shore_broker", "when needed", true},
      {"COMMS_FATES", kShore, "comms_fates_t", "shore_broker", "netsim_manager, shoal, viewer",
       "steps with decisions", true},
      {"COMMS_RULES", kShore, "comms_rules_t", "shore_broker", "viewer, (shoal rebroker)",
       "at its start and when a rule changes", true},
      {"VIEW_COMMS_PULSE", kShore, "comms_pulses_t", "shore_broker", "viewer",
       "steps with deliveries", true},
      {"MODEM_STATS", kShore, "modem_stats_t", "netsim_manager", "(people)",
       "when a client tells it", true},
      {"NODE_REPORT_UNC", kShore, "node_report_t", "shore_broker", "(people)",
       "shared_node_reports", false},
  };
  for (const ControlRow& row : ControlTable()) {
    table.push_back({row.channel, kShore, "unc_control_t", "shoal (events), shoal send",
                     "shore_broker, shoal", "when needed", true});
  }
  const std::vector<ChannelRow> rest = {
      {"UNC_CONTROLS_REQ", kShore, "unc_controls_req_t", "shore_broker", "shoal",
       "when it starts in the midst of a mission", true},
      {"UNC_CONTROLS", kShore, "unc_controls_t", "shoal", "shore_broker", "when asked", true},
      {"APPCAST", kShore, "appcast_t", "every app", "shoal status, viewer", "when asked", false,
       true},
      {"COMMS_RULES_NOW", kShore, "comms_rules_t", "shore_broker", "viewer", "when asked", false,
       true},
      {"TICK", kTickPort, "tick_t", "shoal", "every participant", "every step", false},
      {"RESEND", kTickPort, "resend_t", "participants", "participants", "when a message is missing",
       false},
      {"APPCAST_REQ", kTickPort, "appcast_req_t", "shoal status, viewer", "every app",
       "when needed", false},
      {"COMMS_RULES_REQ", kTickPort, "comms_rules_req_t", "viewer", "shore_broker",
       "when a viewer joins", false},
      {"CLOCK_STATE", kTickPort, "clock_state_t", "shoal", "shoal send, viewer",
       "on change, and 2 Hz of wall time", false},
      {"STEP_DONE", kDonePort, "step_done_t", "every participant", "shoal", "every step", false},
      {"CLOCK_COMMAND", kDonePort, "clock_command_t", "shoal send, viewer", "shoal", "when needed",
       false},
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
