#include "lib/tools/moos/import_vehicle.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_text.h"
#include "lib/tools/moos/sim_drift.h"
#include "lib/tools/moos/start_pos.h"

namespace shoal {
namespace {

/// More than a step can use.
constexpr char kNoAcceleration_mps2[] = "100";
constexpr char kNoRudderRate_degps[] = "100000";
constexpr std::string_view kOwnMotion = "the Remus 100 has motion and autopilots of its own";
/// A behavior of the kind timer that no line of a .bhv file gives. `settings`: keys and TOML.
BhvTable TimerTable(std::string_view text, const std::string& origin, const std::string& remark,
                    const std::vector<std::pair<std::string, std::string>>& settings) {
  BhvTable table{.header = "[[vehicle.behavior]]", .lines = {}};
  const auto set = [&](std::string key, std::string value) {
    const bool is_first = table.lines.empty();
    table.lines.push_back({.key = std::move(key),
                           .value = std::move(value),
                           .origin = is_first ? origin : "",
                           .text = std::string(text),
                           .reason = is_first ? remark : "",
                           .is_essential = true});
  };
  set("kind", TomlString("timer"));
  for (const auto& [key, value] : settings) set(key, value);
  return table;
}

}  // namespace

VehicleImport::VehicleImport(size_t number, std::string name, std::string remark, bool is_imported,
                             bool is_underwater)
    : id_(fmt::format("vehicle{}", number)),
      name_(std::move(name)),
      remark_(std::move(remark)),
      is_imported_(is_imported),
      is_underwater_(is_underwater) {}

void VehicleImport::SetFirstValue(const std::string& name, const std::string& value,
                                  const std::string& origins) {
  auto table =
      std::find_if(behaviors_.tables.begin(), behaviors_.tables.end(),
                   [](const BhvTable& each) { return each.header == "[vehicle.variables]"; });
  if (table == behaviors_.tables.end()) {
    table = behaviors_.tables.insert(behaviors_.tables.begin(),
                                     {.header = "[vehicle.variables]", .lines = {}});
  }
  for (DraftLine& line : table->lines) {
    if (line.key != name) continue;
    line.key.clear();
    line.reason = "the button sets another value with DEPLOY, before which nothing happens";
  }
  const auto number = NumberIn(value);
  table->lines.push_back({.key = name,
                          .value = number ? TomlNumber(*number) : TomlString(value),
                          .origin = origins,
                          .text = name + " = " + value,
                          .reason = "As the button sets it with DEPLOY."});
}

void VehicleImport::SetWithDeploy(const std::vector<std::pair<std::string, std::string>>& settings,
                                  const std::string& origins) {
  std::vector<std::string> flags;
  for (const auto& [name, value] : settings) {
    flags.push_back(fmt::format("{} = {}", name, value));
    SetFirstValue(name, value, origins);
  }
  std::vector<std::pair<std::string, std::string>> keys = {{"name", TomlString("deploy_button")},
                                                           {"perpetual", "true"}};
  if (behaviors_.variables.contains("DEPLOY"))
    keys.emplace_back("condition", "[\"DEPLOY = true\"]");
  keys.emplace_back("runflag", TomlTexts(flags));
  behaviors_.tables.push_back(TimerTable("what the button sets with DEPLOY", origins,
                                         "What the button sets besides DEPLOY.", keys));
}

void VehicleImport::AddTimer(const ScriptTimer& timer) {
  std::vector<std::pair<std::string, std::string>> keys = {
      {"name", TomlString(fmt::format("script_{:03}", ++num_timers_))},
      {"condition", TomlTexts(timer.conditions)},
      {"duration", TomlNumber(timer.duration_s)},
      {"duration_idle_decay", "false"}};
  if (timer.is_repeated) keys.emplace_back("perpetual", "true");
  keys.emplace_back("endflag", "[" + timer.flag + "]");
  behaviors_.tables.push_back(
      TimerTable("event of uTimerScript", timer.origin, timer.remark, keys));
}

void VehicleImport::AddTables(MissionDraft* draft) {
  draft_ = draft;
  draft->AddTable(id_, "[[vehicle]]", true);
  draft->Set(
      id_,
      {.key = "name", .value = TomlString(name_), .origin = "", .text = "", .reason = remark_});
  if (is_underwater_) {
    draft->Set(id_, {.key = "model",
                     .value = TomlString("remus100"),
                     .origin = "",
                     .text = "",
                     .reason = "Assumed: shoal's only underwater vehicle. Its motion and its "
                               "autopilots are its own."});
  }
  draft->AddTable(TableOf(SettingPlace::kCraft),
                  is_underwater_ ? "[vehicle.remus100]" : "[vehicle.surface_craft]");
  draft->AddTable(TableOf(SettingPlace::kAutopilot), "[vehicle.autopilot]");
  draft->AddTable(TableOf(SettingPlace::kReporter), "[vehicle.reporter]");
  draft->AddTable(TableOf(SettingPlace::kHelm), "[vehicle.helm_options]");
  if (!station_origins_.empty()) {
    draft->Set(TableOf(SettingPlace::kHelm),
               {.key = "deploy_keeps",
                .value = "[\"STATION_KEEP\"]",
                .origin = station_origins_,
                .text = "",
                .reason = "The button that deploys does not set it."});
  }
  draft->AddTable(id_ + ".domain", "[vehicle.domain]");
  for (size_t i = 0; i < behaviors_.tables.size(); ++i) {
    const std::string table = fmt::format("{}.behaviors{}", id_, i);
    draft->AddTable(table, behaviors_.tables[i].header);
    for (const DraftLine& line : behaviors_.tables[i].lines) draft->Add(table, line);
  }
}

void VehicleImport::AddEvents() { draft_->AddTable(id_ + ".drift", "[[event]]"); }

std::string VehicleImport::TableOf(SettingPlace place) const {
  switch (place) {
    case SettingPlace::kCraft:
      return id_ + ".craft";
    case SettingPlace::kAutopilot:
      return id_ + ".autopilot";
    case SettingPlace::kReporter:
      return id_ + ".reporter";
    case SettingPlace::kHelm:
      return id_ + ".helm";
    case SettingPlace::kComms:
      return "comms";
    case SettingPlace::kVehicle:
      break;
  }
  return id_;
}

std::string VehicleImport::TableOfApp(std::string_view app_class) const {
  if (app_class == "usimmarine") return TableOf(SettingPlace::kCraft);
  if (app_class == "pmarinepid") return TableOf(SettingPlace::kAutopilot);
  if (app_class == "pnodereporter") return TableOf(SettingPlace::kReporter);
  if (app_class == "phelmivp") return TableOf(SettingPlace::kHelm);
  return "";
}

bool VehicleImport::Take(std::string_view app_class, const std::string& origin,
                         const MoosLine& line, std::vector<std::string>* warnings) {
  const std::string key = LowerCase(line.key);
  const bool is_sim = app_class == "usimmarine";
  const bool is_start = is_sim && key.starts_with("start_");
  const bool is_thrust = is_sim && (key == "thrust_map" || key == "thrust_factor");
  const bool is_drift = is_sim && (key == "drift_x" || key == "drift_y" || key == "drift_vector");
  const bool is_speed = is_sim && key == "max_speed";
  if (is_sim && TakeNoLimit(key, origin, line)) return true;
  if (key == "speed_factor" && TakeSpeedFactor(app_class, origin, line)) return true;
  const bool is_domain = app_class == "phelmivp" && key == "domain";
  if (is_domain) return TakeDomain(origin, line, warnings);
  const bool is_extra = app_class == "pnodereporter" && key == "platform_aspect";
  if (!is_start && !is_thrust && !is_drift && !is_extra && !is_speed) return false;
  if (is_underwater_ && (is_thrust || is_speed)) {
    draft_->Remark(TableOfApp(app_class), origin, line.text, std::string(kOwnMotion));
    return true;
  }
  if (is_extra) {
    const size_t equals = line.value.find('=');
    if (equals != std::string::npos) {
      extra_.lines.Add(origin, line.text);
      const std::string_view value = line.value;
      extra_.members[TomlString(Trimmed(value.substr(0, equals)))] =
          TomlString(Trimmed(value.substr(equals + 1)));
      return true;
    }
  } else if (TakeSim(key, origin, line, warnings)) {
    return true;
  }
  const std::string reason = "makes no sense: " + std::string(is_extra    ? "not KEY=VALUE"
                                                              : is_start  ? "not numbers"
                                                              : is_thrust ? "not thrust:speed, ..."
                                                              : is_speed  ? "not a positive number"
                                                                          : "not numbers");
  draft_->Remark(TableOfApp(app_class), origin, line.text, reason);
  warnings->push_back(origin + ": " + line.text + ": " + reason);
  return true;
}

bool VehicleImport::TakeSim(std::string_view key, const std::string& origin, const MoosLine& line,
                            std::vector<std::string>* warnings) {
  if (key.starts_with("start_")) return TakeStart(origin, line, warnings);
  const std::string craft = TableOf(SettingPlace::kCraft);
  if (key == "thrust_map") return thrust_.TakeMap(line, craft, draft_);
  if (key == "thrust_factor") return thrust_.TakeFactor(line, craft, draft_);
  if (key == "max_speed") return thrust_.TakeMaxSpeed(line, craft, draft_);
  return TakeDrift(key, origin, line);
}

bool VehicleImport::TakeStart(const std::string& origin, const MoosLine& line,
                              std::vector<std::string>* warnings) {
  std::map<std::string, double> given;  // By uSimMarine's names.
  const std::string key = LowerCase(line.key).substr(std::string_view("start_").size());
  if (key == "pos") {
    const std::string problem = ReadStartPos(line.value, &given);
    if (!problem.empty()) {
      warnings->push_back(fmt::format("{}: {}: {}", origin, line.text, problem));
      draft_->Remark(id_, origin, line.text, problem);
    }
  } else {
    const auto number = NumberIn(line.value);
    if (!number || (StartKey(key).empty() && key != "depth")) return false;
    given[key] = *number;
  }
  if (is_underwater_ && given.contains("depth")) {
    start_.members["depth_m"] = TomlNumber(given["depth"]);
    given.erase("depth");
    if (given.empty()) start_.lines.Add(origin, line.text);
  }
  const auto depth = given.find("depth");
  if (depth != given.end() && depth->second != 0) {
    draft_->Remark(id_, origin, line.text, "a surface craft has no depth");
  }
  bool any = false;
  for (const auto& [name, number] : given) {
    if (StartKey(name).empty()) continue;
    start_.members[std::string(StartKey(name))] = TomlNumber(number);
    any = true;
  }
  if (any) start_.lines.Add(origin, line.text);
  if (!any && depth != given.end() && depth->second == 0) {
    draft_->Remark(id_, origin, line.text, "a surface craft is always there");
  }
  return true;
}

/// `Domain = speed:0:4:41` gives the values among which the helm decides. The last depth is also
/// the greatest depth of the vehicle.
bool VehicleImport::TakeDomain(const std::string& origin, const MoosLine& line,
                               std::vector<std::string>* warnings) {
  const std::vector<std::string_view> parts = TrimmedParts(line.value, ':');
  if (parts.size() < 4) return false;
  const std::string name = LowerCase(parts[0]);
  auto first = NumberIn(parts[1]);
  const auto last = NumberIn(parts[2]);
  auto count = NumberIn(parts[3]);
  if (!first || !last || !count) return false;
  const std::string table = id_ + ".domain";
  if (name == "course" || name == "heading") {
    const bool is_usual = *first == 0 && *last == 359 && *count == 360;
    draft_->Remark(table, origin, line.text,
                   is_usual ? "always so" : "always 360 courses, whole degrees");
    return true;
  }
  if (name != "speed" && name != "depth") return false;
  if (name == "depth" && !is_underwater_) {
    draft_->Remark(table, origin, line.text, "a surface craft has no depth");
    return true;
  }
  std::string reason;
  if (name == "speed" && *first > 0 && *last > *first && *count > 1) {
    // As many steps as fit below, so that a vessel can stop.
    count = std::round(*last / (*last - *first) * (*count - 1)) + 1;
    first = 0;
    reason = fmt::format("Assumed: from 0 m/s on, not {}, so that a vessel can stop.",
                         Trimmed(parts[1]));
    warnings->push_back(
        fmt::format("{}: {}: taken from 0 m/s on, so that a vessel can stop", origin, line.text));
  }
  draft_->Set(table, {.key = name,
                      .value = fmt::format("[{}, {}, {}]", TomlNumber(*first), TomlNumber(*last),
                                           TomlNumber(*count)),
                      .origin = origin,
                      .text = line.text,
                      .reason = reason});
  if (name == "depth") {
    draft_->Set(TableOf(SettingPlace::kCraft), {.key = "max_depth_m",
                                                .value = TomlNumber(*last),
                                                .origin = origin,
                                                .text = line.text,
                                                .reason = ""});
  }
  return true;
}

bool VehicleImport::TakeDrift(std::string_view key, const std::string& origin,
                              const MoosLine& line) {
  if (!TakeDriftLine(key, line.value, &drift_mps_)) return false;
  drift_.Add(origin, line.text);
  return true;
}

void VehicleImport::SetGathered(const std::string& table, std::string key,
                                const Gathered& gathered) {
  if (gathered.members.empty()) return;
  std::string members;
  for (const auto& [name, value] : gathered.members) {
    members.append(members.empty() ? "" : ", ").append(name).append(" = ").append(value);
  }
  draft_->Set(table, {.key = std::move(key),
                      .value = "{" + members + "}",
                      .origin = gathered.lines.origins,
                      .text = gathered.lines.texts,
                      .reason = ""});
}

/// A limit of 0 is none there.
bool VehicleImport::TakeNoLimit(std::string_view key, const std::string& origin,
                                const MoosLine& line) {
  const bool is_rudder = key == "max_rudder_degs_per_sec";
  const std::string limit = is_rudder                   ? "max_rudder_rate_degps"
                            : key == "max_acceleration" ? "max_acceleration_mps2"
                            : key == "max_deceleration" ? "max_deceleration_mps2"
                                                        : "";
  if (limit.empty() || is_underwater_ || NumberIn(line.value) != 0.0) return false;
  draft_->Set(TableOf(SettingPlace::kCraft),
              {.key = limit,
               .value = is_rudder ? kNoRudderRate_degps : kNoAcceleration_mps2,
               .origin = origin,
               .text = line.text,
               .reason = "0 is not a limit there."});
  return true;
}

/// With a factor the thrust follows the wanted speed, whatever the speed is.
bool VehicleImport::TakeSpeedFactor(std::string_view app_class, const std::string& origin,
                                    const MoosLine& line) {
  const bool is_pid = app_class == "pmarinepid" || app_class == "usimmarine";
  if (!is_pid || is_underwater_ || NumberIn(line.value).value_or(0) <= 0) return false;
  for (const char* gain : {"speed_kp", "speed_ki"}) {
    draft_->Set(TableOf(SettingPlace::kAutopilot),
                {.key = gain,
                 .value = "0",
                 .origin = origin,
                 .text = line.text,
                 .reason = "The thrust follows the wanted speed alone."});
  }
  return true;
}

void VehicleImport::SetSimDefaults() {
  const std::string craft = TableOf(SettingPlace::kCraft);
  const auto set = [&](const char* key, const char* value, const char* reason) {
    if (draft_->IsSet(craft, key)) return;
    draft_->Set(craft, {.key = key, .value = value, .origin = "", .text = "", .reason = reason});
  };
  if (has_sim_ && !is_underwater_) {
    constexpr char kAsThere[] = "As uSimMarine has it where it is not given.";
    set("turn_rate_degps", "70", kAsThere);
    set("turn_speed_loss", "0.85", kAsThere);
    set("max_deceleration_mps2", "0.5", kAsThere);
    set("max_acceleration_mps2", kNoAcceleration_mps2,
        "uSimMarine has no limit where it is not given.");
    set("max_rudder_rate_degps", kNoRudderRate_degps,
        "uSimMarine has no limit where it is not given.");
  }
  if (draft_->IsSet(craft, "turn_rate_degps")) {
    constexpr char kTurn[] = "As uSimMarine turns.";
    set("full_turn_speed_mps", turns_by_speed_ ? "5" : "0.01", kTurn);
    set("full_turn_thrust_pct", "50", kTurn);
  }
}

void VehicleImport::Finish() {
  SetGathered(id_, "start", start_);
  thrust_.Finish(TableOf(SettingPlace::kCraft), draft_);
  SetGathered(TableOf(SettingPlace::kReporter), "extra", extra_);
  SetSimDefaults();
  if (drift_.origins.empty()) return;
  const std::string table = id_ + ".drift";
  const auto set = [&](std::string key, std::string value, bool names_lines) {
    draft_->Set(table, {.key = std::move(key),
                        .value = std::move(value),
                        .origin = names_lines ? drift_.origins : "",
                        .text = names_lines ? drift_.texts : "",
                        .reason = ""});
  };
  set("at_s", "0", false);
  set("vehicle", TomlString(name_), false);
  set("sim_command", TomlString("drift"), false);
  // Drops the 1e-17 that a sine leaves.
  drift_mps_ = (drift_mps_ * 1e9).array().round() / 1e9;
  set("values",
      fmt::format("[{}, {}]", TomlNumber(drift_mps_.x() + 0.0), TomlNumber(drift_mps_.y() + 0.0)),
      true);
}

}  // namespace shoal
