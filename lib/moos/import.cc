#include "lib/moos/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "lib/mission/suggest.h"
#include "lib/mission/table_writer.h"
#include "lib/moos/fields.h"
#include "lib/moos/import_names.h"
#include "lib/moos/import_settings.h"
#include "lib/moos/import_timer.h"
#include "lib/moos/import_vehicle.h"
#include "lib/moos/mission_draft.h"
#include "lib/moos/moos_file.h"

namespace shoal {
namespace {

constexpr std::string_view kMission = "mission";
constexpr std::string_view kCommsTable = "comms";
constexpr std::string_view kRest = "rest";

class Importer {
 public:
  explicit Importer(std::span<const MoosSource> sources) {
    for (const MoosSource& source : sources) {
      files_.push_back(ParseMoosFile(source.text, source.name));
    }
  }

  MoosImport Run() {
    MissionDraft draft(Preamble());
    draft.AddTable(std::string(kMission), "[mission]", true);
    draft.AddTable(std::string(kCommsTable), "[comms]");
    NameVehicles();
    for (VehicleImport& vehicle : vehicles_) vehicle.AddTables(&draft);
    for (VehicleImport& vehicle : vehicles_) vehicle.AddEvents();
    const double last_event_s = AddTimerEvents(&draft);
    draft.AddTable(std::string(kRest), "# What else stands in the files.");
    draft_ = &draft;
    Assume(kMission, "duration_s", TomlNumber(std::max(600.0, std::ceil(last_event_s) + 60)),
           "Assumed: MOOS missions have no end of their own.");
    for (size_t i = 0; i < files_.size(); ++i) TakeFile(files_[i], VehicleOf(i));
    TakeFactors();
    for (VehicleImport& vehicle : vehicles_) vehicle.Finish();
    WarnOfTasks();
    for (std::string& refused : draft.MakeLoadable()) Warn(std::move(refused));
    const auto is_imported = [](const VehicleImport& vehicle) { return vehicle.is_imported(); };
    const auto num_vehicles = std::count_if(vehicles_.begin(), vehicles_.end(), is_imported);
    return {.mission = draft.Text(),
            .warnings = std::move(warnings_),
            .num_vehicles = static_cast<size_t>(num_vehicles)};
  }

 private:
  void Warn(std::string warning) { warnings_.push_back(std::move(warning)); }

  void Assume(std::string_view table, std::string key, std::string value, std::string reason) {
    draft_->Set(table, {.key = std::move(key),
                        .value = std::move(value),
                        .origin = "",
                        .text = "",
                        .reason = std::move(reason)});
  }

  std::string Preamble() const {
    std::string names;
    std::string warp;
    for (const MoosFile& file : files_) {
      names += " " + file.name;
      if (const std::string value = GlobalValue(file, "moostimewarp"); warp.empty()) warp = value;
    }
    std::string text = "# Made by: shoal import" + names +
                       "\n#\n"
                       "# Settings name the line that they come from. Lines that shoal has no use "
                       "for are comments\n"
                       "# that state why. docs/coming_from_moos.md explains the rest.\n#\n"
                       "# Vehicles wait for `shoal send all deploy`, or for an [[event]] with "
                       "command = \"deploy\".\n";
    if (!warp.empty()) text += "# MOOSTimeWarp: shoal run MISSION.toml --warp " + warp + "\n";
    return text;
  }

  /// One vehicle per file that describes one; where none does, those that the broker's rules name,
  /// or a single one made up.
  void NameVehicles() {
    VehicleNames names;
    for (size_t i = 0; i < files_.size(); ++i) {
      if (!DescribesVehicle(files_[i])) continue;
      const std::string community = GlobalValue(files_[i], "community");
      const bool is_usable = !community.empty() && community.find('$') == std::string::npos;
      const std::string wanted = is_usable ? community : Stem(files_[i].name);
      const std::string name = names.Take(wanted);
      std::string reason;
      if (name != wanted) reason = "Assumed: shoal cannot call a vehicle " + Quoted(wanted) + ".";
      if (!is_usable) reason = "Assumed: the file's name, since it has no Community.";
      if (!reason.empty()) Warn(files_[i].name + ": the vehicle is named " + name);
      vehicles_.emplace_back(vehicles_.size(), name, reason, true, IsUnderwater(files_[i], name));
      file_of_vehicle_.push_back(i);
    }
    if (!vehicles_.empty()) return;
    for (const MoosFile& file : files_) {
      for (const std::string& name : VehiclesOfRules(file)) {
        if (!names.IsTaken(name)) MakeUpVehicle(names.Take(name));
      }
    }
    if (vehicles_.empty()) MakeUpVehicle(names.Take("alpha"));
    Warn(
        "no file describes a vehicle: the mission has made-up ones; give the vehicles' .moos files "
        "too, or describe them by hand in [[vehicle]]");
  }

  void MakeUpVehicle(const std::string& name) {
    vehicles_.emplace_back(vehicles_.size(), name,
                           "Made up: no file describes a vehicle (pNodeReporter, uSimMarine, "
                           "pHelmIvP, pMarinePID).",
                           false, false);
  }

  /// Returns true where pNodeReporter names a type that dives, and warns of what becomes of it.
  bool IsUnderwater(const MoosFile& file, const std::string& name) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "pnodereporter") continue;
      for (const MoosLine& line : block.lines) {
        const std::string key = LowerCase(line.key);
        if ((key != "platform_type" && key != "vessel_type") || !IsUnderwaterType(line.value)) {
          continue;
        }
        Warn(fmt::format(
            "{}:{}: {}: {} becomes a Remus 100 (model = \"remus100\"), shoal's only underwater "
            "vehicle: what uSimMarine and pMarinePID set for its motion is left out",
            file.name, line.number, line.text, name));
        return true;
      }
    }
    return false;
  }

  /// Adds an [[event]] for each event of a script that has a counterpart; the others are kept.
  /// Returns the time of the last.
  double AddTimerEvents(MissionDraft* draft) {
    std::vector<std::string> names;
    for (const VehicleImport& vehicle : vehicles_) names.push_back(vehicle.name());
    double last_s = 0;
    for (size_t i = 0; i < files_.size(); ++i) {
      const VehicleImport* vehicle = VehicleOf(i);
      for (const MoosBlock& block : files_[i].blocks) {
        if (AppClass(block.app) != "utimerscript") continue;
        TimerScript& script = scripts_[&block];
        script = ReadTimerScript(block, vehicle == nullptr ? "" : vehicle->name(), names);
        for (const TimerEvent& event : script.events) {
          if (event.keys.empty()) continue;
          AddTimerEvent(files_[i], event, draft);
          last_s = std::max(last_s, event.at_s);
        }
      }
    }
    return last_s;
  }

  static void AddTimerEvent(const MoosFile& file, const TimerEvent& event, MissionDraft* draft) {
    const std::string origin = fmt::format("{}:{}", file.name, event.line);
    const std::string table = "event " + origin;
    draft->AddTable(table, "[[event]]");
    draft->Set(table, {.key = "at_s",
                       .value = TomlNumber(event.at_s),
                       .origin = origin,
                       .text = "event at " + TomlNumber(event.at_s) + " s",
                       .reason = event.assumed.empty() ? "" : "Assumed: " + event.assumed + "."});
    for (const auto& [key, value] : event.keys) {
      draft->Set(table, {.key = key, .value = value, .origin = "", .text = "", .reason = ""});
    }
  }

  void TakeTimerLine(const TimerScript& script, const std::string& origin, const MoosLine& line) {
    std::string reason = std::string(KeyCounterpart("utimerscript", line.key));
    bool is_warning = false;
    for (const auto& [number, loss] : script.losses) {
      if (number != line.number) continue;
      reason = loss;
      is_warning = true;
    }
    for (const TimerEvent& event : script.events) {
      if (event.line != line.number) continue;
      if (!event.keys.empty()) return;
      reason = event.reason;
      is_warning = !event.is_needless;
    }
    draft_->Remark(kRest, origin, line.text, reason);
    if (is_warning) Warn(origin + ": " + line.text + ": " + reason);
  }

  /// A vehicle without tasks does nothing, and a mission in which nothing happens passes.
  void WarnOfTasks() {
    for (size_t i = 0; i < file_of_vehicle_.size(); ++i) {
      const MoosFile& file = files_[file_of_vehicle_[i]];
      std::string where = file.name;
      for (const MoosBlock& block : file.blocks) {
        for (const MoosLine& line : block.lines) {
          const bool is_helm = AppClass(block.app) == "phelmivp";
          if (is_helm && LowerCase(line.key) == "behaviors") {
            where = fmt::format("{}:{}: {}", file.name, line.number, line.text);
          }
        }
      }
      Warn(fmt::format(
          "{}: behaviors are not read: {} has no tasks and stays where it is; write a "
          "[[vehicle.task]], and an [[event]] with command = \"deploy\" where there is none",
          where, vehicles_[i].name()));
    }
  }

  VehicleImport* VehicleOf(size_t file) {
    for (size_t i = 0; i < file_of_vehicle_.size(); ++i) {
      if (file_of_vehicle_[i] == file) return &vehicles_[i];
    }
    return nullptr;
  }

  void TakeFile(const MoosFile& file, VehicleImport* vehicle) {
    TakeGlobals(file, vehicle);
    for (const MoosBlock& block : file.blocks) TakeBlock(file, block, vehicle);
    for (const MoosOddLine& line : file.odd_lines) {
      const std::string origin = fmt::format("{}:{}", file.name, line.number);
      draft_->Remark(kRest, origin, line.text, line.reason);
      Warn(origin + ": " + Quoted(line.text) + " " + line.reason);
    }
  }

  void TakeGlobals(const MoosFile& file, const VehicleImport* vehicle) {
    std::map<std::string, const MoosLine*> origin;
    for (const MoosLine& line : file.globals) {
      const std::string key = LowerCase(line.key);
      const std::string where = fmt::format("{}:{}", file.name, line.number);
      if (key == "latorigin" || key == "longorigin") {
        const MoosLine*& kept = origin[key];
        if (kept != nullptr) {
          draft_->Remark(kMission, fmt::format("{}:{}", file.name, kept->number), kept->text,
                         "replaced by " + where);
        }
        kept = &line;
      } else if (key == "community" && vehicle != nullptr) {
        draft_->Remark(vehicle->table(), where, line.text, "the vehicle's name");
      } else if (key == "community") {
        draft_->Remark(kRest, where, line.text, "the shore has no name in shoal");
      } else if (key == "moostimewarp") {
        draft_->Remark(kMission, where, line.text, "shoal run --warp " + line.value);
      } else {
        draft_->Remark(kRest, where, line.text, std::string(KeyCounterpart("", key)));
      }
    }
    if (origin.size() == 2) TakeOrigin(file, *origin["latorigin"], *origin["longorigin"]);
    if (origin.size() != 1) return;
    const MoosLine& line = *origin.begin()->second;
    const std::string where = fmt::format("{}:{}", file.name, line.number);
    draft_->Remark(kMission, where, line.text, "an origin needs LatOrigin and LongOrigin");
    Warn(where + ": an origin needs LatOrigin and LongOrigin; only one of them is there");
  }

  void TakeOrigin(const MoosFile& file, const MoosLine& lat, const MoosLine& lon) {
    const auto lat_deg = SettingValue(SettingKind::kNumber, lat.value);
    const auto lon_deg = SettingValue(SettingKind::kNumber, lon.value);
    const std::string where =
        fmt::format("{}:{}, {}:{}", file.name, lat.number, file.name, lon.number);
    const std::string text = lat.text + ", " + lon.text;
    if (!lat_deg || !lon_deg) {
      draft_->Remark(kMission, where, text, "not two numbers");
      Warn(where + ": " + text + ": not two numbers");
      return;
    }
    draft_->Set(kMission,
                {.key = "origin",
                 .value = fmt::format("{{lat_deg = {}, lon_deg = {}}}", *lat_deg, *lon_deg),
                 .origin = where,
                 .text = text,
                 .reason = ""});
  }

  void TakeBlock(const MoosFile& file, const MoosBlock& block, VehicleImport* vehicle) {
    const std::string app_class = AppClass(block.app);
    const std::string where = fmt::format("{}:{}", file.name, block.number);
    const bool is_known = app_class == "ufldnodecomms" || app_class == "antler" ||
                          app_class == "utimerscript" ||
                          (vehicle != nullptr && IsVehicleApp(app_class));
    if (!is_known) {
      const std::string_view counterpart = AppCounterpart(app_class);
      draft_->Remark(kRest, where, "ProcessConfig = " + block.app,
                     counterpart.empty() ? "no counterpart in shoal" : std::string(counterpart));
    }
    for (const MoosLine& line : block.lines) {
      const std::string origin = fmt::format("{}:{}", file.name, line.number);
      if (app_class == "antler") {
        TakeAntlerLine(origin, line);
        continue;
      }
      if (app_class == "utimerscript") {
        TakeTimerLine(scripts_.at(&block), origin, line);
        continue;
      }
      const bool is_taken =
          (app_class == "ufldnodecomms" && TakeFactorLine(origin, line)) ||
          (vehicle != nullptr && vehicle->Take(app_class, origin, line, &warnings_));
      if (!is_taken) TakeSetting(app_class, origin, line, vehicle);
    }
  }

  void TakeAntlerLine(const std::string& origin, const MoosLine& line) {
    std::string_view reason = "no counterpart in shoal";
    if (LowerCase(line.key) == "run") {
      const std::string_view counterpart = AppCounterpart(AppOfRun(line.value));
      reason = counterpart.empty() ? "no counterpart in shoal; a program of yours that uses LCM "
                                     "can be a [[participant]]"
                                   : counterpart;
    }
    draft_->Remark(kRest, origin, line.text, std::string(reason));
  }

  /// Keeps stealth and earange until all vehicles are known.
  bool TakeFactorLine(const std::string& origin, const MoosLine& line) {
    if (!IsLinkFactor(line.key)) return false;
    if (const auto factor = ParseLinkFactor(line)) {
      factors_.push_back({origin, line.text, *factor});
      return true;
    }
    const std::string reason = fmt::format("not vname=NAME, {}=NUMBER", LowerCase(line.key));
    draft_->Remark(kCommsTable, origin, line.text, reason);
    Warn(origin + ": " + line.text + ": " + reason);
    return true;
  }

  void TakeFactors() {
    for (const auto& each : factors_) {
      const auto at = std::find_if(vehicles_.begin(), vehicles_.end(), [&](const auto& vehicle) {
        return LowerCase(vehicle.name()) == LowerCase(each.factor.vehicle);
      });
      if (at == vehicles_.end()) {
        const std::string reason = "none of the files is of this vehicle";
        draft_->Remark(kCommsTable, each.origin, each.text, reason);
        Warn(fmt::format("{}: {}: {}", each.origin, each.text, reason));
        continue;
      }
      draft_->Set(at->table(), {.key = each.factor.key,
                                .value = each.factor.value,
                                .origin = each.origin,
                                .text = each.text,
                                .reason = ""});
    }
  }

  void TakeSetting(const std::string& app_class, const std::string& origin, const MoosLine& line,
                   const VehicleImport* vehicle) {
    const SettingRule* rule = FindSetting(app_class, line.key);
    const bool is_comms = app_class == "ufldnodecomms";
    if (rule == nullptr || (!is_comms && vehicle == nullptr)) {
      const std::string table = is_comms             ? std::string(kCommsTable)
                                : vehicle != nullptr ? vehicle->TableOfApp(app_class)
                                                     : std::string(kRest);
      draft_->Remark(table.empty() ? kRest : std::string_view(table), origin, line.text,
                     std::string(KeyCounterpart(app_class, line.key)));
      return;
    }
    const std::string table = is_comms ? std::string(kCommsTable) : vehicle->TableOf(rule->place);
    const bool is_of_motion =
        rule->place == SettingPlace::kCraft || rule->place == SettingPlace::kAutopilot;
    if (!is_comms && is_of_motion && vehicle->is_underwater()) {
      draft_->Remark(table, origin, line.text,
                     "the Remus 100 has motion and autopilots of its own");
      return;
    }
    const auto value = SettingValue(rule->kind, line.value);
    if (!value) {
      const std::string reason = fmt::format("not {}", KindText(rule->kind));
      draft_->Remark(table, origin, line.text, reason);
      Warn(origin + ": " + line.text + ": " + reason);
      return;
    }
    draft_->Set(table, {.key = std::string(rule->key),
                        .value = *value,
                        .origin = origin,
                        .text = line.text,
                        .reason = std::string(rule->remark)});
  }

  struct KeptFactor {
    std::string origin;
    std::string text;
    LinkFactorSetting factor;
  };

  std::vector<MoosFile> files_;
  std::vector<VehicleImport> vehicles_;
  std::vector<size_t> file_of_vehicle_;
  std::vector<KeptFactor> factors_;
  std::map<const MoosBlock*, TimerScript> scripts_;
  std::vector<std::string> warnings_;
  MissionDraft* draft_ = nullptr;
};

}  // namespace

MoosImport ImportMoos(std::span<const MoosSource> sources) { return Importer(sources).Run(); }

}  // namespace shoal
