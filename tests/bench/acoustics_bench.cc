// How many receptions the acoustic network brings to their receivers per second and core; see the
// counter items_per_second. MunetWorkload are workloads of muNet's own, to be run beside it on the
// same machine; docs/inside/performance.md has what came of that.
//
//   build/bin/acoustics_bench

#include <benchmark/benchmark.h>

#include <cstdint>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "lib/sea/acoustics/acoustic_counts_testing.h"
#include "lib/sea/acoustics/acoustic_network.h"

namespace shoal {
namespace {

constexpr double kStep_s = 0.02;
constexpr int kReportBytes = 37;
constexpr uint64_t kSeed = 1;

std::vector<AcousticNode> Nodes(int count) {
  std::vector<AcousticNode> nodes;
  for (int i = 0; i < count; ++i) {
    nodes.push_back({.name = "vehicle_" + std::to_string(i), .address = i + 1});
  }
  return nodes;
}

/// A fleet on a grid of 50 m by default, five to a row, whose vehicles take turns to
/// send.
class Fleet {
 public:
  Fleet(const AcousticOptions& options, int count, double side_m = 50)
      : water_(options, kSeed, Nodes(count)), everybody_(static_cast<size_t>(count)) {
    std::iota(everybody_.begin(), everybody_.end(), 0);
    for (const int i : everybody_)
      positions_m_.emplace_back(side_m * (i % 5), side_m * (i / 5), 20);
  }

  /// Vehicle i sends every `period_s`, at i / count of it, in steps of kStep_s.
  void Run(double duration_s, double period_s) {
    const double first_s = now_s_;
    for (; now_s_ < first_s + duration_s; now_s_ += kStep_s) {
      for (const int i : everybody_) {
        const double phase_s = period_s * i / static_cast<double>(everybody_.size());
        const auto turn = static_cast<int64_t>((now_s_ - phase_s) / period_s + 1);
        if (now_s_ < phase_s || turn == turns_done_[static_cast<size_t>(i)]) continue;
        turns_done_[static_cast<size_t>(i)] = turn;
        water_.Transmit(now_s_, i, positions_m_, bytes_, everybody_);
      }
      benchmark::DoNotOptimize(water_.Deliver(now_s_).data());
    }
  }

  AcousticStatistics statistics() const { return water_.statistics(); }

 private:
  AcousticNetwork water_;
  std::vector<int> everybody_;
  std::vector<Eigen::Vector3d> positions_m_;
  std::vector<int64_t> turns_done_ = std::vector<int64_t>(1000, -1);
  std::vector<uint8_t> bytes_ = std::vector<uint8_t>(kReportBytes, 0x5a);
  double now_s_ = 0;
};

/// Jitter, collisions, packet loss and bit errors; counts what is handed over to receivers. With 20
/// nodes this must be at least 2,000,000.
void FdmaWithAllEffects(benchmark::State& state) {
  AcousticOptions options;
  options.bandwidth_khz = 30;
  Fleet fleet(options, static_cast<int>(state.range(0)));
  for (auto _ : state) fleet.Run(1, 1);
  state.SetItemsProcessed(fleet.statistics().NumHandedOver());
}
BENCHMARK(FdmaWithAllEffects)->Arg(20);

/// The same in half duplex, which lets less than half through; counts what is decided.
void FdmaInHalfDuplex(benchmark::State& state) {
  AcousticOptions options;
  options.bandwidth_khz = 30;
  options.half_duplex = true;
  Fleet fleet(options, static_cast<int>(state.range(0)));
  for (auto _ : state) fleet.Run(1, 1);
  state.SetItemsProcessed(NumDecided(fleet.statistics()));
}
BENCHMARK(FdmaInHalfDuplex)->Arg(20);

/// As FdmaWithAllEffects, but packets are lost by a modem's signal-to-noise ratio: with a code of
/// this block length (1: none), at ranges of hundreds of metres, or (spread) of kilometres, where
/// packets are lost and the sums over a block's wrong bits are longest.
void FdmaWithAModem(benchmark::State& state) {
  AcousticOptions options;
  options.bandwidth_khz = 30;
  options.packet_loss_model = PacketLossModel::kModem;
  options.bit_error_model = BitErrorModel::kOff;
  options.modem = ModemPreset{.name = "bench",
                              .low_khz = 24,
                              .high_khz = 32,
                              .data_rate_bps = 463,
                              .max_packet_bytes = 64,
                              .source_level_db = 168,
                              .modulation = Modulation::kCoherentPsk};
  if (state.range(0) == 127) options.modem->code = {127, 92, 5};
  if (state.range(0) == 1023) options.modem->code = {1023, 723, 30};
  Fleet fleet(options, 20, state.range(1) != 0 ? 1500 : 50);
  for (auto _ : state) fleet.Run(1, 1);
  state.SetItemsProcessed(NumDecided(fleet.statistics()));
}
BENCHMARK(FdmaWithAModem)
    ->ArgNames({"block_bits", "spread"})
    ->ArgsProduct({{1, 127, 1023}, {0, 1}});

/// One of muNet's workloads.
struct Workload {
  const char* name;
  int num_nodes;
  AccessMode mode;
  CollisionModel collisions;
  double period_s;
  bool has_errors;
  double duration_s;
  bool counts_delivered;  ///< Else all that were decided, delivered or not.
};

constexpr AccessMode kFdma = AccessMode::kFdma;
constexpr AccessMode kShared = AccessMode::kShared;
constexpr CollisionModel kOff = CollisionModel::kOff;
constexpr CollisionModel kDrop = CollisionModel::kDrop;
constexpr CollisionModel kCorrupt = CollisionModel::kCorrupt;

constexpr Workload kWorkloads[] = {
    {"10_fdma_off", 10, kFdma, kOff, 1, true, 60, true},
    {"10_fdma_drop", 10, kFdma, kDrop, 1, true, 60, true},
    {"10_shared_off", 10, kShared, kOff, 1, true, 60, true},
    {"10_shared_corrupt", 10, kShared, kCorrupt, 1, true, 60, true},
    {"10_shared_drop", 10, kShared, kDrop, 1, true, 60, false},
    {"10_shared_drop_every_10_s", 10, kShared, kDrop, 10, true, 60, true},
    {"10_fdma_off_every_100_ms", 10, kFdma, kOff, 0.1, false, 10, true},
    {"20_fdma_off", 20, kFdma, kOff, 1, true, 60, true},
    {"20_fdma_drop", 20, kFdma, kDrop, 1, true, 60, true},
    {"20_shared_off", 20, kShared, kOff, 1, true, 60, true},
    {"20_shared_corrupt", 20, kShared, kCorrupt, 1, true, 60, true},
    {"20_shared_drop", 20, kShared, kDrop, 1, true, 60, false},
    {"20_shared_drop_every_10_s", 20, kShared, kDrop, 10, true, 60, true},
    {"20_fdma_off_every_100_ms", 20, kFdma, kOff, 0.1, false, 10, true},
};

void MunetWorkload(benchmark::State& state, const Workload& workload) {
  AcousticOptions options;
  options.bandwidth_khz = 30;
  options.access_mode = workload.mode;
  options.collisions = workload.collisions;
  if (!workload.has_errors) {
    options.packet_loss_model = PacketLossModel::kOff;
    options.bit_error_model = BitErrorModel::kOff;
  }
  int64_t count = 0;
  for (auto _ : state) {
    Fleet fleet(options, workload.num_nodes);
    fleet.Run(workload.duration_s, workload.period_s);
    const AcousticStatistics statistics = fleet.statistics();
    count += workload.counts_delivered ? statistics.NumHandedOver() : NumDecided(statistics);
  }
  state.SetItemsProcessed(count);
}

/// Ten nodes have this many receptions in flight, which then all end: time per reception must not
/// grow faster than the logarithm of their number (and what the processor's caches make of it).
void DrainQueue(benchmark::State& state, AccessMode mode, CollisionModel collisions) {
  AcousticOptions options;
  options.access_mode = mode;
  options.collisions = collisions;
  options.bandwidth_khz = 30;
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kOff;
  constexpr int kNodes = 10;
  AcousticNetwork water(options, kSeed, Nodes(kNodes));
  std::vector<int> all_nodes(kNodes);
  std::iota(all_nodes.begin(), all_nodes.end(), 0);
  std::vector<Eigen::Vector3d> positions_m;
  // A vehicle is far away, so that what it is sent stays in the water meanwhile.
  for (const int i : all_nodes) positions_m.emplace_back(2'000'000.0 * i, 0, 0);
  const std::vector<uint8_t> bytes(kReportBytes, 0x5a);
  const int64_t num_transmissions = state.range(0) / (kNodes - 1);
  double now_s = 0;
  int64_t count = 0;
  for (auto _ : state) {
    for (int64_t i = 0; i < num_transmissions; ++i) {
      now_s += 0.1;
      water.Transmit(now_s, static_cast<int>(i % kNodes), positions_m, bytes, all_nodes);
    }
    now_s += 1e5;
    count += static_cast<int64_t>(water.Deliver(now_s).size());
  }
  state.SetItemsProcessed(count);
}

void RegisterAll() {
  for (const Workload& workload : kWorkloads) {
    benchmark::RegisterBenchmark((std::string("MunetWorkload/") + workload.name).c_str(),
                                 MunetWorkload, workload);
  }
  for (const auto& [name, mode, collisions] :
       {std::tuple("DrainQueue/fdma_off", kFdma, kOff),
        std::tuple("DrainQueue/fdma_drop", kFdma, kDrop),
        std::tuple("DrainQueue/shared_drop", kShared, kDrop),
        std::tuple("DrainQueue/shared_corrupt", kShared, kCorrupt)}) {
    benchmark::RegisterBenchmark(name, DrainQueue, mode, collisions)
        ->Arg(90)
        ->Arg(900)
        ->Arg(9'000)
        ->Arg(90'000)
        ->Arg(900'000);
  }
}

}  // namespace
}  // namespace shoal

int main(int argc, char** argv) {
  shoal::RegisterAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
