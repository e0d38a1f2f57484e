// How long it takes to find the arrivals of a link that were not looked for before. Each iteration
// moves the receiver, so that nothing is found twice.
//
//   build/bin/rays_bench

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "lib/sea/rays/eigenrays.h"

namespace shoal {
namespace {

/// A summer's thermocline of seven layers over 100 m of water and sand; 12 arrivals within 30 deg.
RayScene Summer() {
  const Result<SoundProfile> profile = SoundProfile::Make({{0, 1524},
                                                           {12, 1523.5},
                                                           {18, 1516},
                                                           {25, 1503},
                                                           {32, 1496},
                                                           {45, 1492},
                                                           {70, 1490.5},
                                                           {100, 1490}});
  RayScene scene;
  scene.water = {{0, *profile}};
  scene.bottom = {{0, 100}};
  scene.bottom_reflector = *FindBottomType("sand");
  return scene;
}

void FindLinks(benchmark::State& state, const RayScene& scene, double max_launch_deg) {
  RayLimits limits;
  limits.max_launch_rad = max_launch_deg * std::numbers::pi / 180;
  double range_m = 1000;
  size_t num_arrivals = 0;
  for (auto _ : state) {
    range_m = range_m > 1100 ? 1000 : range_m + 0.01;
    num_arrivals += FindEigenrays(scene, {0, 8}, {range_m, 40}, limits).size();
  }
  state.counters["arrivals"] =
      static_cast<double>(num_arrivals) / static_cast<double>(state.iterations());
}

void LayeredLink(benchmark::State& state) { FindLinks(state, Summer(), 30); }
BENCHMARK(LayeredLink)->Unit(benchmark::kMicrosecond);

void LayeredLinkOfAWideFan(benchmark::State& state) { FindLinks(state, Summer(), 75); }
BENCHMARK(LayeredLinkOfAWideFan)->Unit(benchmark::kMicrosecond);

void LinkOverASlope(benchmark::State& state) {
  RayScene scene = Summer();
  scene.bottom = {{0, 95}, {500, 100}, {1200, 90}};
  FindLinks(state, scene, 30);
}
BENCHMARK(LinkOverASlope)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
