// One behavior of a helm with everything that is the same for all kinds: conditions, run states,
// flags, duration, updates. Which of them decide together is BehaviorSet's (behavior_set.h).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/contact_moments.h"
#include "lib/helm/behaviors/update_text.h"
#include "lib/helm/modes/flag.h"

namespace shoal {

struct HelmEvent {
  std::string kind;  ///< mode, state, spawn, end, flag, update, all_stop.
  std::string text;  ///< "waypoint_survey: idle -> active".

  bool operator==(const HelmEvent&) const = default;
};

/// What happened in an iteration.
struct HelmNotes {
  std::vector<VariablePost> posts = {};
  std::vector<HelmEvent> events = {};
  std::vector<std::string> warnings = {};
};

/// Where a behavior comes from.
struct BehaviorOrigin {
  std::string recipe = {};    ///< Name of the recipe; empty: the mission file has it as it is.
  std::string contact = {};   ///< That it was spawned for.
  std::string obstacle = {};  ///< That it was spawned for.
};

enum class RunState { kNew, kIdle, kRunning, kActive, kCompleted };

/// Returns "new", "idle", "running", "active" or "completed".
[[nodiscard]] std::string_view Name(RunState state);

/// What came of one iteration of a behavior.
struct RunReport {
  const BehaviorOptions* options = nullptr;
  RunState state = RunState::kIdle;
  BehaviorAnswer answer = {};  ///< Its objective is sound, and there only where it is active.
  double weight = 0;           ///< Priority weight x relevance; > 0 where it is active.
  bool is_constraint = false;
};

class BehaviorRunner {
 public:
  /// @pre Problem(options).empty()
  BehaviorRunner(BehaviorOptions options, std::unique_ptr<Behavior> behavior,
                 BehaviorOrigin origin);

  /// Changes the options by an update, all or nothing; a text that was the last one already is left
  /// alone unless it toggles or modifies.
  void Update(const std::string& text, std::span<const UpdateItem> items, const ReadUpdate& read,
              const BehaviorInputs& inputs, HelmNotes& notes);

  /// One iteration. `end_reason`, not empty: it completes now.
  RunReport Iterate(const BehaviorInputs& inputs, const std::string& end_reason, HelmNotes& notes);

  /// Makes it idle, whatever its conditions are, until it is enabled again.
  void Disable(bool is_disabled) { is_disabled_ = is_disabled; }

  /// The operator has given the order to go on.
  void Clear() { behavior_->Clear(); }

  /// Returns true where it is to be removed: completed, and not perpetual, or its contact is gone.
  bool is_over() const { return is_over_; }
  const BehaviorOptions& options() const { return options_; }
  const BehaviorOrigin& origin() const { return origin_; }

 private:
  struct FlagLists {
    std::vector<Flag> run, runx, idle, active, inactive, end, spawn, spawnx, config;
  };

  void Parse();
  void FireMoments(const BehaviorInputs& inputs, HelmNotes& notes);
  void Fire(const std::vector<Flag>& flags, const BehaviorInputs& inputs, HelmNotes& notes);
  void FireOwn(const std::string& name, const BehaviorInputs& inputs, HelmNotes& notes);
  std::optional<std::string> MacroValue(std::string_view name, const BehaviorInputs& inputs);
  /// Posts what changed since it was posted last.
  void Report(const std::vector<VariablePost>& posts, HelmNotes& notes);
  void Warn(const std::string& warning, HelmNotes& notes);
  void Enter(RunState state, HelmNotes& notes);
  bool ConditionsHold(const BehaviorInputs& inputs) const;
  void CountTime(const BehaviorInputs& inputs, HelmNotes& notes);
  /// Posts reports and own flags of an answer.
  void Publish(const BehaviorAnswer& answer, const BehaviorInputs& inputs, HelmNotes& notes);
  RunReport Idle(const BehaviorInputs& inputs, HelmNotes& notes);
  RunReport Run(const BehaviorInputs& inputs, HelmNotes& notes);
  /// Ends it from outside: its duration, or a contact that is gone.
  RunReport End(const std::string& reason, const BehaviorInputs& inputs, HelmNotes& notes);
  void FireEndFlags(const std::string& reason, const BehaviorInputs& inputs, HelmNotes& notes);

  BehaviorOptions options_;
  std::unique_ptr<Behavior> behavior_;
  BehaviorOrigin origin_;
  std::vector<Condition> conditions_;
  FlagLists flags_;
  std::map<std::string, std::vector<Flag>> own_flags_;  ///< Parsed when they fire first.
  std::vector<MomentFlag> moment_flags_;
  ContactMoments moments_;

  RunState state_ = RunState::kNew;
  bool is_over_ = false;
  bool is_disabled_ = false;
  double last_time_s_ = 0;
  double state_since_s_ = 0;
  std::optional<double> used_s_;  ///< Of the duration; absent: has not run yet.
  std::string last_update_;
  std::string last_warning_;
  std::map<std::string, VariableValue> reported_;
  std::map<std::string, int64_t, std::less<>> counters_;
};

/// Returns the conditions with the contact's name for $[CONTACT], in upper case: "MARKED_HENRY =
/// true"; for $[contact] in lower case, for $[Contact] as it is. What is not part of a variable's
/// name becomes '_'; without a contact, as a recipe has none, it is CONTACT.
[[nodiscard]] std::vector<std::string> ConditionsOf(const BehaviorOptions& options);

/// Returns what of `options` cannot be parsed: conditions, flags. Empty: nothing.
[[nodiscard]] std::string Problem(const BehaviorOptions& options);

/// Returns the list of flags `name` ("wptflag") of the behavior's own kind, or nullptr.
[[nodiscard]] const std::vector<std::string>* OwnFlags(const AnyBehavior& what,
                                                       std::string_view name);
/// Returns all lists of flags of its own kind.
[[nodiscard]] std::vector<const std::vector<std::string>*> EachOwnFlags(const AnyBehavior& what);

/// Returns the variables that the behavior posts and whose names the mission gives.
[[nodiscard]] std::vector<std::string> NamedVariables(const AnyBehavior& what);

}  // namespace shoal
