// Steers one vehicle. Subscribes to NAV_<V> (MEASURED_NAV_<V> where it has sensors,
// ESTIMATED_NAV_<V> and NAVIGATION_<V> where it navigates by them), SONAR_<V>, HELM_COMMAND_<V>,
// NODE_REPORT_<V> and NODE_MESSAGE_<V>, to NAV of the vehicles that it follows, or to SWARM_<V>;
// publishes DESIRED_<V> and ACTUATORS_<V> in every step, HELM_STATE_<V> on change and every
// state_interval_s; with behaviors HELM_DECISION_<V>, and NODE_MESSAGE_LOCAL for flags with a
// destination.
//
// One step: what was received (swarm_view.h, arbiter_inputs.h), what the tasks want (helm_states.h,
// task_list.h), what is decided of that and of what the behaviors want (arbiter.h), how it is
// steered (pilot.h), what is published (helm_reports.h). The page is in helm_page.h.
//
// ACTUATORS are zero in PARK, in ALL-STOP and before the first NAV; DESIRED begins with the first
// NAV.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "apps/helm/arbiter.h"
#include "apps/helm/helm_page.h"
#include "apps/helm/helm_reports.h"
#include "apps/helm/helm_states.h"
#include "apps/helm/pilot.h"
#include "apps/helm/swarm_view.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"

namespace shoal {

class HelmApp : public App {
 public:
  HelmApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);

  void Tick(int64_t utime) override;
  std::string Crash() const override;
  StatusPage Status() const override;

 private:
  void OnNav(const nav_t& nav);
  void OnNavigation(const navigation_t& navigation);
  void OnCommand(const helm_command_t& command);
  /// A HELM_COMMAND that another vehicle, or the shore in its name, sent as a node message.
  void OnNodeMessage(const node_message_t& message);
  /// Does what was read of an order. `from` is shown; empty: HELM_COMMAND itself.
  void Execute(const Result<HelmOrder>& order, std::string_view from);
  /// Returns why not, or an empty text.
  std::string Execute(const HelmOrder& order);
  void OnNodeReport(const node_report_t& report);
  bool WatchNav(int64_t utime);
  /// Returns where the vehicle is, and what it knows of others; nothing without NAV.
  std::optional<Fix> FixAt(int64_t utime, bool nav_is_lost);
  /// Logs what the arbiter has to state of a step, and does what behaviors ask of the helm itself.
  void NoteDecision(int64_t utime, const Arbiter::Step& step);
  void PublishStep(int64_t utime, const Guidance* guidance);
  /// Publishes what the arbiter has decided, and what it has for other vehicles.
  void PublishDecision(int64_t utime);

  // What every step needs comes first, as in vehicle_sim.
  Bus& bus_;
  const std::unique_ptr<Pilot> pilot_;
  const int64_t nav_timeout_us_;
  std::optional<int64_t> utime_;      ///< Of the last step.
  std::optional<int64_t> nav_utime_;  ///< The step in which it came; none came: the first step.
  int64_t busy_until_utime_ = 0;
  bool nav_is_fresh_ = false;  ///< It came in this step.
  bool had_nav_ = false;
  bool nav_was_lost_ = false;
  nav_t nav_{};  ///< The last that made sense.
  desired_t desired_{};
  actuators_t actuators_{};
  const Channel<desired_t> desired_channel_;
  const Channel<actuators_t> actuators_channel_;
  const Channel<helm_decision_t> decision_channel_;
  HelmStates states_;
  Arbiter arbiter_;
  HelmReports reports_;
  SwarmView swarm_;

  const Vehicle vehicle_;
  const std::string lost_nav_warning_;
  ReportedVehicles contacts_;
  StatusLog log_;
  HelmCounters counters_;
  int64_t num_gps_ = 0;  ///< Fixes, as of the last NAVIGATION.
};

}  // namespace shoal
