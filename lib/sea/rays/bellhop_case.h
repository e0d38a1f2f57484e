// Scenes in the files of Bellhop: .env, and what it refers to (.ssp, .bty, .ati, .trc, .brc).
//
//   const Result<BellhopCase> bay = ReadBellhopCase("bay.env", text, read_companion);
//
// The subset: one medium; speeds linear in depth (C) or with a .ssp (Q); surface and bottom vacuum,
// rigid, fluid half-space or a table; boundaries of straight pieces without properties of their
// own; attenuation in any unit, in the bottom alone; Thorp's absorption or none. What is beyond it
// is refused with the line, never read as something else. docs/communication/rays.md lists it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/rays/ray_scene.h"

namespace shoal {

struct BellhopCase {
  std::string title;
  RayScene scene;
  bool has_thorp_absorption = false;
  std::vector<double> source_depths_m;
  std::vector<double> receiver_depths_m;
  std::vector<double> receiver_ranges_m;
  char run = 'A';  ///< A: arrivals, R: rays, E: eigenrays, C, I, S: levels.
  double first_launch_rad = 0;
  double last_launch_rad = 0;
  std::vector<std::string> warnings;  ///< What was read and has no effect.
};

/// Bounds of what a file may ask for.
inline constexpr int kMaxBellhopItems = 10'000;

/// Returns the text of the file beside the .env with this ending, ".bty" for example, or nothing if
/// there is none.
using ReadCompanion = std::function<std::optional<std::string>(std::string_view ending)>;

/// Returns the case, or an error with file and line. `name` is that of the .env.
[[nodiscard]] Result<BellhopCase> ReadBellhopCase(const std::string& name, std::string_view text,
                                                  const ReadCompanion& read_companion);

// The companions on their own.

/// .bty or .ati: a type in quotes, the number of points, range in km and depth in m of each.
[[nodiscard]] Result<std::vector<BoundaryPoint>> ReadBellhopBoundary(std::string_view name,
                                                                     std::string_view text);
/// .trc or .brc: the number of rows, angle in degrees, magnitude and phase in degrees of each.
[[nodiscard]] Result<ReflectionTable> ReadBellhopReflection(std::string_view name,
                                                            std::string_view text);
/// .ssp: the number of profiles, their ranges in km, and for each depth the speed at all of them.
[[nodiscard]] Result<std::vector<ProfileAtRange>> ReadBellhopProfiles(
    std::string_view name, std::string_view text, const std::vector<double>& depths_m);

}  // namespace shoal
