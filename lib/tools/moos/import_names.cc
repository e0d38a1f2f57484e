#include "lib/tools/moos/import_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "lib/base/text/letters.h"
#include "lib/mission/model/names.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/import_settings.h"
#include "lib/tools/moos/link_factor.h"

namespace shoal {

bool IsVehicleApp(std::string_view app_class) {
  return app_class == "pnodereporter" || app_class == "usimmarine" || app_class == "phelmivp" ||
         app_class == "pmarinepid";
}

bool IsUnderwaterType(std::string_view platform_type) {
  const std::string type = LowerCase(platform_type.substr(0, 16));
  return type == "uuv" || type == "auv" || type == "glider";
}

std::string AppNameOfRun(std::string_view value) {
  return std::string(value.substr(0, value.find_first_of(" \t@~")));
}

std::string AppOfRun(std::string_view value) { return AppClass(AppNameOfRun(value)); }

bool DescribesVehicle(const MoosFile& file) {
  for (const MoosBlock& block : file.blocks) {
    const std::string app_class = AppClass(block.app);
    if (IsVehicleApp(app_class)) return true;
    if (app_class != "antler") continue;
    for (const MoosLine& line : block.lines) {
      if (LowerCase(line.key) == "run" && IsVehicleApp(AppOfRun(line.value))) return true;
    }
  }
  return false;
}

std::string GlobalValue(const MoosFile& file, std::string_view key) {
  std::string value;
  for (const MoosLine& line : file.globals) {
    if (LowerCase(line.key) == key) value = line.value;
  }
  return value;
}

std::string Stem(std::string_view path) {
  const size_t slash = path.find_last_of('/');
  const std::string_view file = slash == std::string_view::npos ? path : path.substr(slash + 1);
  return std::string(file.substr(0, file.find_last_of('.')));
}

std::vector<std::string> VehiclesOfRules(const MoosFile& file) {
  std::vector<std::string> names;
  for (const MoosBlock& block : file.blocks) {
    if (AppClass(block.app) != "ufldnodecomms") continue;
    for (const MoosLine& line : block.lines) {
      if (!IsLinkFactor(line.key)) continue;
      if (const auto factor = ParseLinkFactor(line)) names.push_back(factor->vehicle);
    }
  }
  return names;
}

bool VehicleNames::IsTaken(std::string_view name) const { return taken_.contains(LowerCase(name)); }

std::string VehicleNames::Take(std::string_view wanted) {
  constexpr size_t kLongest = 28;  // Of 32, with room for a number.
  std::string name(wanted);
  if (!NameProblem(wanted).empty()) {
    name.resize(std::min(name.size(), kLongest));
    for (char& c : name) {
      if (!IsNameCharacter(c)) c = '_';
    }
  }
  std::string candidate = name.empty() ? "vehicle" : name;
  for (int i = 2; !NameProblem(candidate).empty() || IsTaken(candidate); ++i) {
    candidate = fmt::format("{}_{}", name.substr(0, kLongest), i);
  }
  taken_.insert(LowerCase(candidate));
  return candidate;
}

}  // namespace shoal
