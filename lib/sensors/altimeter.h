// Looks straight down and returns how far the sea floor is.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>

#include "lib/ocean/sea_floor.h"
#include "lib/sensors/measurement_noise.h"

namespace shoal {

struct Altimeter {
  double max_range_m = kDeepSea_m;  ///< > 0; what is further away gives no reading.
  MeasurementNoise noise = {};      ///< Metres.
};

/// Returns the true distance from a position down to the floor; 0 for one below it.
/// @pre finite position
[[nodiscard]] double DepthBelow(const SeaFloor& floor, const Eigen::Vector3d& position_m);

/// Returns the reading of measurement `number`, from 0 to max_range_m; none where the floor is out
/// of range. @pre finite position
[[nodiscard]] std::optional<double> MeasureAltitude(const Altimeter& altimeter,
                                                    const SeaFloor& floor,
                                                    const Eigen::Vector3d& position_m,
                                                    int64_t number);

}  // namespace shoal
