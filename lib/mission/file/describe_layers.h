// The layers of a cascade of velocities, as both underwater tasks describe them.
#pragma once

#include <span>
#include <string_view>

#include "lib/mission/toml/fields.h"
#include "lib/vehicle/guidance/velocity_cascade.h"

namespace shoal {

/// What a kind of task makes of the keys of layers.
struct LayerRules {
  std::span<const std::string_view> words;  ///< The layers that it may have.
  bool may_be_none = false;                 ///< Without a layer the other keys are unknown.
  /// Values of keys that are absent.
  SurvivalGroupLayer group = {};
  SurvivalSonarLayer sonar = {};
};

/// target_track: every layer; steps aside for nothing unless the mission demands it, as muNet.
[[nodiscard]] LayerRules LayersOfTracking();
/// path_follow: the layers of survival, which step aside.
[[nodiscard]] LayerRules LayersOfPath();

/// `layers`, `alpha` and the distances.
void DescribeLayers(Fields& fields, const LayerRules& rules, VelocityCascade& cascade);

}  // namespace shoal
