// The orders that a helm accepts, read from the text of a helm_command_t.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/base/check/result.h"
#include "lib/helm/modes/variables.h"

namespace shoal {

enum class OrderKind {
  kDeploy,       ///< Start the task list, or go on with it.
  kReturn,       ///< Go to the return point and stay there.
  kStationKeep,  ///< Stay here.
  kAllStop,      ///< Thrust and rudder to zero until `resume`.
  kResume,       ///< After an all-stop: go on with what was going on.
  kPark,         ///< Stop, until the next order to move.
  kGoto,         ///< Go to a point and stay there.
  kSpeed,        ///< Another speed for the task that runs.
  kTask,         ///< Jump to a task of the list.
  kMove,         ///< Another place for a task of the list.
  kSet,          ///< Set a variable of the behaviors.
};
inline constexpr int kNumOrderKinds = static_cast<int>(kNumEnumerators<OrderKind>);

struct HelmOrder {
  OrderKind kind = OrderKind::kPark;
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();  ///< Of kGoto.
  double speed_mps = 0;                               ///< Of kSpeed; > 0.
  std::string task = {};                              ///< Of kTask and kMove.
  std::vector<double> places = {};                    ///< Of kMove: x, y of each point, m.
  std::string reason = {};                            ///< Of kAllStop; empty: none was given.
  VariablePost setting = {};                          ///< Of kSet.
};

/// A quarter of the Earth's circumference; larger coordinates are refused.
inline constexpr double kMaxCoordinate_m = 1e7;

/// No longer reason of an all-stop is accepted.
inline constexpr size_t kMaxReasonLength = 100;

/// Reads an order; the error states what is wrong with it.
Result<HelmOrder> ReadOrder(std::string_view command, std::string_view argument,
                            std::span<const double> values);

/// Reads an order from one text, as node messages bring them: "deploy", "speed=1.2", "goto=10,-20",
/// "task=survey", "set=RETURN=true".
Result<HelmOrder> ReadOrderText(std::string_view text);

/// Returns the word for it, as in helm_command_t.
std::string_view Name(OrderKind kind);

}  // namespace shoal
