// The layers of velocity guidance by artificial potential fields: each returns how a vehicle should
// move for one reason, and nothing where it has none. A cascade (velocity_cascade.h) weighs them.
//
// All radial functions are polynomials of the normalised distance, of degree 3:
//
//   |v| u_max ____                              ____ u_max
//                 \                            /
//                  `-.__________________.-'         formation: toward the leader on the right,
//       0    r_safe   r_inner   r_follow   r_outer  r_max           away on the left
//
//   |v| u_max ____
//                 \                                 survival: away from every neighbour
//                  `-._____________________
//       0    r_safe   r_avoid
//
// Velocities are in world axes: x East, y North, z down. Each layer is plain data of one vehicle.
// @pre of all: everything finite, u_max_mps >= 0, radii >= 0 and in the order drawn.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "lib/guidance/surroundings.h"

namespace shoal {

/// Moves as the target moves: v = v_t, whatever its length. Zero without a target.
struct FeedForwardLayer {
  bool operator==(const FeedForwardLayer&) const = default;
};

/// Keeps a distance to the target within [r_inner, r_outer]; zero there and without a target.
struct FormationLayer {
  double r_safe_m = 10;     ///< Up to here u_max away.
  double r_inner_m = 80;    ///< From here on no repulsion; > r_safe_m.
  double r_follow_m = 100;  ///< Middle of the zone of rest; > r_inner_m.

  double r_outer_m() const { return 2 * r_follow_m - r_inner_m; }
  double r_max_m() const { return 2 * r_follow_m - r_safe_m; }  ///< From here on u_max toward.

  bool operator==(const FormationLayer&) const = default;
};

/// Keeps away from every member of the group; the sum over them, u_max at most.
struct SurvivalGroupLayer {
  double r_safe_m = 10;   ///< Up to here u_max.
  double r_avoid_m = 40;  ///< From here on nothing; > r_safe_m.

  bool operator==(const SurvivalGroupLayer&) const = default;
};

/// Keeps away from what the sonar sees. With w = ((r_avoid - range) / r_avoid)^3 of each beam that
/// sees something nearer than r_avoid:
///
///   v = -u_max max(w) sum(w direction) / sum(w)
///
/// How many beams an obstacle fills makes no difference. (MuNet sums over the beams, so that its
/// strength grows with their number.)
struct SurvivalSonarLayer {
  double r_avoid_m = 40;  ///< From here on nothing; > 0.

  bool operator==(const SurvivalSonarLayer&) const = default;
};

/// The sum of both, u_max at most.
struct SurvivalLayer {
  SurvivalGroupLayer group = {};
  SurvivalSonarLayer sonar = {};

  bool operator==(const SurvivalLayer&) const = default;
};

[[nodiscard]] Eigen::Vector3d LayerVelocity(const FeedForwardLayer& layer, double u_max_mps,
                                            const Surroundings& surroundings);
[[nodiscard]] Eigen::Vector3d LayerVelocity(const FormationLayer& layer, double u_max_mps,
                                            const Surroundings& surroundings);
[[nodiscard]] Eigen::Vector3d LayerVelocity(const SurvivalGroupLayer& layer, double u_max_mps,
                                            const Surroundings& surroundings);
[[nodiscard]] Eigen::Vector3d LayerVelocity(const SurvivalSonarLayer& layer, double u_max_mps,
                                            const Surroundings& surroundings);
[[nodiscard]] Eigen::Vector3d LayerVelocity(const SurvivalLayer& layer, double u_max_mps,
                                            const Surroundings& surroundings);

using VelocityLayer = std::variant<FeedForwardLayer, FormationLayer, SurvivalGroupLayer,
                                   SurvivalSonarLayer, SurvivalLayer>;

}  // namespace shoal
