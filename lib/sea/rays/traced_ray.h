// One ray through a section of any kind, step by step, with what changes at its end when its launch
// angle does.
//
//   const RayTracer tracer(scene);
//   const TracedRay ray = tracer.Trace({0, 30}, 1000, launch_rad, {.min_reflection = 1e-4});
//
// The ray equations in slowness form, dx/ds = c xi, dxi/ds = -grad c / c^2, (Jensen,
// Kuperman, Porter, Schmidt, Computational Ocean Acoustics, 2nd ed., sec. 3.2), and their
// derivative by the launch angle with them, by a Runge-Kutta method of sixth order. Steps end on
// every place where the speed or a boundary has a kink.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "lib/sea/rays/eigenrays.h"

namespace shoal {

/// How a ray ended, and where.
struct TracedRay {
  bool arrived = false;  ///< At the wanted range. False: it turned back, or was too weak.
  double depth_m = 0;
  double arrive_rad = 0;
  double delay_s = 0;
  double length_m = 0;
  double depth_slope_m = 0;  ///< d depth / d launch angle at the wanted range, m per rad.
  double reflection = 1;
  double phase_rad = 0;  ///< Boundaries and caustics, not wrapped.
  int num_surface = 0;
  int num_bottom = 0;
  int num_caustics = 0;
  uint64_t turns = 1;    ///< Distinguishes the layers in which it turned, in their order.
  uint64_t history = 1;  ///< Distinguishes the boundary pieces that it met, in their order.
};

class RayTracer {
 public:
  /// Keeps a reference to `scene`. @pre ProblemOf(scene).empty()
  explicit RayTracer(const RayScene& scene);

  /// Traces to `range_m`, which lies beyond the source. With `path`, the places of the ray, its
  /// steps no longer than a hundredth of the way, are appended there: range, depth.
  /// @pre the source is in the water
  [[nodiscard]] TracedRay Trace(const SectionPoint& source, double range_m, double launch_rad,
                                const RayLimits& limits,
                                std::vector<Eigen::Vector2d>* path = nullptr) const;

 private:
  const RayScene& scene_;
  std::vector<double> ranges_m_;  ///< Kinks of boundaries and profiles, growing.
};

}  // namespace shoal
