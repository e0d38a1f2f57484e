// Zigzags about a course.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/behavior.h"

namespace shoal {

/// kind = "zigzag". Zigzags about a course.
struct ZigzagOptions {
  static constexpr std::string_view kKind = "zigzag";

  double stem_hdg = 0;             ///< Degrees.
  bool stem_on_active = false;     ///< The heading when it begins instead.
  double speed = 0;                ///< m/s.
  bool speed_on_active = false;    ///< The speed when it begins instead.
  double zig_angle = 45;           ///< Degrees; 1 to 90.
  std::string zig_first = "port";  ///< port or starboard.
  double hdg_thresh = 5;           ///< Degrees.
  int max_zig_legs = 2;            ///< Ends after these; 0: never.
  double max_stem_odo = -1;        ///< m along the stem; -1: off.
  bool fierce_zigging =
      false;  ///< The set course follows the heading until the new leg is reached.
  std::vector<std::string> zigflag = {};  ///< Each leg to port.
  std::vector<std::string> zagflag = {};  ///< Each leg to starboard.

  bool operator==(const ZigzagOptions&) const = default;
};

class ZigzagBehavior final : public BehaviorWith<ZigzagOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  /// Starts again with a new stem.
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;

 private:
  void Begin(const BehaviorInputs& inputs, BehaviorAnswer& answer);
  void StartLeg(BehaviorAnswer& answer);
  double SetCourse() const;

  bool is_begun_ = false;
  bool is_done_ = false;  ///< Until it has been idle.
  double stem_deg_ = 0;
  double speed_mps_ = 0;
  Eigen::Vector2d begun_at_m_ = Eigen::Vector2d::Zero();
  int side_ = -1;  ///< Of this leg: -1 port, 1 starboard.
  int num_legs_ = 0;
};

}  // namespace shoal
