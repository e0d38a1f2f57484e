// No NaN and no infinity leaves lib/sea/ocean for any finite input. Currents, floors, plumes and
// sonar have such tests beside them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/sea/ocean/current.h"
#include "lib/sea/ocean/perlin_noise.h"
#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::finite_ocean_test {

RC_GTEST_PROP(FiniteOcean, CurrentsAreFiniteForAnyDeviation, ()) {
  RC_ASSERT(Velocity({.speed_mps = AnyFinite(), .direction_rad = AnyFinite()}).allFinite());
  const Flow flow = FlowAt({}, AnyFinite(), AnyFinite());
  RC_ASSERT(std::isfinite(flow.speed_mps) && std::isfinite(flow.direction_rad));
  const HalfPeriod half_period{.start_amplitude = std::abs(AnyFinite()),
                               .end_amplitude = std::abs(AnyFinite()),
                               .above_mean = *rc::gen::arbitrary<bool>()};
  RC_ASSERT(std::isfinite(DeviationAt(half_period, DrawBetween(0, 1))));
}

RC_GTEST_PROP(FiniteOcean, NoiseIsFiniteAnywhere, ()) {
  static const PerlinPermutation permutation = DrawPermutation(StreamKey(1, "finite"));
  RC_ASSERT(std::abs(FractalNoise(permutation, {}, AnyFinite(), AnyFinite())) < 10);
}

}  // namespace shoal::finite_ocean_test
