// Runs to and fro between two points, with turns at either end.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

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
  double turn1_bias = 0;              ///< -100 to 100: the turn circle to one side of the leg.
  double turn2_bias = 0;
  double turn1_ext = 0;            ///< m beyond the end of the leg.
  double turn2_ext = 0;            ///< m.
  std::string turn1_dir = "auto";  ///< auto, port or starboard.
  std::string turn2_dir = "auto";
  double capture_radius = 3;  ///< m.
  double slip_radius = 15;    ///< m.
  double lead = -1;           ///< m.
  double lead_damper = -1;    ///< m.
  double patience = 50;       ///< Per cent.
  int repeat = -1;            ///< Legs; -1: for ever.
  std::vector<std::string> leg_end_flag = {};
  std::vector<std::string> start_leg_flag = {};
  std::vector<std::string> mid_flag = {};  ///< At 25 % of a leg.
  std::vector<std::string> start_turn_flag = {};
  std::vector<std::string> end_turn_flag = {};
  std::vector<std::string> mid_turn_flag = {};

  bool operator==(const LegRunOptions&) const = default;
};

}  // namespace shoal
