#include "lib/tools/moos/moos_readers.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"
#include "lib/tools/moos/bhv_text.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {
namespace {

/// Returns true for apps whose lines name variables to show, log or pass on.
bool OnlyPassesOn(std::string_view app_class) {
  constexpr std::string_view kPassing[] = {
      "antler",          "uxms",           "pmarineviewer", "plogger",      "pshare",
      "ufldshorebroker", "ufldnodebroker", "uprocesswatch", "utermcommand", "ufldmessagehandler"};
  return std::find(std::begin(kPassing), std::end(kPassing), app_class) != std::end(kPassing);
}

/// Returns true for variables that apps of MOOS-IvP look at whatever their lines are.
bool IsOfApps(std::string_view variable) {
  constexpr std::string_view kBeginnings[] = {
      topics::kNav, topics::kDesired, "MOOS_",    "HELM_",     "IVPHELM_", "NODE_",   "UNC_",
      "USM_",       "DRIFT_",         "CURRENT_", "BUOYANCY",  "TRIM_",    "ROTATE_", "BHV_",
      "TRACKED_",   "KNOWN_",         "GIVEN_",   "OBM_",      "BCM_",     "CONTACT", "DEPLOY",
      "RETURN",     "STATION",        "UTS_",     "MEDIATED_", "VEHICLE_"};
  return std::any_of(std::begin(kBeginnings), std::end(kBeginnings),
                     [&](std::string_view begin) { return variable.starts_with(begin); });
}

}  // namespace

MoosReaders::MoosReaders(const std::vector<MoosFile>& files, FleetImport* fleet)
    : vehicles_(fleet->Names()) {
  for (size_t i = 0; i < files.size(); ++i) {
    const VehicleImport* vehicle = fleet->OfFile(i);
    Words words;
    if (vehicle != nullptr) words = vehicle->behaviors().words;
    for (const MoosBlock& block : files[i].blocks) {
      const std::string app_class = AppClass(block.app);
      if (OnlyPassesOn(app_class)) continue;
      for (const MoosLine& line : block.lines) {
        if (app_class == "utimerscript" && LowerCase(line.key) != "condition") continue;
        CollectVariables(line.text, &words);
      }
    }
    words_[""].insert(words.begin(), words.end());
    if (vehicle != nullptr) words_[vehicle->name()] = std::move(words);
  }
}

bool MoosReaders::IsIn(std::string_view vehicle, std::string_view variable) const {
  const auto words = words_.find(vehicle);
  return words != words_.end() && words->second.contains(variable);
}

bool MoosReaders::MayRead(std::string_view vehicle, std::string_view posted,
                          std::string_view bridged) const {
  if (IsOfApps(posted)) return true;
  std::vector<std::string> endings = {"_ALL"};
  for (const std::string& each : vehicles_) endings.push_back("_" + UpperCase(each));
  for (const std::string_view name : {posted, bridged}) {
    if (name.empty()) continue;
    if (IsIn(vehicle, name)) return true;
    const std::string upper = UpperCase(name);
    for (const std::string& ending : endings) {
      const bool ends = upper.size() > ending.size() && upper.ends_with(ending);
      if (ends && IsIn(vehicle, name.substr(0, name.size() - ending.size()))) return true;
    }
  }
  return false;
}

}  // namespace shoal
