// A vertical section of the sea in which rays are traced: water, surface and bottom along a range.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lib/sea/rays/reflection.h"
#include "lib/sea/rays/sound_profile.h"

namespace shoal {

/// A boundary of straight pieces; before its first and beyond its last point it is horizontal.
struct BoundaryPoint {
  double range_m = 0;
  double depth_m = 0;  ///< Down from the mean surface.

  bool operator==(const BoundaryPoint&) const = default;
};

/// The sound speed at ranges of its own, bilinear between them and constant beyond.
struct ProfileAtRange {
  double range_m = 0;
  SoundProfile profile = SoundProfile();

  bool operator==(const ProfileAtRange&) const = default;
};

struct RayScene {
  /// At least one; with more than one, all have the same depths.
  std::vector<ProfileAtRange> water = {{}};
  std::vector<BoundaryPoint> surface = {{0, 0}};   ///< At least one; ranges grow.
  std::vector<BoundaryPoint> bottom = {{0, 100}};  ///< Likewise; below the surface everywhere.
  Reflector surface_reflector = Vacuum();
  Reflector bottom_reflector = RigidWall();
  double hz = 25'000;
  double water_density = 1;

  bool operator==(const RayScene&) const = default;
};

/// Returns the depth of a boundary at this range.
[[nodiscard]] double DepthAt(std::span<const BoundaryPoint> boundary, double range_m);

/// Returns the speed of sound at a place of the scene.
[[nodiscard]] double SpeedAt(const RayScene& scene, double range_m, double depth_m);

/// Returns whether nothing depends on the range: one profile, boundaries of one depth each.
[[nodiscard]] bool IsLayered(const RayScene& scene);

/// Returns "" or what is wrong with the scene.
[[nodiscard]] std::string ProblemOf(const RayScene& scene);

}  // namespace shoal
