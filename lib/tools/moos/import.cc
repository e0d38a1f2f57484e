#include "lib/tools/moos/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/file/load.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/import_behaviors.h"
#include "lib/tools/moos/import_comms.h"
#include "lib/tools/moos/import_fleet.h"
#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/import_obstacles.h"
#include "lib/tools/moos/import_outlook.h"
#include "lib/tools/moos/import_posts.h"
#include "lib/tools/moos/import_scripts.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/import_sources.h"
#include "lib/tools/moos/import_vehicle.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/vehicle/vehicle/collision_watch.h"

namespace shoal {
namespace {

constexpr std::string_view kMission = "mission";
constexpr std::string_view kCommsTable = "comms";
constexpr std::string_view kRest = "rest";

/// Makes the mission of the files: what each of their lines becomes.
class Importer {
 public:
  Importer(std::span<const MoosSource> sources, const MoosImportOptions& options)
      : options_(options), sources_(sources, options, &losses_) {}

  MoosImport Run() {
    const std::vector<MoosFile>& files = sources_.files();
    std::vector<VehicleImport>& vehicles = fleet_.vehicles();
    MissionDraft draft(Preamble());
    draft.AddTable(std::string(kMission), "[mission]", true);
    draft.AddTable(std::string(kCommsTable), "[comms]");
    fleet_.Name(files, &losses_);
    ReadBehaviors();
    posts_.Read(files, &fleet_);
    scripts_.Read(files, posts_, options_.pokes, &fleet_, &losses_);
    for (VehicleImport& vehicle : vehicles) vehicle.AddTables(&draft);
    for (VehicleImport& vehicle : vehicles) vehicle.AddEvents();
    if (options_.deploys) AddDeployment(&draft);
    const double last_event_s = scripts_.AddEvents(files, &draft);
    posts_.AddOrders(files, options_.pokes, &fleet_, &draft, &losses_);
    AddObstacles(&draft);
    draft.AddTable(std::string(kRest), "# What else is in the files.");
    draft_ = &draft;
    Assume(kMission, "duration_s", TomlNumber(std::max(600.0, std::ceil(last_event_s) + 60)),
           "Assumed: MOOS missions have no end of their own.");
    for (size_t i = 0; i < files.size(); ++i) TakeFile(files[i], fleet_.OfFile(i));
    comms_.TakeDirectRoutes(files, vehicles.size(), &draft);
    comms_.SetFactors(vehicles, &draft, &losses_);
    for (VehicleImport& vehicle : vehicles) vehicle.Finish();
    WarnOfBehaviors();
    for (std::string& refused : draft.MakeLoadable()) losses_.Warn(std::move(refused));
    const auto is_imported = [](const VehicleImport& vehicle) { return vehicle.is_imported(); };
    const auto num_vehicles = std::count_if(vehicles.begin(), vehicles.end(), is_imported);
    LoadedMission loaded = LoadMissionText(draft.Text(), "draft");
    if (loaded.errors.empty() && LetsStartsTouch(loaded.mission)) {
      loaded = LoadMissionText(draft.Text(), "draft");
    }
    std::vector<VehicleOutlook> outlooks;
    if (loaded.errors.empty()) outlooks = OutlooksOf(loaded.mission);
    return {.mission = draft.Text(),
            .warnings = std::move(losses_.warnings()),
            .lost = std::move(losses_.lost()),
            .outlooks = std::move(outlooks),
            .num_vehicles = static_cast<size_t>(num_vehicles)};
  }

 private:
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
    for (const MoosFile& file : sources_.files()) {
      if (!names.ends_with(" " + file.name)) names += " " + file.name;
      if (const std::string value = GlobalValue(file, "moostimewarp"); warp.empty()) warp = value;
    }
    for (const std::string& name : sources_.BhvNames()) names += " " + CleanUtf8(name);
    std::string text = "# Made by: shoal import" + names +
                       "\n#\n"
                       "# Settings name the line that they come from. Lines that shoal has no use "
                       "for are comments\n"
                       "# that state why. docs/start/coming_from_moos.md explains the rest.\n#\n"
                       "# Vehicles wait for `shoal send all deploy`, or for an [[event]] with "
                       "command = \"deploy\".\n";
    if (!warp.empty()) text += "# MOOSTimeWarp: shoal run MISSION.toml --warp " + warp + "\n";
    return text;
  }

  /// The mission deploys its vehicles itself, as the user of a viewer does at its start.
  static void AddDeployment(MissionDraft* draft) {
    constexpr std::string_view kDeployment = "deployment";
    draft->AddTable(std::string(kDeployment), "[[event]]");
    for (const auto& [key, value] : {std::pair<std::string, std::string>("at_s", "0"),
                                     {"vehicle", TomlString("all")},
                                     {"command", TomlString("deploy")}}) {
      draft->Set(kDeployment, {.key = key, .value = value, .origin = "", .text = "", .reason = ""});
    }
  }

  /// Vessels that touch each other where they start are not a failure in MOOS-IvP. Returns false
  /// where there are none.
  bool LetsStartsTouch(const Mission& mission) {
    std::vector<double> lengths_m;
    std::vector<Eigen::Vector3d> positions_m;
    std::vector<uint32_t> all;
    for (const Vehicle& vehicle : mission.vehicles) {
      all.push_back(static_cast<uint32_t>(all.size()));
      lengths_m.push_back(vehicle.length_m);
      positions_m.emplace_back(vehicle.start.x_m, vehicle.start.y_m, vehicle.start.depth_m);
    }
    CollisionWatch watch(lengths_m);
    const auto touching = watch.Look(all, positions_m);
    if (touching.empty() || mission.collisions == CollisionVerdict::kAllowed) return false;
    Assume(kMission, "collisions", TomlString("allowed"),
           fmt::format("Assumed: {} starts {:.2f} m from {}.",
                       mission.vehicles[touching.front().second].name, touching.front().range_m,
                       mission.vehicles[touching.front().first].name));
    return true;
  }

  void AddObstacles(MissionDraft* draft) {
    for (const MoosFile& file : sources_.files()) obstacles_.Add(file, draft);
    obstacles_.AddPoints(scripts_.Points(sources_.files()), sources_.files(), draft);
    for (const std::string& warning : obstacles_.warnings()) losses_.Warn(warning);
  }

  void ReadBehaviors() {
    std::vector<VehicleImport>& vehicles = fleet_.vehicles();
    for (size_t i = 0; i < fleet_.num_described(); ++i) {
      MoosDefines defines = sources_.defines(fleet_.FileOf(i));
      PlugOptions options;
      const auto source = sources_.FindBhv(fleet_.FileOf(i), &defines, &options);
      if (!source) continue;
      defines.emplace("VNAME", vehicles[i].name());
      std::vector<std::string> contacts;
      for (const VehicleImport& other : vehicles) {
        if (&other != &vehicles[i]) contacts.push_back(other.name());
      }
      vehicles[i].SetBehaviors(
          ImportBhv(ParseBhvFile(Plug(*source, defines, options_.find, options)), contacts));
      for (const std::string& warning : vehicles[i].behaviors().warnings) losses_.Warn(warning);
      for (const std::string& loss : vehicles[i].behaviors().lost) losses_.Lose(loss);
    }
    for (const std::string& name : sources_.UnusedBhvNames()) {
      losses_.Warn(
          fmt::format("{}: no vehicle has these behaviors: name the file after the vehicle's .moos "
                      "file, or in pHelmIvP's Behaviors",
                      CleanUtf8(name)));
    }
  }

  /// A vehicle that does nothing stays where it is, and a mission in which nothing happens passes.
  void WarnOfBehaviors() {
    for (size_t i = 0; i < fleet_.num_described(); ++i) {
      const VehicleImport& vehicle = fleet_.vehicles()[i];
      if (vehicle.behaviors().num_behaviors > 0) continue;
      const MoosFile& file = sources_.files()[fleet_.FileOf(i)];
      const MoosLine* line = BehaviorsLine(file);
      const std::string where =
          line == nullptr ? file.name : fmt::format("{}: {}", line->origin, line->text);
      losses_.Warn(fmt::format(
          "{}: no behaviors are there: {} stays where it is; name its .bhv file too, or write a "
          "[[vehicle.behavior]] or [[vehicle.task]]",
          where, vehicle.name()));
    }
  }

  /// Returns true for a line without effect here, whatever its value is.
  static bool IsNeedless(std::string_view text, const VehicleImport* vehicle) {
    if (text.find('=') == text.npos) return false;
    const std::string key = LowerCase(Trimmed(text.substr(0, text.find('='))));
    if (key == "community") return vehicle == nullptr;
    return key == "serverport" || key == "serverhost" || key == "moostimewarp";
  }

  void TakeFile(const MoosFile& file, VehicleImport* vehicle) {
    TakeGlobals(file, vehicle);
    for (const MoosBlock& block : file.blocks) TakeBlock(block, vehicle);
    for (const MoosOddLine& line : file.odd_lines) {
      draft_->Remark(kRest, line.origin, line.text, line.reason);
      if (line.is_loss && !IsNeedless(line.text, vehicle)) {
        losses_.Warn(line.origin + ": " + Quoted(line.text) + " " + line.reason);
      }
    }
  }

  void TakeGlobals(const MoosFile& file, const VehicleImport* vehicle) {
    std::map<std::string, const MoosLine*> origin;
    for (const MoosLine& line : file.globals) {
      const std::string key = LowerCase(line.key);
      const std::string& where = line.origin;
      if (key == "latorigin" || key == "longorigin") {
        const MoosLine*& kept = origin[key];
        if (kept != nullptr) {
          draft_->Remark(kMission, kept->origin, kept->text, "replaced by " + where);
        }
        kept = &line;
      } else if (key == "community" && vehicle != nullptr) {
        draft_->Remark(vehicle->table(), where, line.text, "the vehicle's name");
      } else if (key == "community") {
        draft_->Remark(kRest, where, line.text, "the shore has no name in shoal");
      } else if (key == "moostimewarp") {
        draft_->Remark(kMission, where, line.text, "shoal run --warp " + line.value);
      } else {
        draft_->Remark(kRest, where, line.text, std::string(KeyCounterpart(key)));
      }
    }
    if (origin.size() == 2) TakeOrigin(*origin["latorigin"], *origin["longorigin"]);
    if (origin.size() != 1) return;
    const MoosLine& line = *origin.begin()->second;
    draft_->Remark(kMission, line.origin, line.text, "an origin needs LatOrigin and LongOrigin");
    losses_.Warn(line.origin +
                 ": an origin needs LatOrigin and LongOrigin; only one of them is there");
  }

  void TakeOrigin(const MoosLine& lat, const MoosLine& lon) {
    const auto lat_deg = SettingValue(SettingKind::kNumber, lat.value);
    const auto lon_deg = SettingValue(SettingKind::kNumber, lon.value);
    const std::string where = lat.origin + ", " + lon.origin;
    const std::string text = lat.text + ", " + lon.text;
    if (!lat_deg || !lon_deg) {
      draft_->Remark(kMission, where, text, "not two numbers");
      losses_.Warn(where + ": " + text + ": not two numbers");
      return;
    }
    draft_->Set(kMission,
                {.key = "origin",
                 .value = fmt::format("{{lat_deg = {}, lon_deg = {}}}", *lat_deg, *lon_deg),
                 .origin = where,
                 .text = text,
                 .reason = ""});
  }

  void TakeBlock(const MoosBlock& block, VehicleImport* vehicle) {
    const std::string app_class = AppClass(block.app);
    const bool is_known = app_class == "ufldnodecomms" || app_class == "antler" ||
                          app_class == "utimerscript" ||
                          (vehicle != nullptr && IsVehicleApp(app_class));
    const bool is_unknown = !is_known && AppCounterpart(app_class).empty();
    if (!is_known) {
      draft_->Remark(kRest, block.origin, "ProcessConfig = " + block.app,
                     is_unknown ? "no counterpart in shoal, as all lines of its block"
                                : std::string(AppCounterpart(app_class)));
    }
    if (is_unknown) losses_.LoseApp(block.app, block.origin);
    if (app_class == "usimmarine" && vehicle != nullptr) {
      vehicle->SetHasSim(LowerCase(block.app) != "usimmarine");
    }
    for (const MoosLine& line : block.lines) {
      const std::string& origin = line.origin;
      if (is_unknown) {
        draft_->Remark(kRest, origin, line.text, "");
        continue;
      }
      if (obstacles_.Has(origin)) {
        draft_->Remark(kRest, origin, line.text, "[[obstacle]]");
        continue;
      }
      if (app_class == "antler") {
        TakeAntlerLine(origin, line);
        continue;
      }
      if (app_class == "utimerscript") {
        scripts_.Remark(block, line, kRest, draft_, &losses_);
        continue;
      }
      if (scripts_.IsBridge(origin)) {
        draft_->Remark(kRest, origin, line.text, "counts where the shore's scripts set variables");
        continue;
      }
      if (app_class == "pmarineviewer" && IsButton(line.key)) {
        draft_->Remark(kRest, origin, line.text, posts_.Reason(block, line, &losses_));
        continue;
      }
      if (app_class == "phelmivp" && vehicle != nullptr &&
          LowerCase(line.key) == "start_in_drive" &&
          vehicle->behaviors().variables.contains("DEPLOY")) {
        draft_->Remark(vehicle->TableOf(SettingPlace::kHelm), origin, line.text,
                       "the vehicle waits for `deploy`, as its behaviors do, which need DEPLOY");
        continue;
      }
      if (app_class == "phelmivp" && vehicle != nullptr && LowerCase(line.key) == "behaviors") {
        const bool is_found = vehicle->behaviors().num_behaviors > 0;
        draft_->Remark(vehicle->TableOf(SettingPlace::kHelm), origin, line.text,
                       is_found ? "[[vehicle.behavior]]" : "no behaviors are there");
        continue;
      }
      const bool is_taken =
          (app_class == "ufldnodecomms" && comms_.Take(line, draft_, &losses_)) ||
          (vehicle != nullptr && vehicle->Take(app_class, origin, line, &losses_.warnings()));
      if (!is_taken) TakeSetting(app_class, origin, line, vehicle);
    }
  }

  void TakeAntlerLine(const std::string& origin, const MoosLine& line) {
    std::string_view reason = "no counterpart in shoal";
    if (LowerCase(line.key) == "run") {
      const std::string_view counterpart = AppCounterpart(AppOfRun(line.value));
      if (counterpart.empty()) losses_.LoseApp(AppNameOfRun(line.value), origin);
      reason = counterpart.empty() ? "no counterpart in shoal; a program of yours that uses LCM "
                                     "can be a [[participant]]"
                                   : counterpart;
    }
    draft_->Remark(kRest, origin, line.text, std::string(reason));
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
                     std::string(KeyCounterpart(line.key)));
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
      losses_.Warn(origin + ": " + line.text + ": " + reason);
      return;
    }
    draft_->Set(table, {.key = std::string(rule->key),
                        .value = *value,
                        .origin = origin,
                        .text = line.text,
                        .reason = std::string(rule->remark)});
  }

  const MoosImportOptions& options_;
  ImportLosses losses_;
  ImportSources sources_;
  FleetImport fleet_;
  PostImport posts_;
  ScriptImport scripts_;
  CommsImport comms_{std::string(kCommsTable)};
  ObstacleImport obstacles_{options_.defines, options_.find};
  MissionDraft* draft_ = nullptr;
};

}  // namespace

bool IsBhvName(std::string_view name) { return LowerCase(name).ends_with(".bhv"); }

MoosImport ImportMoos(std::span<const MoosSource> sources, const MoosImportOptions& options) {
  return Importer(sources, options).Run();
}

}  // namespace shoal
