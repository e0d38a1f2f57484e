// No NaN and no infinity leaves lib/ocean and lib/sensors for any finite input. Currents, floors,
// plumes, altimeter and sonar have such tests beside them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/guidance/test_vectors.h"
#include "lib/ocean/current.h"
#include "lib/ocean/perlin_noise.h"
#include "lib/sensors/altimeter.h"
#include "lib/sensors/current_meter.h"

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

RC_GTEST_PROP(FiniteSensors, ReadingsAreFiniteAnywhereAtAnyTime, ()) {
  const SeaFloor floor = FlatFloor(DrawBetween(0, 1000));
  RC_ASSERT(std::isfinite(DepthBelow(floor, AnyFiniteVector())));
  const Altimeter altimeter{.noise = {.sigma = DrawBetween(0, 10)}};
  const auto reading_m = MeasureAltitude(altimeter, floor, AnyFiniteVector(), 7);
  RC_ASSERT(!reading_m || std::isfinite(*reading_m));
  const CurrentMeter meter{.noise = {.sigma = DrawBetween(0, 10)}};
  RC_ASSERT(MeasureCurrent(meter, Current(), AnyFinite(), 7).allFinite());
}

}  // namespace shoal::finite_ocean_test
