// Runs to and fro between two points, with turns at either end.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/geometry/leg.h"
#include "lib/helm/behaviors/behavior.h"
#include "lib/helm/behaviors/track_line.h"
#include "lib/vehicle/guidance/waypoint_capture.h"

namespace shoal {

/// kind = "leg_run". Runs to and fro between two points, with turns at either end.
struct LegRunOptions {
  static constexpr std::string_view kKind = "leg_run";

  std::optional<Eigen::Vector2d> p1 = {};
  std::optional<Eigen::Vector2d> p2 = {};
  double speed = 0;                   ///< m/s.
  std::vector<double> leg_spds = {};  ///< m/s of the first, second, ... leg; empty: speed.
  double turn1_rad = 20;              ///< m; > 0.
  double turn2_rad = 20;              ///< m.
  double turn1_bias = 0;  ///< -100 (port) to 100: side of the circle, per cent of its radius.
  double turn2_bias = 0;
  double turn1_ext = 0;            ///< m beyond the end of the leg.
  double turn2_ext = 0;            ///< m.
  std::string turn1_dir = "auto";  ///< auto, port or starboard.
  std::string turn2_dir = "auto";
  double capture_radius = 3;  ///< m.
  double slip_radius = 15;    ///< m.
  bool capture_line = false;  ///< Reached past the line square to the leg too; in turns likewise.
  bool capture_line_only = false;  ///< The radii do not count.
  double lead = -1;                ///< m.
  double lead_damper = -1;         ///< m.
  double return_angle = 15;  ///< Degrees to the leg, at most, after it kept clear of a contact.
  double patience = 50;      ///< Per cent.
  int repeat = -1;           ///< Further rounds of two legs; -1: for ever.
  std::vector<std::string> leg_end_flag = {};
  std::vector<std::string> start_leg_flag = {};
  std::vector<std::string> mid_flag = {};  ///< At 25 % of a leg.
  std::vector<std::string> start_turn_flag = {};
  std::vector<std::string> end_turn_flag = {};
  std::vector<std::string> mid_turn_flag = {};

  bool operator==(const LegRunOptions&) const = default;
};

/// To p1, then leg 1 from p1 to p2, a turn about a circle beyond p2, leg 2 back, a turn beyond p1.
///
///   init ---> leg1 ---> turn1 ---> leg2 ---> turn2 ---+
///               ^                                     |
///               +-------------------------------------+
///
/// The circle's centre lies turn_ext beyond the end of the leg, and turn_bias per cent of the
/// radius to starboard of it; the turn is the half of the circle that is farther from the leg.
/// Posts LEGRUN_STATE and LEGRUN_LEGS.
class LegRunBehavior final : public BehaviorWith<LegRunOptions> {
 public:
  using BehaviorWith::BehaviorWith;
  BehaviorAnswer Run(const BehaviorInputs& inputs) override;
  BehaviorAnswer Idle(const BehaviorInputs& inputs) override;
  /// Other ends: starts again. Other turns count from the next one.
  void Reconfigure(const LegRunOptions& options) override;

 private:
  enum class Part { kInit, kLeg1, kTurn1, kLeg2, kTurn2, kDone };

  void Enter(Part part, const Eigen::Vector2d& position_m, BehaviorAnswer& answer);
  void HeadFor(const Leg& leg, const Eigen::Vector2d& position_m);
  void Proceed(const Eigen::Vector2d& position_m, BehaviorAnswer& answer);
  void PassMiddle(const Eigen::Vector2d& position_m, BehaviorAnswer& answer);
  std::vector<Eigen::Vector2d> TurnPoints(const Leg& leg, bool first) const;
  bool IsTurn() const { return part_ == Part::kTurn1 || part_ == Part::kTurn2; }
  std::string_view Name() const;

  Part part_ = Part::kInit;
  Leg leg_;
  Diversion diversion_;
  std::optional<WaypointCapture> capture_;  ///< Absent: not begun, or idle before.
  std::vector<Eigen::Vector2d> turn_m_;     ///< Points of this turn.
  size_t turn_index_ = 0;
  bool passed_middle_ = false;
  int num_legs_ = 0;  ///< Completed ones.
};

}  // namespace shoal
