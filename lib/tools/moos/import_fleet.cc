#include "lib/tools/moos/import_fleet.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/import_names.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {
namespace {

/// Returns true where pNodeReporter names a type that dives, and warns of what becomes of it.
bool IsUnderwater(const MoosFile& file, const std::string& name, ImportLosses* losses) {
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "pnodereporter") continue;
    for (const MoosLine& line : block.lines) {
      const std::string key = LowerCase(line.key);
      if ((key != "platform_type" && key != "vessel_type") || !IsUnderwaterType(line.value)) {
        continue;
      }
      losses->Warn(fmt::format(
          "{}: {}: {} becomes a Remus 100 (model = \"remus100\"), shoal's only underwater "
          "vehicle: what uSimMarine and pMarinePID set for its motion is left out",
          line.origin, line.text, name));
      return true;
    }
  }
  return false;
}

}  // namespace

void FleetImport::Name(const std::vector<MoosFile>& files, ImportLosses* losses) {
  VehicleNames names;
  for (size_t i = 0; i < files.size(); ++i) {
    if (!DescribesVehicle(files[i])) continue;
    const std::string community = GlobalValue(files[i], "community");
    const bool is_usable = !community.empty() && community.find('$') == std::string::npos;
    const std::string wanted = is_usable ? community : Stem(files[i].name);
    const std::string name = names.Take(wanted);
    std::string reason;
    if (name != wanted) reason = "Assumed: shoal cannot call a vehicle " + Quoted(wanted) + ".";
    if (!is_usable) reason = "Assumed: the file's name, since it has no Community.";
    if (!reason.empty()) losses->Warn(files[i].name + ": the vehicle is named " + name);
    vehicles_.emplace_back(vehicles_.size(), name, reason, true,
                           IsUnderwater(files[i], name, losses));
    file_of_vehicle_.push_back(i);
  }
  if (!vehicles_.empty()) return;
  for (const MoosFile& file : files) {
    for (const std::string& name : VehiclesOfRules(file)) {
      if (!names.IsTaken(name)) MakeUpVehicle(names.Take(name));
    }
  }
  if (vehicles_.empty()) MakeUpVehicle(names.Take("alpha"));
  losses->Warn(
      "no file describes a vehicle: the mission has made-up ones; give the vehicles' .moos files "
      "too, or describe them by hand in [[vehicle]]");
}

void FleetImport::MakeUpVehicle(const std::string& name) {
  vehicles_.emplace_back(vehicles_.size(), name,
                         "Made up: no file describes a vehicle (pNodeReporter, uSimMarine, "
                         "pHelmIvP, pMarinePID).",
                         false, false);
}

VehicleImport* FleetImport::OfFile(size_t file) {
  for (size_t i = 0; i < file_of_vehicle_.size(); ++i) {
    if (file_of_vehicle_[i] == file) return &vehicles_[i];
  }
  return nullptr;
}

std::vector<std::string> FleetImport::Names() const {
  std::vector<std::string> names;
  for (const VehicleImport& vehicle : vehicles_) names.push_back(vehicle.name());
  return names;
}

bool FleetImport::HasVariable(std::string_view name, std::string_view variable) const {
  return std::any_of(vehicles_.begin(), vehicles_.end(), [&](const VehicleImport& vehicle) {
    return vehicle.name() == name && vehicle.behaviors().variables.contains(variable);
  });
}

}  // namespace shoal
