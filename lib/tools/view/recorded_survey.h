// Finds which clock stamped a log, and the mission that its messages show.
#pragma once

#include <cstdint>
#include <optional>

#include "lib/bus/record/log_reader.h"
#include "lib/mission/model/mission.h"

namespace shoal {

/// Which clock stamped the events of a log.
enum class LogStamps {
  kMission,  ///< The mission's: the recorder's, and `shoal sim`'s.
  kWall,     ///< The machine's: lcm-logger's. Mission time is what the messages themselves hold.
};

/// Returns the event's mission time; nothing where its stamp is none and the message holds none.
[[nodiscard]] std::optional<int64_t> MissionUtimeOf(const LogEvent& event, LogStamps stamps);

struct LogSurvey {
  static constexpr size_t kMaxVehicles = 300;

  bool has_events = false;
  LogStamps stamps = LogStamps::kMission;
  int64_t first_utime = 0;  ///< The first mission time in the log.
  /// What the log shows of its mission: vehicles by COMMS_RULES, NAV_<V> and NODE_REPORT_LOCAL,
  /// where they began; the rules' seed, tick and origin.
  Mission mission;
  size_t num_left_out = 0;  ///< Vehicles beyond kMaxVehicles.
};

/// Reads `reader` from the start as far as necessary; with `vehicles` that is to the end of a log
/// without COMMS_RULES. Without, the survey's mission is empty.
[[nodiscard]] LogSurvey SurveyLog(LogReader reader, bool vehicles);

}  // namespace shoal
