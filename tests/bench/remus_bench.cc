// What one step of a Remus 100 costs; it must be under 1 microsecond on one core: "of_promise" is
// how many times faster it is. MunetDynamics and MunetPathFollowing are workloads of muNet's own,
// to be run beside it on the same machine; docs/inside/performance.md has what came of that.
//
//   build/bin/remus_bench

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "tests/closed_loops/munet_auv.h"

namespace shoal {
namespace {

constexpr double kStep_s = 0.02;
constexpr double kPromise_s = 1e-6;

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
  state.counters["of_promise"] = benchmark::Counter(
      static_cast<double>(state.iterations()) * kPromise_s, benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(StepOfRemus, default, Remus100Params());
BENCHMARK_CAPTURE(StepOfRemus, munet, MunetRemus100());
BENCHMARK_CAPTURE(StepOfRemus, fossen, FossenRemus100());

void UpdateOfPilot(benchmark::State& state) {
  AuvPilot pilot(DefaultRemusPilot());
  pilot.Start(0, 50);
  AuvMotion motion = {.z_m = 50, .speed_mps = 2};
  for (auto _ : state) {
    motion.psi_rad += 1e-4;
    benchmark::DoNotOptimize(
        pilot.KeepHeadingAndDepth(motion, 1, 60, DepthBound::Level(95), kStep_s));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(UpdateOfPilot);

/// muNet's dynamics, and the attitude, which shoal's step always includes: from 30 m each time.
void MunetDynamics(benchmark::State& state) {
  const Remus100 auv = BuildRemus100(MunetRemus100());
  const Remus100Actuators command = {0.02, 0.01, 1200};
  const Remus100Environment environment = {
      .current_mps = 0.3 * Eigen::Vector3d(std::cos(0.7), std::sin(0.7), 0)};
  Remus100State vehicle;
  for (auto _ : state) {
    vehicle.eta[2] = 30;
    vehicle = Step(auv, vehicle, command, environment, kStep_s);
    benchmark::DoNotOptimize(vehicle);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(MunetDynamics);

/// Path following, autopilots and model, as muNet's loop has them; the path again after its end.
void MunetPathFollowing(benchmark::State& state) {
  const std::vector<Eigen::Vector3d> waypoints_m = {
      {0, 0, 20}, {500, 0, 25}, {500, 500, 30}, {0, 500, 20}};
  constexpr int kSteps = 10'000;
  Remus100State start;
  start.eta[2] = 20;
  int step = kSteps;
  MunetAuv auv(start, 0, 20);
  for (auto _ : state) {
    if (step == kSteps) {
      auv = MunetAuv(start, 0, 20);
      auv.TakePath(waypoints_m, 1200);
      step = 0;
    }
    auv.DecideOnPath();
    auv.Step({});
    ++step;
  }
  benchmark::DoNotOptimize(auv.state);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(MunetPathFollowing);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
