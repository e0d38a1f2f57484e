// How long a recorded mission takes to open and to scrub: lib/tools/view/recorded_view.h.
//
//   tests/bench/view_bench                      a log of 20 vehicles and 10 minutes, made in /tmp
//   SHOAL_BENCH_LOG=x.lcm tests/bench/view_bench
//
// The reference is a plain pass of LogReader over the same file: `plain_passes` shows how many of
// them one opening takes (about 3, with a file that is in memory).
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <random>

#include "lib/base/text/letters.h"
#include "lib/bus/record/log_writer.h"
#include "lib/tools/view/recorded_view.h"
#include "lib/tools/view/view_testing.h"

namespace shoal {
namespace {

constexpr int kVehicles = 20;
constexpr int kSteps = 6000;
constexpr int64_t kTick_us = 100'000;

double Seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

/// A log that goes when the process ends.
class BenchLog {
 public:
  BenchLog() {
    if (const char* path = std::getenv("SHOAL_BENCH_LOG"); path != nullptr) {
      path_ = path;
      return;
    }
    is_own_ = true;
    path_ = fmt::format("/tmp/shoal_view_bench_{}.lcm", ::getpid());
    Write();
  }
  ~BenchLog() {
    std::error_code ignored;
    if (is_own_) std::filesystem::remove(path_, ignored);
  }
  BenchLog(const BenchLog&) = delete;
  BenchLog& operator=(const BenchLog&) = delete;

  const std::string& path() const { return path_; }

 private:
  void Write() {
    auto writer = LogWriter::Create(path_);
    if (!writer.ok()) std::exit(3);
    for (int step = 0; step < kSteps; ++step) WriteStep(step, &*writer);
    if (writer->Close()) std::exit(3);
  }

  static void WriteStep(int step, LogWriter* log) {
    const int64_t utime = step * kTick_us;
    const auto publish = [&](const std::string& channel, const auto& message) {
      log->Append(utime, channel, Encoded(message));
    };
    std::vector<fate_t> fates;
    std::vector<comms_pulse_t> pulses;
    for (int i = 0; i < kVehicles; ++i) {
      const std::string name = fmt::format("v{:02}", i);
      const double x_m = 100.0 * i + 0.1 * step;
      publish(channels::Nav(name).name, NavAt(utime, x_m, 0));
      publish(channels::Desired(name).name, desired_t{utime, 90, 1, 0});
      helm_state_t helm{};
      helm.utime = utime;
      helm.vehicle = name;
      helm.state = "DRIVE";
      publish(channels::HelmState(name).name, helm);
      if (step % 5 != 0) continue;
      const node_report_t report = ReportOf(name, utime, x_m, 0);
      publish("NODE_REPORT_LOCAL", report);
      for (int j = 0; j < kVehicles; ++j) {
        if (i == j) continue;
        const std::string other = fmt::format("v{:02}", j);
        fates.push_back(
            FateOf(name, other, (i + j + step) % 3 == 0 ? "out_of_range" : "delivered"));
        pulses.push_back(PulseOf(UpperCase(name) + "2" + UpperCase(other), "nrep", 10));
        publish(channels::NodeReport(other).name, report);
      }
    }
    if (fates.empty()) return;
    publish("COMMS_FATES", FatesOf(utime, std::move(fates)));
    publish("VIEW_COMMS_PULSE", PulsesOf(utime, std::move(pulses)));
    if (log->Flush()) std::exit(3);
  }

  std::string path_;
  bool is_own_ = false;
};

const BenchLog& Log() {
  static const BenchLog log;
  return log;
}

RecordedView& View() {
  static const std::unique_ptr<RecordedView> view = [] {
    auto opened = RecordedView::Open(Log().path());
    if (!opened.ok()) {
      fmt::print(stderr, "{}\n", opened.error());
      std::exit(3);
    }
    return std::move(*opened);
  }();
  return *view;
}

int64_t PlainPass() {
  auto reader = LogReader::Open(Log().path(), OnDamage::kSkip);
  int64_t num_events = 0;
  while (reader->Next()) ++num_events;
  return num_events;
}

void BM_PlainPass(benchmark::State& state) {
  int64_t num_events = 0;
  for (auto _ : state) num_events = PlainPass();
  state.counters["events"] = static_cast<double>(num_events);
}
BENCHMARK(BM_PlainPass)->Unit(benchmark::kMillisecond);

void BM_Open(benchmark::State& state) {
  double plain_s = 0;
  double open_s = 0;
  for (auto _ : state) {
    auto begin = std::chrono::steady_clock::now();
    benchmark::DoNotOptimize(PlainPass());
    plain_s += Seconds(begin);
    begin = std::chrono::steady_clock::now();
    auto view = RecordedView::Open(Log().path());
    const double this_s = Seconds(begin);
    open_s += this_s;
    state.SetIterationTime(this_s);
  }
  state.counters["plain_passes"] = open_s / plain_s;
}
BENCHMARK(BM_Open)->UseManualTime()->Unit(benchmark::kMillisecond);

/// Asks at random times.
template <class Ask>
void Scrub(benchmark::State& state, Ask ask) {
  RecordedView& view = View();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> times(view.begin_s(), view.end_s());
  double longest_s = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    ask(view, times(random));
    longest_s = std::max(longest_s, Seconds(begin));
  }
  state.counters["longest_ms"] = longest_s * 1e3;
}

void BM_SeekFrame(benchmark::State& state) {
  Scrub(state,
        [](RecordedView& view, double t_s) { benchmark::DoNotOptimize(view.FrameJson(t_s)); });
}
BENCHMARK(BM_SeekFrame)->Unit(benchmark::kMillisecond);

void BM_SeekFates(benchmark::State& state) {
  Scrub(state,
        [](RecordedView& view, double t_s) { benchmark::DoNotOptimize(view.FatesJson({}, t_s)); });
}
BENCHMARK(BM_SeekFates)->Unit(benchmark::kMillisecond);

void BM_PlayFrame(benchmark::State& state) {
  RecordedView& view = View();
  double t_s = view.begin_s();
  for (auto _ : state) {
    benchmark::DoNotOptimize(view.FrameJson(t_s));
    t_s = t_s + 0.1 < view.end_s() ? t_s + 0.1 : view.begin_s();
  }
}
BENCHMARK(BM_PlayFrame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace shoal

BENCHMARK_MAIN();
