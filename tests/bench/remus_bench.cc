// What one step of a Remus 100 costs; it must be under 1 microsecond on one core.
//
//   build/bin/remus_bench

#include <benchmark/benchmark.h>

#include "lib/control/auv_pilot.h"
#include "lib/vehicle/remus100.h"

namespace shoal {
namespace {

constexpr double kStep_s = 0.02;

void StepOfRemus(benchmark::State& state, const Remus100Params& params) {
  const Remus100 auv = BuildRemus100(params);
  const Remus100Actuators command = {.rudder_rad = 0.05, .propeller_rpm = 1200};
  const Remus100Environment environment = {.current_mps = Eigen::Vector3d(0.3, 0.2, 0),
                                           .floor_z_m = 1e6};
  Remus100State vehicle;
  vehicle.eta[2] = 50;
  for (auto _ : state) {
    vehicle = Step(auv, vehicle, command, environment, kStep_s);
    benchmark::DoNotOptimize(vehicle);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK_CAPTURE(StepOfRemus, default, Remus100Params());
BENCHMARK_CAPTURE(StepOfRemus, munet, MunetRemus100());
BENCHMARK_CAPTURE(StepOfRemus, fossen, FossenRemus100());

void UpdateOfPilot(benchmark::State& state) {
  AuvPilot pilot(DefaultRemusPilot());
  pilot.Start(0, 50);
  AuvMotion motion = {.z_m = 50};
  for (auto _ : state) {
    motion.psi_rad += 1e-4;
    benchmark::DoNotOptimize(pilot.KeepHeadingAndDepth(motion, 1, 60, 100, kStep_s));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(UpdateOfPilot);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
