// Decides what one vehicle does: weighs what its list of tasks wants with what its behaviors want,
// between what arrived on the bus and what the autopilots get. The decision itself is BehaviorSet's
// (lib/helm/behaviors).
//
//   arbiter.inputs().OnNodeReport(report, utime);
//   Arbiter::Step step = arbiter.Advance(
//       {.utime = t, .drives = true, .nav = &nav, .list = states.aim()});
//   if (step.guidance != nullptr) ...
//
// It decides every decide_every_s, and what it decided counts until the next time. Where nothing
// but the task has a preference, or the decision is what the task commands alone, the task's own
// guidance counts, in every step. A vehicle without behaviors has nothing to weigh: its list's
// guidance counts always, and nothing is decided, stated or published beside it.
//
// Orders of the operator: where the mission has variables of the names DEPLOY, RETURN and
// STATION_KEEP, the orders deploy, return and station_keep set them as the buttons of a shore
// station do. Otherwise return, station_keep and goto are tasks, and while one runs the behaviors
// that are goals rest; avoidance and limits stay.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/helm/arbiter_inputs.h"
#include "apps/helm/helm_order.h"
#include "apps/helm/task_list.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/mission/model/mission.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "shoal/helm_decision_t.hpp"
#include "shoal/nav_t.hpp"

namespace shoal {

class Arbiter {
 public:
  Arbiter(const Mission& mission, const Vehicle& vehicle);

  /// What arrives on the bus for it.
  ArbiterInputs& inputs() { return inputs_; }
  /// Executes the order `set`, or returns why not.
  [[nodiscard]] std::string Set(const VariablePost& setting);

  /// Returns the order that HelmStates is to execute: `order`, or `deploy` where variables do the
  /// rest.
  HelmOrder ReplacementFor(const HelmOrder& order) const;
  /// An order of the operator was executed: sets the variables that stand for it, and ends what
  /// lasts until the operator acts.
  void TakeOver(const HelmOrder& order);

  /// One step of the helm.
  struct Moment {
    int64_t utime = 0;
    bool drives = false;         ///< False: parked, or all-stop by command or for want of NAV.
    const nav_t* nav = nullptr;  ///< nullptr: none yet.
    ListAim list = {};           ///< What the tasks want.
  };
  /// What comes of it.
  struct Step {
    const Guidance* guidance = nullptr;  ///< nullptr: rest. Valid until the next step.
    bool parks = false;                  ///< A behavior asks to park.
    double busy_s = 0;                   ///< A behavior keeps the helm busy for that long.
  };
  Step Advance(const Moment& moment);

  /// Returns "clear" or why nothing is decided.
  const std::string& all_stop() const { return outcome_.all_stop; }
  /// Returns the behavior that crashes the helm; empty: none does.
  const std::string& crash() const { return outcome_.crash; }
  /// True where there are events or warnings to take.
  bool has_notes() const {
    return !events_.empty() || !warnings_.empty() || inputs_.has_warnings();
  }
  /// True where there is a decision or a message to take.
  bool has_output() const { return unpublished_.has_value() || !messages_.empty(); }
  /// Returns what is to be published of the steps since the last call, if anything.
  std::optional<helm_decision_t> TakeDecision();
  /// Returns the settings for other vehicles since the last call.
  std::vector<VariablePost> TakeMessages();
  /// Return what happened, and what is wrong, since the last call.
  std::vector<HelmEvent> TakeEvents();
  std::vector<std::string> TakeWarnings();

  /// Returns the behavior that leads, for HELM_STATE where no task runs: the active goal with the
  /// greatest weight; nullptr: none.
  const HelmAim* Leading() const;
  /// Returns the lines of the status page; none of a vehicle without behaviors.
  std::string Text() const;

 private:
  bool IsKept(std::string_view name) const;
  /// Returns what the last decision makes of the aim of the tasks.
  const Guidance* Weighed(const Moment& moment);
  void Decide(const Moment& moment);
  helm_decision_t Message(int64_t utime) const;
  bool HasVariable(std::string_view name) const;

  ArbiterInputs inputs_;
  const std::string vehicle_;
  const std::vector<std::string> deploy_keeps_;  ///< Variables that `deploy` leaves alone.
  std::vector<Obstacle> obstacles_;
  const int64_t interval_us_;
  BehaviorSet behaviors_;
  HelmOutcome outcome_;
  HelmPoint commands_;  ///< The last decision.
  Guidance guidance_;   ///< Of the last step, where it is not that of the tasks.
  std::optional<int64_t> next_utime_;
  bool drove_ = false;  ///< In the last step; a decision is due where it begins to.

  std::vector<VariablePost> messages_;
  std::vector<HelmEvent> events_;
  std::vector<std::string> warnings_;
  std::vector<std::string> unpublished_events_;
  std::optional<helm_decision_t> unpublished_;
  helm_decision_t published_{};
};

}  // namespace shoal
