#include "lib/tools/moos/import_comms.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/base/text/letters.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/moos/import_settings.h"

namespace shoal {
bool CommsImport::Take(const MoosLine& line, MissionDraft* draft, ImportLosses* losses) {
  const std::string& origin = line.origin;
  if (!IsLinkFactor(line.key)) return false;
  if (const auto factor = ParseLinkFactor(line)) {
    factors_.push_back({origin, line.text, *factor});
    return true;
  }
  const std::string reason = fmt::format("not vname=NAME, {}=NUMBER", LowerCase(line.key));
  draft->Remark(table_, origin, line.text, reason);
  losses->Warn(origin + ": " + line.text + ": " + reason);
  return true;
}

void CommsImport::TakeDirectRoutes(const std::vector<MoosFile>& files, size_t num_vehicles,
                                   MissionDraft* draft) const {
  const MoosLine* route = nullptr;
  for (const MoosFile& file : files) {
    for (const MoosBlock& block : file.blocks) {
      if (AppClass(block.app) == "ufldnodecomms") return;
      if (AppClass(block.app) != "pshare") continue;
      for (const MoosLine& line : block.lines) {
        const bool is_report = line.value.find(topics::kNodeReport) != line.value.npos;
        if (LowerCase(line.key) == "output" && is_report && route == nullptr) route = &line;
      }
    }
  }
  if (route == nullptr || num_vehicles < 2) return;
  draft->Set(table_, {.key = "comms_range",
                      .value = TomlString("nolimit"),
                      .origin = route->origin,
                      .text = route->text,
                      .reason = "Without uFldNodeComms reports go at any range."});
}

void CommsImport::SetFactors(const std::vector<VehicleImport>& vehicles, MissionDraft* draft,
                             ImportLosses* losses) const {
  for (const auto& each : factors_) {
    const auto at = std::find_if(vehicles.begin(), vehicles.end(), [&](const auto& vehicle) {
      return LowerCase(vehicle.name()) == LowerCase(each.factor.vehicle);
    });
    if (at == vehicles.end()) {
      const std::string reason = "none of the files is of this vehicle";
      draft->Remark(table_, each.origin, each.text, reason);
      losses->Warn(fmt::format("{}: {}: {}", each.origin, each.text, reason));
      continue;
    }
    draft->Set(at->table(), {.key = each.factor.key,
                             .value = each.factor.value,
                             .origin = each.origin,
                             .text = each.text,
                             .reason = ""});
  }
}

}  // namespace shoal
