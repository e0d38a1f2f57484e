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
// Where r_pass > 0, survival also steps aside: repulsion alone only slows a vehicle down that comes
// head on. p is the way to what it keeps clear of, e the direction of its own velocity relative to
// that, b the horizontal direction to starboard of e:
//
//   along = p . e     across = p . b     above or below = (p - along e)_z
//   in the way: along > 0, |across| < r_pass, |above or below| < height
//   v_aside = side u_max max((1 - (r / r_avoid)^2) (1 - |across| / r_pass)) b
//   side = -1 (to port) where sum((1 - r / r_avoid) across) > 0, the fuller side being that to
//          starboard; else +1: ties go to starboard
//
// Maximum and sum are over all that is in the way. The height is r_pass for vehicles, and
// kEchoHeight_m for echoes: a floor that the vehicle flies along is not in its way. Two vehicles
// see the same `across` of each other, so that both step to their starboard, or both to port.
//
// Velocities are in world axes: x East, y North, z down. Each layer is plain data of one vehicle.
// @pre of all: everything finite, u_max_mps >= 0, radii >= 0 and in the order drawn.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <variant>

#include "lib/vehicle/guidance/surroundings.h"

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
  double r_pass_m = 0;    ///< Steps aside for what would be passed nearer; 0: never, as muNet.

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
  double r_pass_m = 0;    ///< Steps aside for what would be passed nearer; 0: never.
  double memory_s = 0;    ///< So long an echo counts where it was, seen or not (echo_memory.h).

  bool operator==(const SurvivalSonarLayer&) const = default;
};

/// The sum of both, u_max at most.
struct SurvivalLayer {
  SurvivalGroupLayer group = {};
  SurvivalSonarLayer sonar = {};

  bool operator==(const SurvivalLayer&) const = default;
};

/// An echo this far above or below the line of travel is not in the way.
inline constexpr double kEchoHeight_m = 3;

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

/// Returns the word of mission files: survival, sonar, survival_and_sonar, formation, feed_forward.
[[nodiscard]] std::string_view NameOf(const VelocityLayer& layer);

/// Returns the part of the layer that goes by the sonar; nullptr: none.
[[nodiscard]] const SurvivalSonarLayer* SonarOf(const VelocityLayer& layer);
/// Returns the part of the layer that goes by the group; nullptr: none.
[[nodiscard]] const SurvivalGroupLayer* GroupOf(const VelocityLayer& layer);

}  // namespace shoal
