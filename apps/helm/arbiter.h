// Weighs the task of the moment with the behaviors of one vehicle: between what arrived on the bus
// and what the autopilots get. The decision itself is BehaviorSet's (lib/helm/behaviors).
//
//   arbiter.OnNodeReport(report, utime);
//   std::optional<Guidance> guidance = arbiter.Advance({.utime = t, .drives = true, .nav = &nav,
//                                                       .task = task, .alone = states.guidance()});
//
// It decides every decide_every_s, and what it decided counts until the next time. Where nothing
// but the task has a preference, or the decision is what the task commands alone, the task's own
// guidance counts, in every step.
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
#include <utility>
#include <vector>

#include "apps/helm/helm_order.h"
#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/contact_ledger.h"
#include "lib/mission/model/mission.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "shoal/helm_decision_t.hpp"
#include "shoal/nav_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/swarm_t.hpp"

namespace shoal {

class Arbiter {
 public:
  Arbiter(const Mission& mission, const Vehicle& vehicle);

  void OnNodeReport(const node_report_t& report, int64_t utime);
  void OnSwarm(const swarm_t& swarm, int64_t utime);
  /// The nearest echo counts as a contact "sonar" that does not move.
  void OnSonar(const sonar_t& ping, const nav_t& own, int64_t utime);
  /// A variable that a command or a node message sets; counts from the next decision on.
  void Set(const VariablePost& setting, std::string_view source);

  /// Returns the order that HelmStates is to execute: `order`, or `deploy` where variables do the
  /// rest.
  HelmOrder Instead(const HelmOrder& order) const;
  /// An order of the operator was executed: sets the variables that stand for it, and ends what
  /// lasts until the operator acts.
  void TakeOver(const HelmOrder& order);

  /// One step of the helm.
  struct Moment {
    int64_t utime = 0;
    bool drives = false;           ///< False: parked, or all-stop by command or for want of NAV.
    const nav_t* nav = nullptr;    ///< nullptr: none yet.
    const Task* task = nullptr;    ///< nullptr: none runs.
    bool is_interruption = false;  ///< The task is by an order of the operator.
    std::optional<Guidance> alone = {};  ///< What the task asks for by itself.
  };
  /// Returns what to steer by; nothing: rest.
  std::optional<Guidance> Advance(const Moment& moment);

  /// Returns "clear" or why nothing is decided.
  const std::string& all_stop() const { return outcome_.all_stop; }
  /// True where a behavior has asked to park since the last call.
  bool TakePark();
  /// Returns for how many seconds a behavior keeps the helm busy from now on; 0: not.
  double TakeBusy() { return std::exchange(outcome_.busy_s, 0); }
  /// Returns what is to be published of the last step, if anything.
  std::optional<helm_decision_t> TakeDecision();
  /// Returns the settings for other vehicles since the last call.
  std::vector<VariablePost> TakeMessages();
  /// Return what happened, and what is wrong, since the last call.
  std::vector<HelmEvent> TakeEvents();
  std::vector<std::string> TakeWarnings();

  /// Returns the behavior that leads, for HELM_STATE where no task runs: the active goal with the
  /// greatest weight; nullptr: none.
  const HelmAim* Leading() const;
  const HelmOutcome& outcome() const { return outcome_; }
  /// Returns the lines of the status page.
  std::string Text() const;

 private:
  void Take(const ContactReport& report);
  void Decide(const Moment& moment);
  helm_decision_t Message(int64_t utime) const;
  bool HasVariable(std::string_view name) const;

  const std::string vehicle_;
  const std::vector<Obstacle> obstacles_;
  const int64_t interval_us_;
  BehaviorSet behaviors_;
  ContactLedger ledger_;
  Eigen::Vector2d own_position_m_ = Eigen::Vector2d::Zero();  ///< At the last decision.
  std::vector<ReceivedSetting> settings_;
  HelmOutcome outcome_;
  HelmPoint commands_;  ///< The last decision.
  std::optional<int64_t> next_utime_;
  bool drove_ = false;  ///< In the last step; a decision is due where it begins to.
  bool wants_park_ = false;

  std::vector<VariablePost> messages_;
  std::vector<HelmEvent> events_;
  std::vector<std::string> warnings_;
  std::vector<std::string> unpublished_events_;
  std::optional<helm_decision_t> unpublished_;
  helm_decision_t published_{};
};

}  // namespace shoal
