// How far reports go in an imported mission: link factors of uFldNodeComms, routes of pShare.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/import_vehicle.h"
#include "lib/tools/moos/link_factor.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class CommsImport {
 public:
  /// `table`: the draft's table of the broker.
  explicit CommsImport(std::string table) : table_(std::move(table)) {}

  /// Keeps stealth and earange until all vehicles are known. Returns false for any other line.
  bool Take(const MoosLine& line, MissionDraft* draft, ImportLosses* losses);

  /// Without uFldNodeComms, pShare takes node reports from vehicle to vehicle at any range.
  void TakeDirectRoutes(const std::vector<MoosFile>& files, size_t num_vehicles,
                        MissionDraft* draft) const;

  /// Sets what Take() has kept.
  void SetFactors(const std::vector<VehicleImport>& vehicles, MissionDraft* draft,
                  ImportLosses* losses) const;

 private:
  struct KeptFactor {
    std::string origin;
    std::string text;
    LinkFactorSetting factor;
  };

  std::string table_;
  std::vector<KeptFactor> factors_;
};

}  // namespace shoal
