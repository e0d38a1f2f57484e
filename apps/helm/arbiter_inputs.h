// What arrives on the bus for the behaviors of one vehicle: other vessels, and settings of their
// variables. A vehicle without behaviors takes nothing.
//
//   inputs.OnNodeReport(report, utime);
//   inputs.Set({.variable = "RETURN", .value = "true"}, "command");
//   inputs.TakeSettings();                          // What arrived since the last decision.
//   inputs.ContactsAt(time_s, own_position_m);      // What is known of others now.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior_set.h"
#include "lib/helm/behaviors/contact_ledger.h"
#include "lib/mission/model/vehicle.h"
#include "shoal/nav_t.hpp"
#include "shoal/navigation_t.hpp"
#include "shoal/node_message_t.hpp"
#include "shoal/node_report_t.hpp"
#include "shoal/sonar_t.hpp"
#include "shoal/swarm_t.hpp"

namespace shoal {

class ArbiterInputs {
 public:
  explicit ArbiterInputs(const Vehicle& vehicle);

  /// False: the vehicle has no behaviors.
  bool is_used() const { return is_used_; }

  void OnNodeReport(const node_report_t& report, int64_t utime);
  void OnSwarm(const swarm_t& swarm, int64_t utime);
  /// The nearest echo counts as a contact "sonar" that does not move.
  void OnSonar(const sonar_t& ping, const nav_t& own, int64_t utime);
  /// Sets NAV_UNCERTAINTY_M, half of the long axis of the ellipse that holds the position with
  /// 95 %, and GPS_UPDATE_RECEIVED, the number of fixes, whenever there was another.
  void OnNavigation(const navigation_t& navigation);
  /// The message's variable and value are a setting.
  void OnNodeMessage(const node_message_t& message);
  /// A variable that `source` sets; counts from the next decision on.
  void Set(const VariablePost& setting, std::string_view source);

  /// Returns the settings since the last call, in the order in which they came.
  std::vector<ReceivedSetting> TakeSettings();
  /// Returns the contacts, predicted to `time_s`, and takes note of the own position, by which
  /// later reports are judged; absent: it is the one before.
  const Contacts& ContactsAt(double time_s, const std::optional<Eigen::Vector2d>& own_position_m);
  bool has_warnings() const { return !warnings_.empty(); }
  /// Returns what was wrong with what arrived since the last call.
  std::vector<std::string> TakeWarnings();

 private:
  void Take(const ContactReport& report);

  const bool is_used_;
  ContactLedger ledger_;
  Eigen::Vector2d own_position_m_ = Eigen::Vector2d::Zero();  ///< At the last decision.
  int64_t num_gps_ = 0;                                       ///< As of the last NAVIGATION.
  std::vector<ReceivedSetting> settings_;
  std::vector<std::string> warnings_;
};

}  // namespace shoal
