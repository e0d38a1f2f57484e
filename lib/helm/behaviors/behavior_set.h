// The behaviors of one helm: which of them run, what they decide together, and what they set off.
// Knows of no bus, no clock and no file.
//
//   BehaviorSet set(setup);
//   HelmOutcome outcome = set.Iterate({.time_s = t, .drives = true, .own = own, ...});
//   if (outcome.commands.course_deg) ...
//
// One iteration:
//   1. settings that arrived are taken over; recipes spawn behaviors, for contacts and obstacles in
//      range and for updates with a new name;
//   2. the mode tree;
//   3. each behavior in the order of the file: updates, duration, conditions, then Run or Idle;
//   4. the decision: the grid point with the greatest weighted sum (lib/helm/decision) of those
//   that
//      regions allow;
//   5. flags and reports, in the order of the file. Conditions see them in the next iteration.
//
// Run states of a behavior:
//
//            conditions hold                 objective with a weight > 0
//   +------+ ---------------> +---------+ ---------------------------> +--------+
//   | idle |                  | running |                              | active |
//   +------+ <--------------- +---------+ <--------------------------- +--------+
//      conditions fail, a nostarve variable is old      none, or weight 0
//
//   completed: by itself, after its duration, or because its contact is gone: endflags; then it is
//   removed, and its name is free, unless it is perpetual.
//
// All-stop, "clear" or a reason: NothingToDo (no behavior has a preference), MissingDecVars:speed
// (course or speed are mentioned by none; depth may be, and then is left to others), NoGoalBehavior
// (with goals_mandatory), BehaviorError:<name>: <text>. The first three take effect in the second
// iteration in a row without a decision, whatever the reasons were: a change of modes leaves one
// empty. An error lasts as long as the behavior returns it; that of a behavior which completes with
// it lasts until Clear().
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/behavior_runner.h"
#include "lib/helm/behaviors/update_text.h"
#include "lib/helm/decision/decide.h"
#include "lib/helm/modes/mode_tree.h"

namespace shoal {

/// What a helm with behaviors is made of.
struct HelmSetup {
  std::string vehicle;  ///< Its name, for macros.
  std::vector<BehaviorOptions> behaviors = {};
  std::vector<ModeOptions> modes = {};
  std::map<std::string, VariableValue> variables = {};  ///< Set before the first iteration.
  Domain domain = {};
  bool goals_mandatory = false;  ///< Constraints alone (avoidance, limits) make no decision.
  ReadUpdate read_update = {};   ///< Empty: updates are refused.
  /// Empty: MakeBehavior.
  std::function<std::unique_ptr<Behavior>(const BehaviorOptions&)> make = {};
};

/// A setting that came since the last iteration.
struct ReceivedSetting {
  std::string variable;
  VariableValue value;
  std::string source;  ///< For warnings: "henry", "command", "event".
};

/// The task of the moment as one aim among the others.
struct TaskAim {
  std::string name = {};
  std::string kind = {};
  double pwt = 100;
  double course_deg = 0;  ///< What it commands alone.
  double speed_mps = 0;   ///< 0: any course.
  std::optional<double> depth_m = {};
};

struct HelmInputs {
  double time_s = 0;    ///< Never decreases.
  bool drives = false;  ///< False, parked: settings are taken over, nothing runs, no flags.
  std::optional<OwnMotion> own = {};                 ///< Absent: no navigation; nothing is decided.
  const Contacts* contacts = nullptr;                ///< nullptr: none.
  const std::vector<Obstacle>* obstacles = nullptr;  ///< nullptr: none.
  std::vector<ReceivedSetting> settings = {};
  std::optional<TaskAim> task = {};
  /// Behaviors that are goals are idle, avoidance and limits stay: the task is by an order of the
  /// operator.
  bool goals_rest = false;
  /// False: the shares of the aims (best, value, loss) are left out, which cost as much as the
  /// decision; Explain() fills them in where they are wanted.
  bool explains = true;
};

/// A point of the grid; absent: not decided about.
struct HelmPoint {
  std::optional<double> course_deg = {};
  std::optional<double> speed_mps = {};
  std::optional<double> depth_m = {};

  bool operator==(const HelmPoint&) const = default;
};

/// A running behavior's share in the decision.
struct HelmAim {
  std::string name = {};
  std::string kind = {};
  bool is_constraint = false;  ///< Avoidance, a limit: no goal by itself.
  std::string state =
      {};             ///< "active" or "running", and what it states about itself: "active, leg 3".
  double weight = 0;  ///< 0: no preference now.
  HelmPoint best = {};  ///< What it alone would have chosen.
  double value = 0;     ///< Its value at the decision, 0 to 100.
  double loss = 0;      ///< weight x (value at best - value).
  std::optional<ContactRole> role = {};
  BehaviorView view = {};
};

struct HelmOutcome {
  std::string all_stop = "clear";  ///< Or the reason.
  /// True in the iteration in which a missing decision does not count yet: what was commanded last
  /// stays.
  bool keeps_last = false;
  HelmPoint commands = {};  ///< The decision; empty in an all-stop.
  double utility = 0;       ///< The weighted sum there.
  /// The decision without the limits of regions, where they do not allow it.
  std::optional<HelmPoint> wanted = {};
  bool has_decision = false;
  /// The task is the only one with a preference: its own guidance counts untouched.
  bool only_task = false;
  /// The decision is the point that is nearest to what the task commands alone: its exact values
  /// count.
  bool is_task_point = false;
  std::vector<HelmAim> aims = {};  ///< Running ones in the order of the file, the task first.
  bool parks = false;  ///< A behavior wants the helm to park, as by an operator's order.
  /// A behavior wants the helm to be busy for that long, in mission time: what this iteration
  /// decided comes that much later.
  double busy_s = 0;
  std::string crash = {};  ///< Not empty: this behavior wants the helm's process to abort.
  /// What flags and reports set, in the order of the file; own ones are set already.
  std::vector<VariablePost> posts = {};
  std::vector<HelmEvent> events = {};
  std::vector<std::string> warnings = {};
  std::string mode = {};  ///< Of the first mode variable; empty: no modes.
};

class BehaviorSet {
 public:
  /// @pre everything of `setup` that is parsed (conditions, flags, modes) is right: Problem()
  explicit BehaviorSet(HelmSetup setup);
  ~BehaviorSet();
  BehaviorSet(BehaviorSet&&) noexcept;
  BehaviorSet& operator=(BehaviorSet&&) noexcept;

  HelmOutcome Iterate(const HelmInputs& inputs);

  /// Fills in the shares of the aims of the last outcome.
  /// @pre `outcome` is what the last Iterate returned
  void Explain(HelmOutcome* outcome) const;

  /// Returns the weighted sum of the last iteration at the grid point that is nearest, for
  /// comparisons with other decisions.
  double UtilityAt(const HelmPoint& point) const;

  /// Ends an all-stop that lasts: the operator has given the order to go on.
  void Clear();

  const Variables& variables() const { return variables_; }
  /// Returns the names of all behaviors that exist, in the order in which they are run.
  std::vector<std::string> Names() const;

 private:
  struct Recipe;
  struct Iteration;

  void TakeSettings(const HelmInputs& inputs, HelmOutcome& outcome);
  void TakeAbleFilter(HelmNotes* notes);
  void ApplyUpdates(const Iteration& now);
  void ApplyUpdate(const std::string& variable, const std::string& text, const Iteration& now);
  void SpawnForContacts(const Iteration& now);
  void SpawnForObstacles(const Iteration& now);
  /// Adds a behavior, or warns.
  void Spawn(Recipe& recipe, BehaviorOptions options, const BehaviorOrigin& origin,
             const Iteration& now);
  bool HasRunnerNamed(std::string_view name) const;
  static HelmAim AimOf(const RunReport& report);
  void Decide(const HelmInputs& inputs, const std::vector<RunReport>& reports,
              HelmOutcome& outcome);
  void JudgeAllStop(const std::string& error, HelmOutcome& outcome);
  void TakePosts(double time_s, HelmOutcome& outcome);

  HelmSetup setup_;
  Variables variables_;
  ModeTree modes_;
  std::vector<Recipe> recipes_;
  std::vector<std::unique_ptr<BehaviorRunner>> runners_;  ///< In the order of the file.
  std::set<std::string> disabled_contacts_;               ///< By BHV_ABLE_FILTER.
  std::vector<WeightedObjective> objectives_;  ///< Of the last decision, as outcome.aims.
  GridDecision decision_;
  bool avoids_ = false;  ///< A contact to keep clear of had a share in the last iteration.
  HelmPoint commanded_;  ///< In the last iteration; empty: nothing.
  std::string lasting_error_;
  int iterations_without_decision_ = 0;
  std::string last_all_stop_ = "clear";
};

/// Returns the objective that stands for a task beside behaviors: its greatest value, 100, is at
/// the grid point that is nearest to the task's own course and speed.
[[nodiscard]] Objective ObjectiveOf(const TaskAim& task, const Domain& domain);

}  // namespace shoal
