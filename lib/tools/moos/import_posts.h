// What a user posts by hand: the button that deploys, and orders for all others.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/moos/import_buttons.h"
#include "lib/tools/moos/import_fleet.h"
#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/import_orders.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class PostImport {
 public:
  /// Gives vehicles what the button that deploys them sets besides. The files outlive this.
  void Read(const std::vector<MoosFile>& files, FleetImport* fleet);

  /// Returns true where a button or menu entry posts the variable, and none that deploys does.
  /// @pre Read() was called
  bool SetsAlone(std::string_view variable) const;

  /// Adds an [[order]] for each further button, and for what the launch script pokes.
  void AddOrders(const std::vector<MoosFile>& files, const std::vector<MoosButton>& pokes,
                 FleetImport* fleet, MissionDraft* draft, ImportLosses* losses);

  /// Returns what has become of a button's line: what `deploy` sets, an order, or without effect.
  /// @pre the block was read
  std::string Reason(const MoosBlock& block, const MoosLine& line, ImportLosses* losses) const;

 private:
  std::map<const MoosBlock*, std::vector<MoosButton>> buttons_;
  std::set<std::pair<const MoosBlock*, std::string>> deploy_keys_;
  OrderImport orders_;
  std::map<std::string, std::string> button_orders_;  ///< Commands, a line each, by origins.
};

}  // namespace shoal
