// `seed = "random"`: the number is drawn when a mission is started, and handed on as an override,
// so that all of its processes and its recording have the same.
//
//   std::vector<std::string> overrides = options.overrides;
//   const LoadedMission loaded = LoadMissionToRun(file, DrawSeed, &overrides);
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal {

/// Returns a seed by the system's own chance, below 2^31: short enough to be written down.
[[nodiscard]] uint64_t DrawSeed();

/// Loads a mission that is to be run. Where its seed is "random", calls `draw` once and appends
/// "mission.seed=N" to `overrides`; the mission then has this seed, and draws_seed is false.
[[nodiscard]] LoadedMission LoadMissionToRun(const std::string& path,
                                             const std::function<uint64_t()>& draw,
                                             std::vector<std::string>* overrides);

}  // namespace shoal
