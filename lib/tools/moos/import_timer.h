// The events of uTimerScript that have a counterpart in a mission file.
//
//   event = var=DEPLOY_ALL, val=true, time=10
//
// becomes
//
//   [[event]]
//   at_s = 10
//   vehicle = "all"
//   command = "deploy"
//
// and a variable that a vehicle's behaviors go by becomes the command "set".
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/moos/moos_file.h"
#include "lib/tools/moos/sim_drift.h"

namespace shoal {

/// A point that a script posts for pObstacleMgr: all of one label are one obstacle.
struct TrackedPoint {
  std::string label;
  Eigen::Vector2d position_m = {0, 0};
  int script = 0;  ///< Which of the mission's: vehicles have an obstacle manager each.
};

/// A line `event = ...` as keys of an [[event]], with their values in TOML; or the reason why it is
/// none.
struct TimerEvent {
  int line = 0;             ///< MoosLine::number.
  std::string origin = {};  ///< "a.moos:12".
  std::string text = {};    ///< The line.
  double at_s = 0;
  std::vector<std::pair<std::string, std::string>> keys =
      {};                    ///< Without at_s; empty: see `reason`.
  std::string assumed = {};  ///< What was assumed to make it one; may be empty.
  std::string reason = {};   ///< Why it is not an [[event]].
  int round = 0;             ///< Of a script that is repeated.
  bool is_needless = false;  ///< Nothing is lost without it: `reason` is not a warning.
  std::optional<TrackedPoint> point = {};
  std::optional<DriftChange> drift = {};  ///< Its keys state the drift that is there then.
};

/// TimerScript::num_resets of `reset_max = nolimit`.
inline constexpr double kEndlessResets = 1e9;

struct TimerScript {
  std::vector<TimerEvent> events;
  /// Lines that change what the script does and are not taken: their numbers, and how.
  std::vector<std::pair<int, std::string>> losses;
  std::vector<std::string> conditions = {};  ///< All of which hold while its clock runs.
  double num_resets = 0;                     ///< How often it is repeated.
  int reset_line = 0;                        ///< Of reset_max; 0: not given.
  int atomic_line = 0;                       ///< Of script_atomic = true; 0: not given.
  /// Numbers of lines that count and are not events: random variables, delays, rounds.
  std::vector<int> taken = {};
};

/// Moves the lines of its conditions from what is lost to what is taken.
void TakeConditions(TimerScript* script);

/// Returns true where behaviors of `vehicle` go by a variable.
using HasMoosVariable = std::function<bool(std::string_view vehicle, std::string_view variable)>;

/// Returns what the shore's variable is with the vehicle's name behind it; empty: nothing.
using FindMoosBridge = std::function<std::string(std::string_view posted)>;

/// What a script is read with. Functions may be empty.
struct TimerContext {
  std::string_view vehicle = {};               ///< Whose file it is; empty: the shore's.
  std::span<const std::string> vehicles = {};  ///< All, for names such as DEPLOY_ABE.
  HasMoosVariable has_variable = {};           ///< Empty: none has any.
  FindMoosBridge find_bridge = {};
  /// Returns false for a variable that nothing in the files reads: no loss. Empty: each is read.
  std::function<bool(std::string_view posted)> may_be_read = {};
  /// Returns true where the vehicle's behaviors may set a variable. Empty: they set none.
  std::function<bool(std::string_view variable)> may_be_set = {};
  /// Variables that pObstacleMgr takes points from.
  std::set<std::string, std::less<>> point_variables = {};
  /// Returns the drift that a vehicle begins with. Empty: none.
  std::function<Eigen::Vector2d(std::string_view vehicle)> first_drift_mps = {};
  /// Why the script never runs: all of its events have this reason. Empty: it does.
  std::string idle = {};
};

/// Reads a block of uTimerScript. Random times and values are drawn here, from the same
/// distributions; each import draws the same. A script that is repeated gives the rounds of its
/// first 600 s.
[[nodiscard]] TimerScript ReadTimerScript(const MoosBlock& block, const TimerContext& context);

}  // namespace shoal
