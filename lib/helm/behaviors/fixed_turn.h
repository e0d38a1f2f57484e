// Turns by an angle.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "fixed_turn". Turns by an angle.
struct FixedTurnOptions {
  static constexpr std::string_view kKind = "fixed_turn";

  double fix_turn = 0;            ///< Degrees; > 0.
  double mod_hdg = 20;            ///< Degrees that the course is set ahead of the heading.
  std::string turn_dir = "port";  ///< port or starboard.
  double speed = 1;               ///< m/s; -1: the speed when it begins.
  double timeout = -1;            ///< s; -1: none.
  double turn_delay = -1;         ///< s before it begins; -1: none.
  std::string radius_rep_var = {};

  bool operator==(const FixedTurnOptions&) const = default;
};

class FixedTurnBehavior final : public BehaviorWith<FixedTurnOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// The next turn starts again.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  std::optional<double> begun_s_;
  bool is_done_ = false;  ///< Until it has been idle.
  double speed_mps_ = 0;
  VesselMotion last_;      ///< In the iteration before.
  double turned_deg_ = 0;  ///< To the side that is asked for.
  double gone_m_ = 0;
};

}  // namespace shoal
