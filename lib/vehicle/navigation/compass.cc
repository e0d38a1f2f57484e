#include "lib/vehicle/navigation/compass.h"

#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

double DeviationAt(const DeviationCoefficients& deviation, double compass_heading_rad) {
  const auto [sine, cosine] = SinCos(compass_heading_rad);
  const auto [sine_of_two, cosine_of_two] = SinCos(2 * compass_heading_rad);
  return deviation.a + deviation.b * sine + deviation.c * cosine + deviation.d * sine_of_two +
         deviation.e * cosine_of_two;
}

double DeviationRms(const DeviationCoefficients& deviation) {
  return std::sqrt(deviation.a * deviation.a +
                   (deviation.b * deviation.b + deviation.c * deviation.c +
                    deviation.d * deviation.d + deviation.e * deviation.e) /
                       2);
}

double ReadCompass(const Compass& compass, double heading_rad, Stream* draws) {
  // The deviation belongs to the compass heading, which is what is looked for: each round of this
  // brings it nearer by the factor kMaxDeviation at least.
  double shown_rad = heading_rad;
  if (compass.deviation != DeviationCoefficients()) {
    constexpr int kRounds = 40;
    for (int i = 0; i < kRounds; ++i) {
      shown_rad = heading_rad - DeviationAt(compass.deviation, shown_rad);
    }
  }
  return WrapTwoPi(shown_rad + compass.bias_rad + compass.noise_rad * draws->Normal());
}

}  // namespace shoal
