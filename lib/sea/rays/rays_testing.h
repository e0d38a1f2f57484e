// What several tests of rays share.
#pragma once

#include <gtest/gtest.h>

#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lib/sea/rays/bellhop_case.h"
#include "lib/sea/rays/eigenrays.h"
#include "tests/golden/read_golden.h"

namespace shoal {

inline constexpr double kDegree = std::numbers::pi / 180;

inline SoundProfile ProfileOf(std::vector<SpeedPoint> points) {
  Result<SoundProfile> profile = SoundProfile::Make(std::move(points));
  EXPECT_TRUE(profile.ok()) << (profile.ok() ? "" : profile.error());
  return profile.ok() ? *profile : SoundProfile();
}

/// Water of this profile over a flat rigid bottom.
inline RayScene LayeredScene(const SoundProfile& profile, double depth_m) {
  RayScene scene;
  scene.water = {{0, profile}};
  scene.bottom = {{0, depth_m}};
  return scene;
}

/// The same section with a bottom that is sloped by nothing that matters, so that it is traced step
/// by step.
inline RayScene AsTraced(RayScene scene, double range_m) {
  const double depth_m = scene.bottom.front().depth_m;
  scene.bottom = {{0, depth_m}, {range_m / 2, depth_m * (1 + 1e-12)}, {range_m, depth_m}};
  return scene;
}

inline RayLimits Fan(double max_launch_deg) {
  RayLimits limits;
  limits.max_launch_rad = max_launch_deg * kDegree;
  return limits;
}

/// A case of tests/golden/rays.
inline BellhopCase GoldenCase(const std::string& name) {
  const auto companion = [&](std::string_view ending) {
    return ReadGoldenText("rays/" + name + std::string(ending));
  };
  Result<BellhopCase> golden =
      ReadBellhopCase(name + ".env", companion(".env").value_or(""), companion);
  EXPECT_TRUE(golden.ok()) << (golden.ok() ? "" : golden.error());
  return golden.ok() ? *golden : BellhopCase();
}

}  // namespace shoal
