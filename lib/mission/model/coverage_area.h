// What an [[expect]] of kind "coverage" is about, with what it leaves open filled in.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns the polygon of the expectation, or those of its vehicles' surveys, each once.
[[nodiscard]] std::vector<std::vector<Eigen::Vector2d>> PolygonsOf(
    const Mission& mission, const CoverageExpectation& coverage);

/// Returns the vehicles whose tracks count, by their places in the mission.
[[nodiscard]] std::vector<size_t> VehiclesOf(const Mission& mission,
                                             const CoverageExpectation& coverage);

}  // namespace shoal
