// How many fates the router decides per second and core; see the counter items_per_second.
//
//   build/bin/routing_bench

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/routing/router.h"

namespace {

std::vector<std::string> Names(int count) {
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) names.push_back("vehicle_" + std::to_string(i));
  return names;
}

/// Every vehicle reports once per step; about half of the pairs are in range.
void RouteEverybodysReports(benchmark::State& state) {
  const std::vector<std::string> names = Names(static_cast<int>(state.range(0)));
  shoal::Router router({.comms_range_m = 250, .stale_time_s = 5, .stale_forget_s = 100}, names);
  std::vector<shoal::Decision> decisions;
  std::vector<shoal::Admission> admissions(names.size());
  int64_t utime = 0;
  int64_t num_decisions = 0;
  for (auto _ : state) {
    const auto position_m = [&](size_t i) {
      const double angle = static_cast<double>(i) + 1e-7 * static_cast<double>(utime);
      return Eigen::Vector3d(180 * std::sin(angle), 180 * std::cos(angle), 0);
    };
    for (size_t i = 0; i < names.size(); ++i) {
      admissions[i] =
          router.Admit({.name = names[i], .group = "", .position_m = position_m(i)}, utime);
    }
    for (size_t i = 0; i < names.size(); ++i) {
      decisions.clear();
      router.Route(admissions[i], position_m(i), utime, &decisions);
      num_decisions += static_cast<int64_t>(decisions.size());
      benchmark::DoNotOptimize(decisions.data());
    }
    router.ForgetSilent(utime);
    utime += 500'000;
  }
  state.SetItemsProcessed(num_decisions);
}
BENCHMARK(RouteEverybodysReports)->Arg(2)->Arg(10)->Arg(100)->Arg(1000);

}  // namespace

BENCHMARK_MAIN();
