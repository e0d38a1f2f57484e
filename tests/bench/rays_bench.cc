// How long it takes to find the arrivals of a link that were not looked for before. Each iteration
// moves the receiver, so that nothing is found twice, but for KeptLink.
//
//   build/bin/rays_bench

#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "lib/sea/acoustics/ray_channel.h"
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

/// What a modem receives over a link whose arrivals are kept; the vehicles move within their cells.
void KeptLink(benchmark::State& state) {
  RayChannelOptions options;
  const RayScene summer = Summer();
  options.profile.assign(summer.water[0].profile.points().begin(),
                         summer.water[0].profile.points().end());
  options.bottom = *FindBottomType("sand");
  options.max_launch_deg = 30;
  RayChannel channel(options, {}, {});
  RayEnd to = {.position_m = {1000.1, 0, 40.1}, .velocity_mps = {1, 1, 0}};
  for (auto _ : state) {
    to.position_m.x() = to.position_m.x() > 1000.9 ? 1000.1 : to.position_m.x() + 0.01;
    benchmark::DoNotOptimize(channel.Receive({.position_m = {0, 0, 8.2}}, to));
  }
}
BENCHMARK(KeptLink);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
