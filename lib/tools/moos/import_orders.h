// What a user of a MOOS mission posts by hand, as orders of shoal's: buttons and menu entries of
// pMarineViewer, and uPokeDB lines of launch scripts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/import_vehicle.h"
#include "lib/tools/moos/mission_draft.h"

namespace shoal {

/// Returns the variable of a vehicle's behaviors that `posted` sets: itself, or with _ALL or the
/// vehicle's name behind it; empty: none. `is_own`: it is posted in the vehicle's own community, or
/// no other vehicle is there.
[[nodiscard]] std::string VariableOfPost(std::string_view posted, bool is_own,
                                         const VehicleImport& vehicle);

class OrderImport {
 public:
  /// `own`: whose file the button is in; nullptr: the shore's. Adds [[order]] tables for what it
  /// posts and behaviors look at. Returns the order's name; empty: it has no effect on a vehicle.
  std::string Add(const MoosButton& button, const VehicleImport* own,
                  const std::vector<VehicleImport>& vehicles, MissionDraft* draft);

 private:
  std::string NameOf(const MoosButton& button, const std::vector<VehicleImport>& vehicles);

  std::vector<std::string> names_;
  size_t num_tables_ = 0;
};

}  // namespace shoal
