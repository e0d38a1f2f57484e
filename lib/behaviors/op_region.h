// Keeps the vessel inside a region, in three zones: core, save and halt.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "op_region". Keeps the vessel inside a region, in three zones: core, save and halt.
struct OpRegionOptions {
  static constexpr std::string_view kKind = "op_region";

  std::vector<Eigen::Vector2d> core_poly = {};  ///< Convex.
  std::vector<Eigen::Vector2d> save_poly = {};  ///< Convex; empty: core_poly grown by save_dist.
  std::vector<Eigen::Vector2d> halt_poly = {};  ///< Convex; empty: core_poly grown by halt_dist.
  double save_dist = -1;                        ///< m; -1: no zone in which it turns back.
  double halt_dist = -1;              ///< m; -1: the border of the core (or save) zone halts.
  double max_depth = 0;               ///< m; 0: off.
  double min_altitude = 0;            ///< m; 0: off.
  double max_time = 0;                ///< s; 0: off.
  double trigger_entry_time = 1;      ///< s inside before leaving counts.
  double trigger_exit_time = 0.5;     ///< s outside before it is a breach.
  bool trigger_on_poly_entry = true;  ///< A start outside is no breach.
  bool soft_poly_breach = false;      ///< A breach parks the helm instead of an error.
  double recover_spd = 0.8;           ///< m/s on the way back.
  bool latch =
      true;  ///< A breach stays an all-stop until the helm is deployed or reset_var is set.
  std::string reset_var = {};                ///< A new setting of it clears a breach and the time.
  std::vector<std::string> save_flag = {};   ///< On leaving the save zone.
  std::vector<std::string> savex_flag = {};  ///< In every iteration outside it.
  std::vector<std::string> breached_poly_flag = {};
  std::vector<std::string> breached_depth_flag = {};
  std::vector<std::string> breached_altitude_flag = {};
  std::vector<std::string> breached_time_flag = {};

  bool operator==(const OpRegionOptions&) const = default;
};

}  // namespace shoal
