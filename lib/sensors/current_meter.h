// Measures how the water moves.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "lib/ocean/current.h"
#include "lib/sensors/measurement_noise.h"

namespace shoal {

struct CurrentMeter {
  MeasurementNoise noise = {};  ///< m/s, of each component.
};

/// Returns the water's velocity over ground, x East, y North, as measurement `number` finds it.
/// @pre finite time
[[nodiscard]] Eigen::Vector2d MeasureCurrent(const CurrentMeter& meter, const Current& current,
                                             double time_s, int64_t number);

}  // namespace shoal
