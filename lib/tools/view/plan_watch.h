// Where a vehicle's tasks and behaviors lie now: those of the mission file, changed by the updates
// that its helm has taken.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/any_behavior.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Of one vehicle.
class PlanWatch {
 public:
  /// A longer plan is not sent: the map keeps that of the mission file.
  static constexpr size_t kMaxPlan_bytes = 8'000;

  PlanWatch() = default;
  PlanWatch(std::vector<BehaviorOptions> behaviors, std::vector<Task> tasks);

  /// Takes an event of HELM_DECISION, "update: NAME: KEYS". `position_m`: where the vehicle is.
  /// Returns what lies elsewhere by it, as JSON {"name": ..., "parts": [outline, ...]}; nothing for
  /// other events, and for updates that move nothing.
  std::optional<std::string> OnEvent(std::string_view event, const Eigen::Vector2d& position_m);
  /// The same of the order `move`, where the helm takes it.
  std::optional<std::string> OnMove(std::string_view task, std::span<const double> values);

 private:
  std::vector<BehaviorOptions> behaviors_;
  std::vector<Task> tasks_;
};

}  // namespace shoal
