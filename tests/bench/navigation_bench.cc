// What one step of a vehicle's navigation costs: instruments and filter. 50 vehicles at 100 times
// real time and 10 steps per second are 50,000 of them a second; "of_promise" is how many times
// faster than that it is, on one core.
//
//   build/bin/navigation_bench

#include <benchmark/benchmark.h>

#include <cstdint>

#include "lib/vehicle/navigation/navigator.h"

namespace shoal {
namespace {

constexpr int64_t kTick_us = 100'000;
constexpr double kPromise_s = 1.0 / 50'000;

InstrumentOptions Fitted() {
  InstrumentOptions options;
  options.compass = {.bias_sigma_rad = 0.01, .noise_rad = 0.01, .rate_hz = 2};
  options.gyro = {.bias_sigma_radps = 1e-5, .noise_rad_per_rts = 1e-4};
  options.dvl = Dvl{.scale_sigma = 0.003, .noise_mps = 0.01};
  options.log = SpeedLog{.noise_mps = 0.05, .rate_hz = 1};
  options.gps = Gps{.noise_m = 2};
  options.ranging = AcousticRanging{.errors = {.noise_m = 1}};
  return options;
}

void StepOfNavigation(benchmark::State& state, int num_beacons) {
  const StreamKey key(1, "bench");
  std::vector<Beacon> beacons(static_cast<size_t>(num_beacons));
  for (Beacon& beacon : beacons) beacon.position_m = {500, 300, 40};
  const InstrumentOptions options = Fitted();
  Instruments instruments(Drawn(options, key), beacons, key);
  Navigator navigator(options, {}, {}, beacons, key);
  navigator.Start({0, 0}, 0);
  const TrueMotion truth = {.position_m = {0, 0, 20},
                            .over_ground_mps = {1.5, 0},
                            .in_water_mps = {1.5, 0},
                            .altitude_m = 20};
  int64_t utime = 0;
  for (auto _ : state) {
    utime += kTick_us;
    navigator.Take(instruments.Read(truth, utime, 0), static_cast<double>(kTick_us) / 1e6);
    benchmark::DoNotOptimize(navigator.filter().solution());
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["of_promise"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kPromise_s, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(StepOfNavigation, without_beacons, 0);
BENCHMARK_CAPTURE(StepOfNavigation, four_beacons, 4);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
