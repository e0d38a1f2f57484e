// Noise of a sensor: Gaussian, of mean 0, and the same for the same measurement of the same sensor,
// however often and in whichever process it is computed.
//
//   MeasurementNoise noise{.sigma = 0.1, .key = StreamKey(seed, "altimeter").With("alpha")};
//   Stream stream = noise.Measurement(number);
//   reading += noise.sigma * stream.Normal();
#pragma once

#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

struct MeasurementNoise {
  double sigma = 0;  ///< Standard deviation, in the unit of what is measured; >= 0, finite.
  StreamKey key = StreamKey(0, "no noise");  ///< Of this sensor of this vehicle.

  /// Returns the draws of one measurement.
  [[nodiscard]] Stream Measurement(int64_t number) const { return Stream(key.With(number)); }
};

}  // namespace shoal
