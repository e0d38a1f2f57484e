// The timer scripts of a mission's files, as [[event]]s and as behaviors.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_fleet.h"
#include "lib/tools/moos/import_losses.h"
#include "lib/tools/moos/import_posts.h"
#include "lib/tools/moos/import_timer.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_bridges.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class ScriptImport {
 public:
  /// Reads the scripts; those that wait for what behaviors know become behaviors. `pokes`: what the
  /// launch script posts. The files outlive this.
  void Read(const std::vector<MoosFile>& files, const PostImport& posts,
            const std::vector<MoosButton>& pokes, FleetImport* fleet, ImportLosses* losses);

  /// Returns the events that post points of obstacles.
  std::vector<TimerEvent> Points(const std::vector<MoosFile>& files) const;

  /// Adds an [[event]] for each event of a script that has a counterpart; the others are kept.
  /// Returns the time of the last.
  double AddEvents(const std::vector<MoosFile>& files, MissionDraft* draft);

  /// Adds to `table` what has become of a line of a script that is not an event.
  /// @pre the block was read
  void Remark(const MoosBlock& block, const MoosLine& line, std::string_view table,
              MissionDraft* draft, ImportLosses* losses) const;

  /// Returns true for a line that states which variables of the shore reach vehicles.
  bool IsBridge(const std::string& origin) const { return bridge_lines_.contains(origin); }

 private:
  void ReadBridges(const std::vector<MoosFile>& files);
  void AddEvent(const TimerEvent& event, MissionDraft* draft);

  std::map<const MoosBlock*, TimerScript> scripts_;
  MoosBridges bridges_;
  std::set<std::string> bridge_lines_;
  size_t num_events_ = 0;
};

}  // namespace shoal
