// What stands still in a MOOS mission, as [[obstacle]]: given_obstacle of pObstacleMgr, the file of
// uFldObstacleSim, and KNOWN_OBSTACLE and GIVEN_OBSTACLE of timer scripts.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "lib/tools/moos/import_timer.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/nsplug.h"

namespace shoal {

class ObstacleImport {
 public:
  /// `find` may be empty; both outlive this.
  ObstacleImport(const MoosDefines& defines, const FindMoosFile& find)
      : defines_(defines), find_(find) {}

  /// Adds the obstacles of a file, each once whatever vehicles' files have it.
  void Add(const MoosFile& file, MissionDraft* draft);

  /// Adds the obstacles that pObstacleMgr makes of points, one for each label, from the start.
  /// `points`: events of scripts that have one.
  void AddPoints(const std::vector<TimerEvent>& points, const std::vector<MoosFile>& files,
                 MissionDraft* draft);

  /// Returns true for a line that has become an obstacle, or is named among the warnings.
  bool Has(const std::string& origin) const { return lines_.contains(origin); }

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void AddFile(const MoosLine& line, const std::string& from, MissionDraft* draft);
  void AddOne(const MoosLine& line, const std::string& value, MissionDraft* draft);
  void AddTable(std::string id, const std::string& corners, const DraftLine& from,
                MissionDraft* draft);

  const MoosDefines& defines_;
  const FindMoosFile& find_;
  std::set<std::string> lines_;    ///< Their origins.
  std::set<std::string> corners_;  ///< As TOML.
  std::set<std::string> ids_;
  std::vector<std::string> warnings_;
};

}  // namespace shoal
