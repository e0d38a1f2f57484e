// A script of uTimerScript as it is written, and what it posts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/import_timer.h"
#include "lib/tools/moos/timer_draws.h"
#include "lib/tools/moos/timer_events.h"

namespace shoal {

/// A line `event = ...`.
struct ScriptLine {
  int line = 0;
  std::string origin;
  std::string text;
  std::string variable;
  std::string value;
  TimeRange time;
  int amount = 1;
  int first_index = 0;       ///< Of the first of `amount`, for $[IDX].
  std::string problem = {};  ///< Why it is not an event.
  bool is_needless = false;
};

/// What a script does: its events, and the keys about its rounds.
struct MoosScript {
  std::vector<ScriptLine> events;
  std::vector<RandomVariable> variables;
  TimeRange delay_start;
  TimeRange delay_reset;
  TimeRange warp = {1, 1};
  std::optional<double> reset_s;  ///< Nothing: when all are posted.
  double num_resets = 0;
  int reset_line = 0;
  int pause_line = 0;  ///< Of paused = true; 0: it is not.
  std::string pause_variable = "UTS_PAUSE";
  bool shuffles = true;  ///< Times are drawn again in each round.
};

/// Returns what a post of `value` to the variable `posted` is.
using ConvertPost =
    std::function<ConvertedEvent(const std::string& posted, const std::string& value)>;

/// Adds what the script posts in its rounds, drawn the same each time. `vehicle`: whose it is;
/// empty: the shore's.
void RunScript(const MoosScript& script, std::string_view vehicle, const ConvertPost& convert,
               TimerScript* result);

/// Returns true where an event is one of the mission, or becomes part of something else.
[[nodiscard]] bool IsAnyTaken(const TimerScript& script);

}  // namespace shoal
