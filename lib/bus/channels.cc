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
Channel<actuators_t> Actuators(std::string_view vehicle) { return {Of("ACTUATORS", vehicle)}; }
Channel<desired_t> Desired(std::string_view vehicle) { return {Of("DESIRED", vehicle)}; }
Channel<helm_state_t> HelmState(std::string_view vehicle) { return {Of("HELM_STATE", vehicle)}; }
Channel<helm_command_t> HelmCommand(std::string_view vehicle) {
  return {Of("HELM_COMMAND", vehicle)};
}
Channel<sim_command_t> SimCommand(std::string_view vehicle) { return {Of("SIM_COMMAND", vehicle)}; }
Channel<node_report_t> NodeReport(std::string_view vehicle) { return {Of("NODE_REPORT", vehicle)}; }

Channel<helm_command_t> HelmCommandAll() { return {"HELM_COMMAND"}; }
Channel<node_report_t> NodeReportLocal() { return {"NODE_REPORT_LOCAL"}; }
Channel<node_report_t> NodeReportFromOutside() { return {"NODE_REPORT"}; }
Channel<comms_fates_t> CommsFates() { return {"COMMS_FATES"}; }
Channel<unc_control_t> UncCommsRange() { return {"UNC_COMMS_RANGE"}; }
Channel<unc_control_t> UncStaleTime() { return {"UNC_STALE_TIME"}; }
Channel<appcast_t> Appcast() { return {"APPCAST"}; }

Channel<tick_t> Tick() { return {"TICK"}; }
Channel<resend_t> Resend() { return {"RESEND"}; }
Channel<appcast_req_t> AppcastReq() { return {"APPCAST_REQ"}; }
Channel<step_done_t> StepDone() { return {"STEP_DONE"}; }

}  // namespace channels

const std::vector<ChannelRow>& ChannelTable() {
  using enum ChannelHome;
  static const std::vector<ChannelRow> table = {
      {"NAV", kVehicle, "nav_t", "vehicle_sim", "helm, node_reporter, shoal", "every step", true},
      {"ACTUATORS", kVehicle, "actuators_t", "helm", "vehicle_sim", "every step", true},
      {"DESIRED", kVehicle, "desired_t", "helm", "(people)", "every step", true},
      {"HELM_STATE", kVehicle, "helm_state_t", "helm", "node_reporter, shoal",
       "on change, at least 1 Hz", true},
      {"HELM_COMMAND", kVehicle, "helm_command_t", "shoal (events), shoal send, shore_broker",
       "helm", "when needed", true},
      {"SIM_COMMAND", kVehicle, "sim_command_t", "shoal (events), shoal send", "vehicle_sim",
       "when needed", true},
      {"NODE_REPORT", kVehicle, "node_report_t", "shore_broker", "helm",
       "one per report that got through", true},
      {"HELM_COMMAND", kShore, "helm_command_t", "anybody", "shore_broker", "when needed", true},
      {"NODE_REPORT_LOCAL", kShore, "node_report_t", "node_reporter", "shore_broker",
       "[vehicle.reporter] rate_hz", true},
      {"NODE_REPORT", kShore, "node_report_t", "vehicles from outside", "shore_broker", "theirs",
       true},
      {"COMMS_FATES", kShore, "comms_fates_t", "shore_broker", "shoal", "steps with decisions",
       true},
      {"UNC_COMMS_RANGE", kShore, "unc_control_t", "shoal (events), shoal send", "shore_broker",
       "when needed", true},
      {"UNC_STALE_TIME", kShore, "unc_control_t", "shoal (events), shoal send", "shore_broker",
       "when needed", true},
      {"APPCAST", kShore, "appcast_t", "every app", "shoal status", "when asked", false},
      {"TICK", kTickPort, "tick_t", "shoal", "every participant", "every step", false},
      {"RESEND", kTickPort, "resend_t", "participants", "participants", "when a message is missing",
       false},
      {"APPCAST_REQ", kTickPort, "appcast_req_t", "shoal status", "every app", "when needed",
       false},
      {"STEP_DONE", kDonePort, "step_done_t", "every participant", "shoal", "every step", false},
  };
  return table;
}

bool IsLogged(std::string_view channel) {
  return std::none_of(ChannelTable().begin(), ChannelTable().end(),
                      [&](const ChannelRow& row) { return !row.logged && row.topic == channel; });
}

}  // namespace shoal
