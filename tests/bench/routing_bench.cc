// How many fates the router decides per second and core; see the counter items_per_second.
//
//   build/bin/routing_bench

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lib/base/random/stream.h"
#include "lib/comms/routing/router.h"
#include "lib/sea/media/radio_link.h"

namespace shoal {
namespace {

constexpr int64_t kStep_us = 250'000;  ///< Every vehicle reports at 4 Hz.
constexpr uint64_t kSeed = 1;

/// All vehicles of a mission, and where they are.
struct Fleet {
  std::vector<std::string> names;
  std::vector<std::string> groups;
  std::vector<Eigen::Vector3d> positions_m;
};

/// Spreads `count` vehicles over a square of this side.
Fleet MakeFleet(int64_t count, double side_m) {
  Fleet fleet;
  Stream stream(kSeed, "fleet");
  for (int64_t i = 0; i < count; ++i) {
    fleet.names.push_back("vehicle_" + std::to_string(i));
    fleet.groups.emplace_back(i % 2 == 0 ? "red_team" : "blue_team");
    fleet.positions_m.emplace_back(side_m * stream.Uniform(), side_m * stream.Uniform(),
                                   10 * stream.Uniform());
  }
  return fleet;
}

/// One step of the broker: all reports in, all routed, silent vehicles forgotten. Vehicles move a
/// metre per step. Calls `on_decisions` after each report; returns how many fates there were.
template <class OnDecisions>
int64_t RouteAStep(const Fleet& fleet, int64_t utime, Router* router,
                   std::vector<Admission>* admissions, std::vector<Decision>* decisions,
                   const OnDecisions& on_decisions) {
  const double moved_m = static_cast<double>(utime) / static_cast<double>(kStep_us);
  admissions->clear();
  for (size_t i = 0; i < fleet.names.size(); ++i) {
    admissions->push_back(router->Admit(
        {.name = fleet.names[i],
         .group = fleet.groups[i],
         .position_m = fleet.positions_m[i] + Eigen::Vector3d(std::fmod(moved_m, 100), 0, 0)},
        utime));
  }
  int64_t num_fates = 0;
  for (const Admission& admission : *admissions) {
    decisions->clear();
    router->Route(admission, utime, decisions);
    num_fates += static_cast<int64_t>(decisions->size());
    benchmark::DoNotOptimize(decisions->data());
    on_decisions();
  }
  router->ForgetSilent(utime);
  return num_fates;
}

int64_t RouteAStep(const Fleet& fleet, int64_t utime, Router* router,
                   std::vector<Admission>* admissions, std::vector<Decision>* decisions) {
  return RouteAStep(fleet, utime, router, admissions, decisions, [] {});
}

void RouteReports(benchmark::State& state, const RoutingRules& rules, double side_m) {
  const Fleet fleet = MakeFleet(state.range(0), side_m);
  Router router(rules, kSeed, fleet.names);
  std::vector<Admission> admissions;
  std::vector<Decision> decisions;
  int64_t utime = 0;
  RouteAStep(fleet, utime, &router, &admissions, &decisions);  // From now on all are known.
  int64_t num_fates = 0;
  for (auto _ : state) {
    utime += kStep_us;
    num_fates += RouteAStep(fleet, utime, &router, &admissions, &decisions);
  }
  state.SetItemsProcessed(num_fates);
}

constexpr int64_t kListEachFate = 1'000'000;

/// The rules under which every vehicle receives every other.
RoutingRules AllInRange() {
  return {.comms_range_m = 10'000, .critical_range_m = 0, .each_fate_up_to = kListEachFate};
}

void ReportsAllInRange(benchmark::State& state) { RouteReports(state, AllInRange(), 400); }
BENCHMARK(ReportsAllInRange)->Arg(2)->Arg(10)->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Arg(1000);

void ReportsWithDropPercentage(benchmark::State& state) {
  RoutingRules rules = AllInRange();
  rules.drop_percentage = 50;
  RouteReports(state, rules, 400);
}
BENCHMARK(ReportsWithDropPercentage)->Arg(100);

void ReportsWithGroupsAndIntervals(benchmark::State& state) {
  RoutingRules rules = AllInRange();
  rules.groups = true;
  rules.min_rpt_interval_s = 1;
  RouteReports(state, rules, 400);
}
BENCHMARK(ReportsWithGroupsAndIntervals)->Arg(100);

void ReportsOutOfRange(benchmark::State& state) {
  RoutingRules rules = AllInRange();
  rules.comms_range_m = 1;
  RouteReports(state, rules, 40'000);
}
BENCHMARK(ReportsOutOfRange)->Arg(10)->Arg(100);

/// One iteration is one step of the whole fleet: must take less than 2 ms.
void StepOfAFleetSpreadOver20Km(benchmark::State& state) {
  RouteReports(state, {.comms_range_m = 250}, 20'000);
}
BENCHMARK(StepOfAFleetSpreadOver20Km)->Arg(1000)->Unit(benchmark::kMillisecond);

void MessagesToAll(benchmark::State& state) {
  const Fleet fleet = MakeFleet(state.range(0), 400);
  RoutingRules rules = AllInRange();
  rules.min_msg_interval_s = -1;
  Router router(rules, kSeed, fleet.names);
  std::vector<Admission> admissions;
  std::vector<Decision> decisions;
  RouteAStep(fleet, 0, &router, &admissions, &decisions);
  std::vector<std::string> unknown_names;
  int64_t num_fates = 0;
  for (auto _ : state) {
    for (const std::string& name : fleet.names) {
      decisions.clear();
      router.RouteMessage({.source = name, .dest_node = "all", .dest_group = "", .length_bytes = 5},
                          kStep_us, &decisions, &unknown_names);
      num_fates += static_cast<int64_t>(decisions.size());
      benchmark::DoNotOptimize(decisions.data());
    }
  }
  state.SetItemsProcessed(num_fates);
}
BENCHMARK(MessagesToAll)->Arg(2)->Arg(10)->Arg(100)->Arg(1000);

/// vhf, acoustic and direct, in order of preference, as in media_bench.cc: of five vehicles one is
/// below, with a modem. Keeps positions by vehicle, as the broker's MediaTraffic does.
class ThreeMedia {
 public:
  explicit ThreeMedia(size_t num_vehicles) {
    for (size_t i = 0; i < num_vehicles; ++i) {
      has_modem_.push_back(i % 5 == 0 ? 1 : 0);
      ends_.emplace_back();
    }
  }

  /// Sets where the vehicles are.
  void Place(const Router& router) {
    for (size_t i = 0; i < ends_.size(); ++i) {
      ends_[i].position_m = router.contact(static_cast<int32_t>(i)).position_m;
      ends_[i].position_m.z() = has_modem_[i] != 0 ? 10 : 0;
    }
  }

  /// Returns the first medium that can carry what the source sends.
  int Choose(const Decision& decision) const {
    const auto from = static_cast<size_t>(decision.source);
    const auto to = static_cast<size_t>(decision.destination);
    if (DecideRadio(vhf_, terms_, ends_[from], ends_[to]).fault == RadioFault::kNone) return 0;
    return has_modem_[from] != 0 && has_modem_[to] != 0 ? 1 : 2;
  }

 private:
  RadioOptions vhf_ = {.range_m = 5000,
                       .horizon = true,
                       .path_loss = PathLossModel::kTwoRay,
                       .rate_bps = 9600,
                       .latency_s = 0.05,
                       .jitter_s = 0.1,
                       .loss = 0.02};
  RadioTerms terms_ = TermsOf(vhf_);
  std::vector<uint8_t> has_modem_;
  std::vector<RadioEnd> ends_;
};

/// Routing alone, no bus and no messages: the router's decision of each link, then the first of
/// three media that can carry it. With `has_media` false the decision alone, in the same loop.
void RouteOverMedia(benchmark::State& state, bool has_media) {
  const Fleet fleet = MakeFleet(state.range(0), 400);
  RoutingRules rules = AllInRange();
  if (has_media) rules.reports_over = Over("vhf,acoustic,direct");
  Router router(rules, kSeed, fleet.names);
  ThreeMedia media(fleet.names.size());
  std::vector<Admission> admissions;
  std::vector<Decision> decisions;
  int64_t utime = 0;
  const auto step = [&] {
    utime += kStep_us;
    if (has_media && utime > kStep_us) media.Place(router);
    return RouteAStep(fleet, utime, &router, &admissions, &decisions, [&] {
      if (!has_media) return;
      for (const Decision& decision : decisions) {
        if (decision.cause != Cause::kInTransit) continue;
        benchmark::DoNotOptimize(media.Choose(decision));
      }
    });
  };
  step();  // From now on all are known.
  int64_t num_fates = 0;
  for (auto _ : state) num_fates += step();
  state.SetItemsProcessed(num_fates);
}

void RoutingWithoutMedia(benchmark::State& state) { RouteOverMedia(state, false); }
BENCHMARK(RoutingWithoutMedia)->Arg(50);

void RoutingWithThreeMedia(benchmark::State& state) { RouteOverMedia(state, true); }
BENCHMARK(RoutingWithThreeMedia)->Arg(50);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
