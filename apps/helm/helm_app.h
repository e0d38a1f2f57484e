// Steers one vehicle. Subscribes to NAV_<V> (MEASURED_NAV_<V> where it has sensors,
// ESTIMATED_NAV_<V> and NAVIGATION_<V> where it navigates by them), SONAR_<V>, HELM_COMMAND_<V>,
// NODE_REPORT_<V> and NODE_MESSAGE_<V>, to NAV of the vehicles that it follows, or to SWARM_<V>;
// publishes DESIRED_<V> and ACTUATORS_<V> in every step, HELM_STATE_<V> on change and every
// state_interval_s; with behaviors HELM_DECISION_<V>, and NODE_MESSAGE_LOCAL for flags with a
// destination.
//
// What it does and why is decided in helm_states.h, with behaviors in arbiter.h, how in pilot.h;
// here are the bus and the page.
// ACTUATORS are zero in PARK, in ALL-STOP and before the first NAV; DESIRED begins with the first
// NAV.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "apps/helm/arbiter.h"
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
  /// Another vehicle, as its last report has it.
  struct Contact {
    Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
    int64_t reported_utime = 0;
  };

  void OnNav(const nav_t& nav);
  /// Takes note of fixes, and sets what behaviors may know of the own navigation.
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
  /// Returns true where a behavior crashes the helm or keeps it busy: nothing is published then.
  bool IsPrevented(int64_t utime);
  /// Returns what to steer by in this step.
  std::optional<Guidance> Guide(int64_t utime, const std::optional<Fix>& fix);
  /// Publishes what the arbiter has decided, and what it has for other vehicles.
  void PublishDecision(int64_t utime);
  void PublishState(int64_t utime);
  /// Of an underwater vehicle, while it steers by `guidance`.
  void PublishGuidance(int64_t utime, const std::optional<Guidance>& guidance);
  std::string ContactsText() const;
  /// Returns what GUIDANCE shows, for the status page; empty of a vehicle that does not dive.
  std::string GuidanceText() const;

  // What every step needs comes first, as in vehicle_sim.
  Bus& bus_;
  const std::unique_ptr<Pilot> pilot_;
  const int64_t nav_timeout_us_;
  const int64_t state_interval_us_;
  int64_t num_navs_ = 0;
  std::unique_ptr<Arbiter> arbiter_;  ///< Of vehicles with behaviors; else nullptr.
  std::optional<int64_t> utime_;      ///< Of the last step.
  std::optional<int64_t> nav_utime_;  ///< The step in which it came; none came: the first step.
  std::optional<int64_t> state_utime_;
  int64_t busy_until_utime_ = 0;
  bool nav_is_fresh_ = false;  ///< It came in this step.
  bool had_nav_ = false;
  bool nav_was_lost_ = false;
  nav_t nav_{};  ///< The last that made sense.
  desired_t desired_{};
  actuators_t actuators_{};
  helm_state_t state_{};  ///< As published last.
  guidance_t how_{};      ///< The same.
  std::optional<int64_t> how_utime_;
  const Channel<desired_t> desired_channel_;
  const Channel<actuators_t> actuators_channel_;
  const Channel<helm_state_t> state_channel_;
  const Channel<guidance_t> guidance_channel_;
  HelmStates states_;
  SwarmView swarm_;
  std::optional<Guidance> guidance_;  ///< With an arbiter: of the last step.

  const Vehicle vehicle_;
  const std::string lost_nav_warning_;
  std::map<std::string, Contact, std::less<>> contacts_;
  StatusLog log_;
  std::array<int64_t, kNumOrderKinds> num_executed_{};
  int64_t num_refused_ = 0;
  int64_t num_bad_navs_ = 0;
  int64_t num_reports_ = 0;
  int64_t num_gps_ = 0;  ///< Fixes, as of the last NAVIGATION.
};

}  // namespace shoal
