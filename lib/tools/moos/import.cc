#include "lib/tools/moos/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/file/load.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/tools/moos/bhv_file.h"
#include "lib/tools/moos/import_behaviors.h"
#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/import_obstacles.h"
#include "lib/tools/moos/import_orders.h"
#include "lib/tools/moos/import_outlook.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/import_timer.h"
#include "lib/tools/moos/import_vehicle.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/script_timers.h"

namespace shoal {
namespace {

constexpr std::string_view kMission = "mission";
constexpr std::string_view kCommsTable = "comms";
constexpr std::string_view kRest = "rest";
constexpr char kTemplate[] = "TEMPLATE";  ///< Of --vehicle: which file it is made of.

class Importer {
 public:
  Importer(std::span<const MoosSource> sources, const MoosImportOptions& options)
      : options_(options) {
    FindTemplates(sources);
    for (const MoosSource& source : sources) {
      if (IsBhvName(source.name)) {
        bhv_sources_.push_back({.source = source, .target = {}, .defines = {}});
        continue;
      }
      MoosFile file = ParseMoosFile(Plug(source, options.defines, options.find));
      if (options.vehicles.empty() || !DescribesVehicle(file)) {
        files_.push_back(std::move(file));
        defines_.push_back(options.defines);
        continue;
      }
      for (size_t i = 0; i < options.vehicles.size(); ++i) {
        if (!IsTemplateOf(source, i)) continue;
        MoosDefines defines = options.vehicles[i];
        defines.insert(options.defines.begin(), options.defines.end());
        files_.push_back(ParseMoosFile(Plug(source, defines, options.find)));
        defines_.push_back(std::move(defines));
      }
    }
  }

  /// Adds the files of a launch script.
  void AddRuns() {
    for (const MoosRun& run : options_.runs) {
      MoosDefines defines = run.defines;
      defines.insert(options_.defines.begin(), options_.defines.end());
      if (IsBhvName(run.source.name)) {
        bhv_sources_.push_back({.source = run.source, .target = run.target, .defines = defines});
        continue;
      }
      files_.push_back(ParseMoosFile(Plug(run.source, defines, options_.find)));
      defines_.push_back(std::move(defines));
    }
  }

  MoosImport Run() {
    AddRuns();
    MissionDraft draft(Preamble());
    draft.AddTable(std::string(kMission), "[mission]", true);
    draft.AddTable(std::string(kCommsTable), "[comms]");
    NameVehicles();
    ReadBehaviors();
    ReadAllButtons();
    ReadScripts();
    for (VehicleImport& vehicle : vehicles_) vehicle.AddTables(&draft);
    for (VehicleImport& vehicle : vehicles_) vehicle.AddEvents();
    if (options_.deploys) AddDeployment(&draft);
    const double last_event_s = AddTimerEvents(&draft);
    AddOrders(&draft);
    AddObstacles(&draft);
    draft.AddTable(std::string(kRest), "# What else stands in the files.");
    draft_ = &draft;
    Assume(kMission, "duration_s", TomlNumber(std::max(600.0, std::ceil(last_event_s) + 60)),
           "Assumed: MOOS missions have no end of their own.");
    for (size_t i = 0; i < files_.size(); ++i) TakeFile(files_[i], VehicleOf(i));
    TakeDirectRoutes();
    TakeFactors();
    for (VehicleImport& vehicle : vehicles_) vehicle.Finish();
    WarnOfBehaviors();
    for (std::string& refused : draft.MakeLoadable()) Warn(std::move(refused));
    const auto is_imported = [](const VehicleImport& vehicle) { return vehicle.is_imported(); };
    const auto num_vehicles = std::count_if(vehicles_.begin(), vehicles_.end(), is_imported);
    std::string text = draft.Text();
    const LoadedMission loaded = LoadMissionText(text, "draft");
    std::vector<VehicleOutlook> outlooks;
    if (loaded.errors.empty()) outlooks = OutlooksOf(loaded.mission);
    return {.mission = std::move(text),
            .warnings = std::move(warnings_),
            .lost = std::move(lost_),
            .outlooks = std::move(outlooks),
            .num_vehicles = static_cast<size_t>(num_vehicles)};
  }

 private:
  /// Lists the files that describe vehicles.
  void FindTemplates(std::span<const MoosSource> sources) {
    if (options_.vehicles.empty()) return;
    for (const MoosSource& source : sources) {
      if (IsBhvName(source.name)) continue;
      if (DescribesVehicle(ParseMoosFile(Plug(source, options_.defines, options_.find)))) {
        templates_.push_back(source.name);
      }
    }
    const bool any_named =
        std::any_of(options_.vehicles.begin(), options_.vehicles.end(),
                    [](const MoosDefines& vehicle) { return vehicle.contains(kTemplate); });
    if (templates_.size() < 2 || any_named) return;
    const bool is_one_each = templates_.size() == options_.vehicles.size();
    Warn(fmt::format("{} templates and {} vehicles: {}; write {}=NAME.moos in --vehicle to choose",
                     templates_.size(), options_.vehicles.size(),
                     is_one_each ? "the first vehicle is of the first, and so on"
                                 : "all vehicles are of " + CleanUtf8(templates_.front()),
                     kTemplate));
  }

  /// Returns true where a vehicle is made of a template: the one that it names, or else the one in
  /// its place where there are as many of both, or else the first.
  bool IsTemplateOf(const MoosSource& source, size_t vehicle) const {
    if (templates_.size() < 2) return true;
    const auto named = options_.vehicles[vehicle].find(kTemplate);
    if (named != options_.vehicles[vehicle].end()) {
      return FileName(source.name) == FileName(named->second);
    }
    const bool is_one_each = templates_.size() == options_.vehicles.size();
    return source.name == templates_[is_one_each ? vehicle : 0];
  }

  struct BhvSource {
    MoosSource source;
    std::string target = {};   ///< What nsplug wrote; empty: it did not run.
    MoosDefines defines = {};  ///< What it was given.
    bool is_used = false;
  };

  /// Warns once of what a file has for several vehicles.
  void Warn(std::string warning) {
    if (warned_.insert(warning).second) warnings_.push_back(std::move(warning));
  }

  /// Adds to what is lost, once.
  void Lose(std::string loss) {
    if (warned_.insert("lost: " + loss).second) lost_.push_back(std::move(loss));
  }

  /// An app that shoal has nothing for is lost once, wherever it stands.
  void LoseApp(const std::string& app, const std::string& origin) {
    if (!lost_apps_.insert(AppClass(app)).second) return;
    Lose(fmt::format("{}: app {}: no counterpart in shoal", origin, CleanUtf8(app)));
  }

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
      if (!names.ends_with(" " + file.name)) names += " " + file.name;
      if (const std::string value = GlobalValue(file, "moostimewarp"); warp.empty()) warp = value;
    }
    for (const BhvSource& given : bhv_sources_) names += " " + CleanUtf8(given.source.name);
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
            "{}: {}: {} becomes a Remus 100 (model = \"remus100\"), shoal's only underwater "
            "vehicle: what uSimMarine and pMarinePID set for its motion is left out",
            line.origin, line.text, name));
        return true;
      }
    }
    return false;
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

  /// Reads the scripts; those that wait for what behaviors know become behaviors.
  void ReadScripts() {
    std::vector<std::string> names;
    for (const VehicleImport& vehicle : vehicles_) names.push_back(vehicle.name());
    for (const MoosFile& file : files_) {
      for (const MoosBlock& block : file.blocks) {
        if (AppClass(block.app) != "ufldshorebroker") continue;
        for (const MoosLine& line : block.lines) {
          if (bridges_.Add(line)) bridge_lines_.insert(line.origin);
        }
      }
    }
    for (size_t i = 0; i < files_.size(); ++i) {
      VehicleImport* vehicle = VehicleOf(i);
      for (const MoosBlock& block : files_[i].blocks) {
        if (AppClass(block.app) != "utimerscript") continue;
        TimerScript& script = scripts_[&block];
        script = ReadTimerScript(
            block, vehicle == nullptr ? "" : vehicle->name(), names,
            [this](std::string_view name, std::string_view variable) {
              return HasVariable(name, variable);
            },
            [&](std::string_view posted) { return bridges_.Find(posted, names); });
        if (vehicle != nullptr) MakeScriptTimers(&script, vehicle);
      }
    }
  }

  /// Adds an [[event]] for each event of a script that has a counterpart; the others are kept.
  /// Returns the time of the last.
  double AddTimerEvents(MissionDraft* draft) {
    double last_s = 0;
    for (const MoosFile& file : files_) {
      for (const MoosBlock& block : file.blocks) {
        const auto script = scripts_.find(&block);
        if (script == scripts_.end()) continue;
        for (const TimerEvent& event : script->second.events) {
          if (event.keys.empty()) continue;
          AddTimerEvent(event, draft);
          last_s = std::max(last_s, event.at_s);
        }
      }
    }
    return last_s;
  }

  void AddObstacles(MissionDraft* draft) {
    for (const MoosFile& file : files_) obstacles_.Add(file, draft);
    for (const std::string& warning : obstacles_.warnings()) Warn(warning);
  }

  bool HasVariable(std::string_view name, std::string_view variable) const {
    return std::any_of(vehicles_.begin(), vehicles_.end(), [&](const VehicleImport& vehicle) {
      return vehicle.name() == name && vehicle.behaviors().variables.contains(variable);
    });
  }

  void AddTimerEvent(const TimerEvent& event, MissionDraft* draft) {
    const std::string& origin = event.origin;
    const std::string table = fmt::format("event {}", num_events_++);
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
    std::string reason = std::string(KeyCounterpart(line.key));
    const bool is_taken =
        std::find(script.taken.begin(), script.taken.end(), line.number) != script.taken.end();
    if (is_taken) reason = "counts in the events of the script";
    bool is_warning = false;
    for (const auto& [number, loss] : script.losses) {
      if (number != line.number) continue;
      reason = loss;
      is_warning = true;
    }
    for (const TimerEvent& event : script.events) {
      if (event.line != line.number) continue;
      if (!event.keys.empty()) return;  // One of its rounds at least.
      reason = event.reason;
      is_warning = !event.is_needless;
    }
    draft_->Remark(kRest, origin, line.text, reason);
    if (is_warning) Warn(origin + ": " + line.text + ": " + reason);
  }

  /// Returns what pHelmIvP names as the file of behaviors; nullptr: nothing.
  static const MoosLine* BehaviorsLine(const MoosFile& file) {
    const MoosLine* named = nullptr;
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) != "phelmivp") continue;
      for (const MoosLine& line : block.lines) {
        if (LowerCase(line.key) == "behaviors") named = &line;
      }
    }
    return named;
  }

  /// Returns the given file of behaviors with this name, nullptr: there is none.
  BhvSource* GivenBhv(std::string_view name) {
    for (BhvSource& given : bhv_sources_) {
      const std::string& written = given.target.empty() ? given.source.name : given.target;
      if (FileName(written) == FileName(name)) return &given;
    }
    return nullptr;
  }

  /// Returns the file of behaviors of a vehicle's file.
  std::optional<MoosSource> FindBhv(const MoosFile& file, MoosDefines* defines) {
    std::vector<std::string> names;
    if (const MoosLine* line = BehaviorsLine(file)) {
      names.push_back(line->value);
      // What nsplug writes, and what it reads.
      const std::string written = FileName(line->value);
      if (written.starts_with("targ_")) names.push_back("meta_" + written.substr(5));
    }
    names.push_back(Stem(file.name) + ".bhv");
    for (const std::string& name : names) {
      if (BhvSource* given = GivenBhv(name)) {
        given->is_used = true;
        for (const auto& [macro, value] : given->defines) defines->insert_or_assign(macro, value);
        return given->source;
      }
    }
    if (bhv_sources_.size() == 1) {
      bhv_sources_.front().is_used = true;
      return bhv_sources_.front().source;
    }
    for (const std::string& name : names) {
      auto found = options_.find == nullptr ? std::nullopt : options_.find(name, file.name);
      if (found) return found;
    }
    return std::nullopt;
  }

  void ReadBehaviors() {
    for (size_t i = 0; i < file_of_vehicle_.size(); ++i) {
      MoosDefines defines = defines_[file_of_vehicle_[i]];
      const auto source = FindBhv(files_[file_of_vehicle_[i]], &defines);
      if (!source) continue;
      defines.emplace("VNAME", vehicles_[i].name());
      std::vector<std::string> contacts;
      for (const VehicleImport& other : vehicles_) {
        if (&other != &vehicles_[i]) contacts.push_back(other.name());
      }
      vehicles_[i].SetBehaviors(
          ImportBhv(ParseBhvFile(Plug(*source, defines, options_.find)), contacts));
      for (const std::string& warning : vehicles_[i].behaviors().warnings) Warn(warning);
      for (const std::string& loss : vehicles_[i].behaviors().lost) Lose(loss);
    }
    for (const BhvSource& given : bhv_sources_) {
      if (given.is_used || !given.target.empty()) continue;
      Warn(
          fmt::format("{}: no vehicle has these behaviors: name the file after the vehicle's .moos "
                      "file, or in pHelmIvP's Behaviors",
                      CleanUtf8(given.source.name)));
    }
  }

  /// Gives vehicles what the button that deploys them sets besides.
  void ReadAllButtons() {
    // A script that deploys sets what it means to set.
    bool deploys_by_script = false;
    for (const MoosFile& file : files_) {
      for (const MoosBlock& block : file.blocks) {
        if (AppClass(block.app) != "utimerscript") continue;
        for (const MoosLine& line : block.lines) {
          deploys_by_script =
              deploys_by_script ||
              (LowerCase(line.key) == "event" && line.value.find("var=DEPLOY") != line.value.npos);
        }
      }
    }
    for (size_t i = 0; i < files_.size(); ++i) {
      for (const MoosBlock& block : files_[i].blocks) {
        if (AppClass(block.app) != "pmarineviewer") continue;
        std::vector<MoosButton> buttons = ReadButtons(block);
        const VehicleImport* own = VehicleOf(i);
        for (VehicleImport& vehicle : vehicles_) {
          const MoosButton* deploy = FindDeployButton(buttons, vehicle.name());
          if (deploy == nullptr || (own != nullptr && own != &vehicle)) continue;
          deploy_keys_.insert({&block, deploy->key});
          KeepStation(*deploy, &vehicle);
          if (deploys_by_script) continue;
          SetButton(*deploy, own != nullptr, &vehicle);
        }
        buttons_[&block] = std::move(buttons);
      }
    }
  }

  /// `deploy` leaves STATION_KEEP alone where the button that deploys does.
  static void KeepStation(const MoosButton& button, VehicleImport* vehicle) {
    const bool is_set = std::any_of(
        button.posts.begin(), button.posts.end(),
        [](const auto& posted) { return UpperCase(posted.first).starts_with("STATION_KEEP"); });
    if (!is_set && vehicle->behaviors().variables.contains("STATION_KEEP")) {
      vehicle->KeepStation(button.origins);
    }
  }

  void SetButton(const MoosButton& button, bool is_own, VehicleImport* vehicle) {
    std::vector<std::pair<std::string, std::string>> settings;
    for (const auto& [posted, value] : button.posts) {
      const std::string variable =
          VariableOfPost(posted, is_own || vehicles_.size() == 1, *vehicle);
      // The order `deploy` sets these itself.
      if (variable.empty() || variable == "DEPLOY" ||
          ((variable == "RETURN" || variable == "STATION_KEEP") && LowerCase(value) == "false") ||
          value.find('$') != value.npos) {
        continue;
      }
      settings.emplace_back(variable, value);
    }
    if (!settings.empty()) vehicle->SetWithDeploy(settings, button.origins);
  }

  /// Adds an [[order]] for each further button, and for what the launch script pokes.
  void AddOrders(MissionDraft* draft) {
    for (size_t i = 0; i < files_.size(); ++i) {
      for (const MoosBlock& block : files_[i].blocks) {
        const auto buttons = buttons_.find(&block);
        if (buttons == buttons_.end()) continue;
        for (const MoosButton& button : buttons->second) {
          if (deploy_keys_.contains({&block, button.key})) continue;
          const std::string name = orders_.Add(button, VehicleOf(i), vehicles_, draft);
          button_orders_[button.origins] += name.empty() ? "" : "shoal send " + name + "\n";
        }
      }
    }
    for (const MoosButton& poke : options_.pokes) {
      const std::string name = orders_.Add(poke, nullptr, vehicles_, draft);
      if (name.empty()) Lose(poke.origins + ": uPokeDB: it sets nothing that behaviors look at");
    }
  }

  /// A button is what `deploy` sets, an order, or without effect.
  std::string ButtonReason(const MoosBlock& block, const MoosLine& line) {
    const std::string key = LowerCase(line.key);
    if (deploy_keys_.contains({&block, key})) return "shoal send all deploy sets this";
    for (const MoosButton& button : buttons_.at(&block)) {
      if ((button.key != key && key != "action+") ||
          button.origins.find(line.origin) == button.origins.npos)
        continue;
      std::string orders = button_orders_.at(button.origins);
      if (orders.empty()) break;
      orders.pop_back();
      std::replace(orders.begin(), orders.end(), '\n', ',');
      return "[[order]]: " + orders;
    }
    Lose(fmt::format("{}: {}: it sets nothing that behaviors look at", line.origin, line.text));
    return "no counterpart in shoal";
  }

  /// A vehicle that does nothing stays where it is, and a mission in which nothing happens passes.
  void WarnOfBehaviors() {
    for (size_t i = 0; i < file_of_vehicle_.size(); ++i) {
      if (vehicles_[i].behaviors().num_behaviors > 0) continue;
      const MoosFile& file = files_[file_of_vehicle_[i]];
      const MoosLine* line = BehaviorsLine(file);
      const std::string where =
          line == nullptr ? file.name : fmt::format("{}: {}", line->origin, line->text);
      Warn(fmt::format(
          "{}: no behaviors are there: {} stays where it is; name its .bhv file too, or write a "
          "[[vehicle.behavior]] or [[vehicle.task]]",
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
    for (const MoosBlock& block : file.blocks) TakeBlock(block, vehicle);
    for (const MoosOddLine& line : file.odd_lines) {
      draft_->Remark(kRest, line.origin, line.text, line.reason);
      if (line.is_loss) Warn(line.origin + ": " + Quoted(line.text) + " " + line.reason);
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
    Warn(line.origin + ": an origin needs LatOrigin and LongOrigin; only one of them is there");
  }

  void TakeOrigin(const MoosLine& lat, const MoosLine& lon) {
    const auto lat_deg = SettingValue(SettingKind::kNumber, lat.value);
    const auto lon_deg = SettingValue(SettingKind::kNumber, lon.value);
    const std::string where = lat.origin + ", " + lon.origin;
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
    if (is_unknown) LoseApp(block.app, block.origin);
    if (app_class == "usimmarine" && vehicle != nullptr) vehicle->SetHasSim();
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
        TakeTimerLine(scripts_.at(&block), origin, line);
        continue;
      }
      if (bridge_lines_.contains(origin)) {
        draft_->Remark(kRest, origin, line.text, "counts where the shore's scripts set variables");
        continue;
      }
      if (app_class == "pmarineviewer" && IsButton(line.key)) {
        draft_->Remark(kRest, origin, line.text, ButtonReason(block, line));
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
          (app_class == "ufldnodecomms" && TakeFactorLine(origin, line)) ||
          (vehicle != nullptr && vehicle->Take(app_class, origin, line, &warnings_));
      if (!is_taken) TakeSetting(app_class, origin, line, vehicle);
    }
  }

  void TakeAntlerLine(const std::string& origin, const MoosLine& line) {
    std::string_view reason = "no counterpart in shoal";
    if (LowerCase(line.key) == "run") {
      const std::string_view counterpart = AppCounterpart(AppOfRun(line.value));
      if (counterpart.empty()) LoseApp(AppNameOfRun(line.value), origin);
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

  /// Without uFldNodeComms, pShare takes node reports from vehicle to vehicle at any range.
  void TakeDirectRoutes() {
    const MoosLine* route = nullptr;
    for (const MoosFile& file : files_) {
      for (const MoosBlock& block : file.blocks) {
        if (AppClass(block.app) == "ufldnodecomms") return;
        if (AppClass(block.app) != "pshare") continue;
        for (const MoosLine& line : block.lines) {
          const bool is_report = line.value.find(topics::kNodeReport) != line.value.npos;
          if (LowerCase(line.key) == "output" && is_report && route == nullptr) route = &line;
        }
      }
    }
    if (route == nullptr || vehicles_.size() < 2) return;
    draft_->Set(kCommsTable, {.key = "comms_range",
                              .value = TomlString("nolimit"),
                              .origin = route->origin,
                              .text = route->text,
                              .reason = "Without uFldNodeComms reports go at any range."});
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

  const MoosImportOptions& options_;
  std::vector<std::string> templates_;  ///< Names of files that describe vehicles.
  std::vector<BhvSource> bhv_sources_;
  std::vector<MoosFile> files_;
  std::vector<MoosDefines> defines_;  ///< Of each file.
  std::vector<VehicleImport> vehicles_;
  std::vector<size_t> file_of_vehicle_;
  std::vector<KeptFactor> factors_;
  std::map<const MoosBlock*, TimerScript> scripts_;
  std::map<const MoosBlock*, std::vector<MoosButton>> buttons_;
  OrderImport orders_;
  std::map<std::string, std::string> button_orders_;  ///< Commands, a line each, by origins.
  std::vector<std::string> lost_;
  std::set<std::string> lost_apps_;  ///< Their classes.
  std::set<std::pair<const MoosBlock*, std::string>> deploy_keys_;
  std::vector<std::string> warnings_;
  std::set<std::string> warned_;
  MoosBridges bridges_;
  std::set<std::string> bridge_lines_;
  size_t num_events_ = 0;
  ObstacleImport obstacles_{options_.defines, options_.find};
  MissionDraft* draft_ = nullptr;
};

}  // namespace

bool IsBhvName(std::string_view name) { return LowerCase(name).ends_with(".bhv"); }

MoosImport ImportMoos(std::span<const MoosSource> sources, const MoosImportOptions& options) {
  return Importer(sources, options).Run();
}

}  // namespace shoal
