#include "lib/tools/moos/import_settings.h"

#include <array>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

using enum SettingKind;
using enum SettingPlace;

constexpr std::string_view kUnc = "ufldnodecomms";
constexpr std::string_view kSim = "usimmarine";
constexpr std::string_view kPid = "pmarinepid";
constexpr std::string_view kReport = "pnodereporter";
constexpr std::string_view kHelmApp = "phelmivp";

constexpr std::array kSettings = std::to_array<SettingRule>({
    {kUnc, "comms_range", kComms, "comms_range", kNumberOrNolimit, ""},
    {kUnc, "critical_range", kComms, "critical_range", kNumber, ""},
    {kUnc, "stale_time", kComms, "stale_time", kNumber, ""},
    {kUnc, "stale_forget", kComms, "stale_forget_s", kNumber, ""},
    {kUnc, "groups", kComms, "groups", kFlag, ""},
    {kUnc, "msg_groups", kComms, "msg_groups", kFlag, ""},
    {kUnc, "ignore_group", kComms, "ignore_group", kText, ""},
    {kUnc, "min_rpt_interval", kComms, "min_rpt_interval", kNumber, ""},
    {kUnc, "min_report_interval", kComms, "min_rpt_interval", kNumber, ""},
    {kUnc, "min_msg_interval", kComms, "min_msg_interval", kNumber, ""},
    {kUnc, "max_msg_length", kComms, "max_msg_length", kNumber, ""},
    {kUnc, "drop_percentage", kComms, "drop_percentage", kNumber, ""},
    {kUnc, "drop_pct", kComms, "drop_percentage", kNumber, ""},
    {kUnc, "shared_node_reports", kComms, "shared_node_reports", kFlagOrNumber, ""},
    {kUnc, "pulse_duration", kComms, "pulse_duration", kNumber, ""},
    {kUnc, "view_node_rpt_pulses", kComms, "view_node_rpt_pulses", kFlag, ""},
    {kUnc, "msg_color", kComms, "msg_color", kText, ""},
    {kUnc, "msg_repeat_color", kComms, "msg_repeat_color", kText, ""},

    {kReport, "apptick", kReporter, "rate_hz", kNumber, ""},
    {kReport, "platform_type", kVehicle, "type", kText, ""},
    {kReport, "vessel_type", kVehicle, "type", kText, ""},
    {kReport, "platform_length", kVehicle, "length_m", kNumber, ""},
    {kReport, "platform_color", kVehicle, "color", kText, ""},
    {kReport, "group", kVehicle, "group", kText, ""},
    {kReport, "nav_grace_period", kReporter, "nav_grace_period_s", kNumber, ""},
    {kReport, "nohelm_threshold", kReporter, "nohelm_threshold_s", kNumber, ""},
    {kReport, "blackout_interval", kReporter, "blackout_interval_s", kNumber, ""},
    {kReport, "blackout_variance", kReporter, "blackout_variance_s", kNumber, ""},
    {kReport, "extrap_enabled", kReporter, "extrapolate", kFlag, ""},
    {kReport, "extrap_pos_thresh", kReporter, "extrap_position_thresh_m", kNumber, ""},
    {kReport, "extrap_hdg_thresh", kReporter, "extrap_heading_thresh_deg", kNumber, ""},
    {kReport, "extrap_max_gap", kReporter, "extrap_max_gap_s", kNumber, ""},

    {kSim, "turn_rate", kCraft, "turn_rate_degps", kNumber, ""},
    {kSim, "turn_loss", kCraft, "turn_speed_loss", kNumber, ""},
    {kSim, "turn_spd_loss", kCraft, "turn_speed_loss", kNumber, ""},
    {kSim, "max_acceleration", kCraft, "max_acceleration_mps2", kNumber, ""},
    {kSim, "max_deceleration", kCraft, "max_deceleration_mps2", kNumber, ""},
    {kSim, "max_rudder_degs_per_sec", kCraft, "max_rudder_rate_degps", kNumber, ""},

    {kPid, "yaw_pid_kp", kAutopilot, "heading_kp", kNumber, ""},
    {kPid, "yaw_pid_ki", kAutopilot, "heading_ki", kNumber, ""},
    {kPid, "yaw_pid_kd", kAutopilot, "heading_kd", kNumber, ""},
    {kPid, "yaw_pid_integral_limit", kAutopilot, "heading_integral_limit_deg", kNumber, ""},
    {kPid, "maxrudder", kCraft, "max_rudder_deg", kNumber, ""},

    {kHelmApp, "start_in_drive", kHelm, "deploy_at_start", kFlag, ""},
});

struct Counterpart {
  std::string_view name;
  std::string_view text;
};

constexpr std::array kApps = std::to_array<Counterpart>({
    {"moosdb", "not needed: processes use LCM, without a database between them"},
    {"ufldnodecomms", "shore_broker, always there; its rules are in [comms]"},
    {"pnodereporter", "node_reporter, one per vehicle"},
    {"usimmarine", "vehicle_sim, one per vehicle"},
    {"pmarinepid", "part of helm, one per vehicle; its gains are in [vehicle.autopilot]"},
    {"phelmivp", "helm, one per vehicle; its behaviors are [[vehicle.behavior]]"},
    {"pcontactmgrv20", "part of helm: contacts come from the node reports that it receives"},
    {"pobstaclemgr", "part of helm: obstacles are [[obstacle]]"},
    {"plogger", "shoal run --record DIR"},
    {"pantler", "shoal run"},
    {"pshare", "not needed: see --layout of shoal run"},
    {"phostinfo", "not needed: shoal finds its ports itself"},
    {"ufldnodebroker", "not needed: shore_broker knows the vehicles of the mission"},
    {"ufldshorebroker", "not needed: shore_broker knows the vehicles of the mission"},
    {"uprocesswatch", "shoal run watches its processes: on_loss in [mission]"},
    {"utimerscript", "its events that have a counterpart are an [[event]] each"},
    {"upokedb", "shoal send"},
    {"uxms", "shoal status, shoal log cat"},
    {"pmarineviewer", "shoal run --view; its buttons are an [[order]] each"},
    {"prealm", "shoal status"},
    {"uloadwatch", "shoal status clock: shoal does not fall behind, it runs slower"},
    {"utermcommand", "shoal send"},
    {"pautopoke", "shoal send, or an [[event]]"},
    {"pmissioneval", "[[expect]]"},
    {"pmissionhash", "each log has its mission file"},
    {"umayfinish", "duration_s in [mission]"},
    {"ufldcollisiondetect", "collisions in [mission]"},
    {"ufldobstaclesim", "its obstacles are an [[obstacle]] each"},
    {"ufldcollobdetect", "collisions in [mission]"},
    {"pbasiccontactmgr", "part of helm: contacts come from the node reports that it receives"},
    {"pmoosbridge", "not needed: see --layout of shoal run"},
    {"umemwatch", "shoal status"},
    {"umacview", "shoal status"},
    {"ufldscope", "shoal status, shoal log cat"},
    {"uquerydb", "[[expect]]"},
    {"isay", "not needed: sound only"},
    {"umac", "shoal status"},
});

constexpr std::array kKeys = std::to_array<Counterpart>({
    {"apptick", "every process works in each step: tick_s in [mission]"},
    {"commstick", "every process works in each step: tick_s in [mission]"},
    {"maxapptick", "every process works in each step: tick_s in [mission]"},
    {"serverhost", "not needed: processes use LCM, without a database between them"},
    {"serverport", "not needed: shoal run --port BASE chooses ports"},
    {"speed_factor", "not needed: the helm takes the thrust for a speed from thrust_map"},
    {"verbose", "without meaning here: shoal status shows what each process does"},
    {"debug", "without meaning here: shoal status shows what each process does"},
});

template <size_t N>
std::string_view Find(const std::array<Counterpart, N>& list, std::string_view name) {
  for (const Counterpart& counterpart : list) {
    if (counterpart.name == name) return counterpart.text;
  }
  return {};
}

std::optional<std::string> FlagValue(std::string_view value) {
  const std::string word = LowerCase(value.substr(0, 8));
  if (word != "true" && word != "false") return std::nullopt;
  return word;
}

std::optional<std::string> NumberValue(std::string_view value) {
  const auto number = NumberIn(value);
  if (!number) return std::nullopt;
  return TomlNumber(*number);
}

}  // namespace

std::string AppClass(std::string_view app) {
  std::string lower = LowerCase(app);
  for (const std::string_view versions : {kSim, kPid}) {
    if (lower.starts_with(versions)) return std::string(versions);
  }
  return lower;
}

const SettingRule* FindSetting(std::string_view app_class, std::string_view moos_key) {
  const std::string key = LowerCase(moos_key);
  for (const SettingRule& rule : kSettings) {
    // uSimMarineV22 may hold the PID's parameters itself.
    const bool is_app = rule.app == app_class || (rule.app == kPid && app_class == kSim);
    if (is_app && rule.moos_key == key) return &rule;
  }
  return nullptr;
}

std::optional<std::string> SettingValue(SettingKind kind, std::string_view value) {
  switch (kind) {
    case kNumber:
      return NumberValue(value);
    case kNumberOrNolimit:
      if (LowerCase(value.substr(0, 8)) == "nolimit") return TomlString("nolimit");
      return NumberValue(value);
    case kFlag:
      return FlagValue(value);
    case kFlagOrNumber:
      if (auto flag = FlagValue(value)) return flag;
      return NumberValue(value);
    case kText:
      break;
  }
  if (value.size() >= 2 && value.starts_with('"') && value.ends_with('"')) {
    value = value.substr(1, value.size() - 2);
  }
  return TomlString(value);
}

std::string_view KindText(SettingKind kind) {
  switch (kind) {
    case kNumber:
      return "a number";
    case kNumberOrNolimit:
      return "a number or nolimit";
    case kFlag:
      return "true or false";
    case kFlagOrNumber:
      return "true, false or a number";
    case kText:
      break;
  }
  return "a text";
}

std::string_view AppCounterpart(std::string_view app_class) { return Find(kApps, app_class); }

std::string_view KeyCounterpart(std::string_view moos_key) {
  const std::string_view text = Find(kKeys, LowerCase(moos_key));
  return text.empty() ? "no counterpart in shoal" : text;
}

}  // namespace shoal
