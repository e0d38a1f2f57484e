#include "lib/tools/moos/moos_bridges.h"

#include <cstddef>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/run/moos_text/fields.h"

namespace shoal {

bool MoosBridges::Add(const MoosLine& line) {
  if (LowerCase(line.key) != "bridge") return false;
  const auto fields = ParseFields(line.value);
  if (!fields.ok()) return false;
  Bridge bridge;
  for (const MoosField& field : *fields) {
    const std::string key = LowerCase(field.key.substr(0, 16));
    if (key == "src") bridge.source = field.value;
    if (key == "alias") bridge.alias = field.value;
  }
  if (bridge.source.empty()) return false;
  if (bridge.alias.empty()) bridge.alias = bridge.source;
  bridges_.push_back(std::move(bridge));
  return true;
}

std::string MoosBridges::Find(std::string_view posted,
                              std::span<const std::string> vehicles) const {
  for (const Bridge& bridge : bridges_) {
    if (bridge.source == posted) return bridge.alias + "_ALL";
    for (size_t i = 0; i < vehicles.size(); ++i) {
      std::string wanted = bridge.source;
      std::string alias = bridge.alias;
      for (const auto& [macro, value] :
           {std::pair<std::string, std::string>("$N", std::to_string(i + 1)),
            {"$V", UpperCase(vehicles[i])},
            {"$v", LowerCase(vehicles[i])}}) {
        const size_t at = wanted.find(macro);
        if (at != wanted.npos) wanted.replace(at, macro.size(), value);
        const size_t there = alias.find(macro);
        if (there != alias.npos) alias.replace(there, macro.size(), value);
      }
      if (wanted == posted && wanted != bridge.source) return alias + "_" + UpperCase(vehicles[i]);
    }
  }
  return {};
}

}  // namespace shoal
