// All rays between two points of a section of the sea: when, how strong and from where each
// arrives.
//
//   RayScene scene = {.water = {{0, profile}}, .bottom = {{0, 100}}, .bottom_reflector = sand};
//   for (const RayArrival& arrival : FindEigenrays(scene, {0, 30}, {1000, 60}, {})) ...
//
// Rays are geometric: the wave equation in the limit of high frequency. Within that, in a layered
// scene (IsLayered) each arrival is exact to rounding: each layer is an arc of closed form, and the
// search is for each history of turns and bounces between the launch angles at which a history
// changes its kind. Other scenes are traced with steps of sixth order that end on every layer,
// profile and boundary piece, and the launch fan is refined where histories change.
//
// What is not in it: sound in shadow zones and beyond caustics (diffraction); the level within some
// wavelengths of a caustic, where geometry has infinity (RayArrival::spread_m shows how near);
// displacement of beams at the bottom; shear waves; horizontal refraction; rays that turn back in
// range; launch angles beyond RayLimits::max_launch_rad.
#pragma once

#include <vector>

#include "lib/sea/rays/ray_scene.h"

namespace shoal {

/// A point of a section.
struct SectionPoint {
  double range_m = 0;
  double depth_m = 0;
};

/// What is searched.
struct RayLimits {
  double max_launch_rad = 1.3;   ///< From the horizontal, up and down; in (0, pi/2).
  double min_reflection = 1e-4;  ///< Arrivals whose boundaries returned less are left out.
  int max_bounces = 400;         ///< Likewise those with more bounces.
};

struct RayArrival {
  double delay_s = 0;
  double amplitude =
      0;  ///< Of the pressure, relative to 1 m: spreading and boundaries; no absorption.
  double phase_rad = 0;   ///< (-pi, pi]: boundaries, and pi/2 for each caustic.
  double launch_rad = 0;  ///< From the horizontal, positive down, in the direction of travel.
  double arrive_rad = 0;  ///< Likewise, at the receiver.
  int num_surface = 0;    ///< Bounces.
  int num_bottom = 0;
  int num_caustics = 0;
  double reflection = 1;  ///< Product of the boundaries' magnitudes, contained in amplitude.
  double length_m = 0;    ///< Of the path, for absorption.
  double spread_m = 0;    ///< |d depth / d launch angle| at the receiver, m per rad; 0: a caustic.
};

/// Returns the arrivals in order of delay, the source at source.range_m, the receiver at a larger
/// range or at a smaller one, in which case the section is looked at from the other side. Empty:
/// there is no ray; also where an end is not in the water.
/// @pre ProblemOf(scene).empty(), limits in their ranges, finite points
[[nodiscard]] std::vector<RayArrival> FindEigenrays(const RayScene& scene,
                                                    const SectionPoint& source,
                                                    const SectionPoint& receiver,
                                                    const RayLimits& limits);

/// Returns the power of an arrival relative to that at 1 m, sound that the water absorbs on the way
/// taken away.
[[nodiscard]] double PowerOf(const RayArrival& arrival, double absorption_dbpkm);

/// Returns the phase in (-pi, pi].
[[nodiscard]] double WrappedPhase(double phase_rad);

}  // namespace shoal
