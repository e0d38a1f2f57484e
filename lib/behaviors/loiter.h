// Goes round a convex polygon.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "loiter". Goes round a convex polygon.
struct LoiterOptions {
  static constexpr std::string_view kKind = "loiter";

  std::vector<Eigen::Vector2d> polygon = {};  ///< Convex; at least three corners.
  double speed = 0;                           ///< m/s.
  double speed_alt = -1;  ///< m/s, instead of speed where use_alt_speed; -1: none.
  bool use_alt_speed = false;
  std::string clockwise =
      "true";                ///< "true", "false" or "best" (decided when it acquires the polygon).
  double radius = 3;         ///< m; a vertex is reached closer than this.
  double slip_radius = 15;   ///< m.
  double acquire_dist = 10;  ///< m from the polygon; beyond, it (re)acquires a vertex.
  bool center_activate = false;  ///< Its centre moves to where the vessel is when it begins to run.
  double spiral_factor =
      -2;                 ///< Reserved by others; 0 or less: off. Radius grows by it each round.
  double patience = 50;   ///< Per cent of course against speed, 1 to 99.
  double slingshot = -1;  ///< Degrees gone round after which it ends; -1: never.
  std::string post_suffix = {};
  std::string ipf_type = "zaic";  ///< zaic or zaic_spd.

  bool operator==(const LoiterOptions&) const = default;
};

}  // namespace shoal
