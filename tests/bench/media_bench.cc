// How many decisions the whole broker makes per second and core, of node reports of 50 vehicles at
// 4 Hz, in a mission without media and in one with three: see the counter items_per_second. Part of
// routing_bench.
//
//   build/bin/routing_bench --benchmark_filter=Broker
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "apps/shore_broker/shore_broker_app.h"
#include "lib/base/random/stream.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::media_bench {
namespace {

constexpr int64_t kStep_us = 250'000;  ///< Every vehicle reports at 4 Hz.
constexpr uint64_t kSeed = 1;
constexpr int kNumVehicles = 50;

/// 50 vehicles in a square of 400 m, in range of each other.
Mission WithoutMedia() {
  Mission mission;
  mission.seed = kSeed;
  mission.tick_us = kStep_us;
  mission.comms.comms_range_m = 10'000;
  mission.comms.critical_range_m = 0;
  mission.comms.each_fate_up_to = 1'000'000;
  for (int i = 0; i < kNumVehicles; ++i) {
    Vehicle& vehicle = mission.vehicles.emplace_back();
    vehicle.name = "vehicle_" + std::to_string(i);
    vehicle.acoustic_address = i + 1;
  }
  return mission;
}

bool IsUnderwater(int vehicle) { return vehicle % 5 == 0; }

/// The same: 40 surface craft with radio of some latency, jitter and loss, and 10 vehicles below
/// with modems. Between the two, what neither can carry goes by direct.
Mission WithThreeMedia() {
  Mission mission = WithoutMedia();
  mission.comms.reports_over = Over("vhf,acoustic,direct");
  mission.acoustics.is_used = true;
  mission.acoustics.options.access_mode = AccessMode::kShared;
  mission.acoustics.options.data_rate_bps = 20'000;
  MediumOptions vhf = {.name = "vhf"};
  vhf.radio = {.range_m = 5000,
               .horizon = true,
               .path_loss = PathLossModel::kTwoRay,
               .rate_bps = 9600,
               .latency_s = 0.05,
               .jitter_s = 0.1,
               .loss = 0.02};
  mission.media = {vhf};
  for (int i = 0; i < kNumVehicles; ++i) {
    mission.vehicles[static_cast<size_t>(i)].media.names =
        IsUnderwater(i) ? std::vector<std::string>{"vhf", "acoustic"}
                        : std::vector<std::string>{"vhf"};
  }
  return mission;
}

/// The broker among its vehicles.
class Sea {
 public:
  explicit Sea(const Mission& mission) : mission_(mission) {
    Stream stream(kSeed, "fleet");
    for (int i = 0; i < kNumVehicles; ++i) {
      node_report_t& report = reports_.emplace_back();
      report.name = mission.vehicles[static_cast<size_t>(i)].name;
      report.group = i % 2 == 0 ? "red_team" : "blue_team";
      report.x_m = 400 * stream.Uniform();
      report.y_m = 400 * stream.Uniform();
      report.depth_m = IsUnderwater(i) ? 10 : 0;
    }
  }

  /// All report, and all is routed. Vehicles move a metre.
  void Step() {
    utime_ += kStep_us;
    for (node_report_t& report : reports_) {
      report.utime = utime_;
      report.x_m += utime_ / kStep_us % 200 < 100 ? 1 : -1;
      nav_t nav{};
      nav.utime = utime_;
      nav.x_m = report.x_m;
      nav.y_m = report.y_m;
      nav.z_m = report.depth_m;
      Publish(vehicles_, channels::Nav(report.name), nav);
      Publish(vehicles_, channels::NodeReportLocal(), report);
    }
    hub_.NextStep();
    hub_.HandleAll();
    broker_.Tick(utime_);
    hub_.NextStep();
  }

  /// Fates so far.
  int64_t NumFates() const {
    int64_t sum = 0;
    const CauseCounts& counts = broker_.router().counts(Kind::kReport);
    for (const CauseRow& row : kCauseTable) {
      if (row.cause != Cause::kInTransit) sum += counts[static_cast<size_t>(row.cause)];
    }
    return sum;
  }

 private:
  const Mission mission_;
  MemoryBus hub_;
  Bus& vehicles_ = hub_.Join("vehicles");
  ShoreBrokerApp broker_{mission_, hub_.Join("shore_broker")};
  std::vector<node_report_t> reports_;
  int64_t utime_ = 0;
};

void MeasureReports(benchmark::State& state, const Mission& mission) {
  Sea sea(mission);
  for (int i = 0; i < 20; ++i)
    sea.Step();  // From now on all are known, and media are as busy as
                 // they will be.
  const int64_t num_before = sea.NumFates();
  for (auto _ : state) sea.Step();
  state.SetItemsProcessed(sea.NumFates() - num_before);
}

void BrokerWithoutMedia(benchmark::State& state) { MeasureReports(state, WithoutMedia()); }
BENCHMARK(BrokerWithoutMedia);

void BrokerWithThreeMedia(benchmark::State& state) { MeasureReports(state, WithThreeMedia()); }
BENCHMARK(BrokerWithThreeMedia);

}  // namespace
}  // namespace shoal::media_bench
