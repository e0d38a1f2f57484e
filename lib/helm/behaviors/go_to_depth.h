// Visits depths, each for a time.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "go_to_depth". Visits depths, each for a time.
struct GoToDepthOptions {
  static constexpr std::string_view kKind = "go_to_depth";

  std::vector<Eigen::Vector2d> depths = {};    ///< Pairs of a depth, m, and a time, s, at it.
  int repeat = 0;                              ///< Further rounds.
  double capture_delta = 1;                    ///< m.
  std::vector<std::string> capture_flag = {};  ///< At each depth that is reached.

  bool operator==(const GoToDepthOptions&) const = default;
};

class GoToDepthBehavior final : public BehaviorWith<GoToDepthOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  /// Other depths: begins with the first of them.
  void Reconfigure(const GoToDepthOptions& options) override;

 private:
  bool IsReached(double depth_m) const;

  size_t index_ = 0;
  int rounds_ = 0;
  bool is_done_ = false;                ///< Until it has been idle.
  std::optional<double> reached_s_;     ///< When the present depth was.
  std::optional<double> last_depth_m_;  ///< In the iteration before.
};

}  // namespace shoal
