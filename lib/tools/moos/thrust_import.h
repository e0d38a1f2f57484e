// How fast a thrust drives a vehicle: thrust_map, thrust_factor and max_speed of uSimMarine.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

/// Takes lines; each function returns false where the line makes no sense. `table`: the draft's
/// table of the craft.
class ThrustImport {
 public:
  bool TakeMap(const MoosLine& line, const std::string& table, MissionDraft* draft);
  bool TakeFactor(const MoosLine& line, const std::string& table, MissionDraft* draft);
  bool TakeMaxSpeed(const MoosLine& line, const std::string& table, MissionDraft* draft);

  /// Writes what the lines have set together.
  void Finish(const std::string& table, MissionDraft* draft);

 private:
  void Replace(const MoosLine& line, const std::string& table, MissionDraft* draft);
  void Limit();

  std::map<double, double> map_;  ///< Speeds by thrust in per cent.
  DraftOrigins lines_;
  std::optional<double> max_speed_mps_;
  DraftOrigins limit_;
};

}  // namespace shoal
