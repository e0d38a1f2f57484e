// Metrics of underwater vehicles found a second way, from the log of the mission.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_reader.h"
#include "lib/mission/file/load.h"
#include "lib/tools/analysis/information_age.h"
#include "sim/run_trial.h"

namespace shoal::trial_metrics_test {

/// A trial of a mission of the repository, and its log.
class RecordedTrial {
 public:
  RecordedTrial(const std::string& name, const std::vector<std::string>& overrides,
                const std::vector<MetricSpec>& metrics)
      : log_path_(testing::TempDir() + "/trial_metrics_test_" + std::to_string(getpid()) + ".lcm") {
    const LoadedMission loaded =
        LoadMission(std::string(SHOAL_SOURCE_DIR) + "/missions/" + name, overrides);
    EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
    result_ = RunTrial(loaded.mission, metrics, {}, log_path_);
    first_metric_ = loaded.mission.expectations.size();
  }
  ~RecordedTrial() { std::filesystem::remove(log_path_); }
  RecordedTrial(const RecordedTrial&) = delete;
  RecordedTrial& operator=(const RecordedTrial&) = delete;

  /// By their names' order.
  double Metric(size_t number) const { return result_.metrics.at(first_metric_ + number); }

  /// Calls `use` with each message of a channel, and the time of its step.
  template <class T, class Use>
  void ForEach(const Channel<T>& channel, Use use) const {
    Result<LogReader> reader = LogReader::Open(log_path_);
    ASSERT_TRUE(reader.ok());
    while (const auto event = reader->Next()) {
      if (event->channel != channel.name) continue;
      T message{};
      ASSERT_TRUE(Decode(event->data, &message));
      use(message, event->utime);
    }
  }

 private:
  std::string log_path_;
  TrialResult result_;
  size_t first_metric_ = 0;
};

TEST(FormationErrorOfATrial, IsThatOfTheTracksInTheLog) {
  const RecordedTrial trial(
      "swarm_direct.toml", {"mission.duration_s=200", "vehicle.bravo.start.x_m=-780"},
      {{.name = "m", .kind = MetricKind::kFormationError, .vehicle = "bravo", .from_s = 5}});
  std::map<int64_t, Eigen::Vector3d> leader_m;
  trial.ForEach(channels::Nav("alpha"), [&](const nav_t& nav, int64_t utime) {
    leader_m[utime] = {nav.x_m, nav.y_m, nav.z_m};
  });
  double sum_m = 0;
  double count = 0;
  trial.ForEach(channels::Nav("bravo"), [&](const nav_t& nav, int64_t utime) {
    if (utime < 5'000'000) return;
    const double range_m = (leader_m.at(utime) - Eigen::Vector3d(nav.x_m, nav.y_m, nav.z_m)).norm();
    sum_m += std::max({0.0, 80 - range_m, range_m - 120});
    ++count;
  });
  EXPECT_GT(sum_m / count, 1) << "it begins 185 m behind";
  EXPECT_NEAR(trial.Metric(0), sum_m / count, 1e-9);
}

TEST(EnergyOfATrial, IsTheWorkOfThePropellersCoefficients) {
  const RecordedTrial trial("swarm_direct.toml", {"mission.duration_s=200"},
                            {{.name = "m", .kind = MetricKind::kEnergy, .vehicle = "bravo"}});
  std::map<int64_t, double> commanded_rpm;
  trial.ForEach(channels::Actuators("bravo"), [&](const actuators_t& actuators, int64_t utime) {
    commanded_rpm[utime] = actuators.propeller_rpm;
  });
  constexpr double kTick_s = 0.1;
  constexpr double kDiameter_m = 0.14;
  double rps = 0;
  double work_j = 0;
  double command_rps = 0;
  trial.ForEach(channels::Nav("bravo"), [&](const nav_t& nav, int64_t utime) {
    if (rps > 0) {
      const double advance = 0.944 * std::max(0.0, nav.surge_mps) / (rps * kDiameter_m);
      const double torque_nm =
          (0.07 - (0.07 - 0.0312) * advance / 0.6632) * 1026 * std::pow(kDiameter_m, 5) * rps * rps;
      work_j += std::max(0.0, 2 * std::numbers::pi * rps * torque_nm) * kTick_s;
    }
    if (commanded_rpm.contains(utime)) {
      command_rps = std::clamp(commanded_rpm[utime], -1525.0, 1525.0) / 60;
    }
    rps += (1 - std::exp(-kTick_s)) * (command_rps - rps);
  });
  EXPECT_GT(work_j, 1000) << "some 10 W and more for 200 s";
  EXPECT_NEAR(trial.Metric(0), work_j, 1e-9 * work_j);
}

TEST(SwarmAgesOfATrial, AreThoseOfTheLogsAnalysis) {
  const MetricSpec mean = {
      .name = "a", .kind = MetricKind::kInformationAge, .vehicle = "bravo", .to = "alpha"};
  MetricSpec percentile = mean;
  percentile.name = "b";
  percentile.reduction = Reduction::kPercentile;
  MetricSpec largest = mean;
  largest.name = "c";
  largest.reduction = Reduction::kMax;
  const RecordedTrial trial("swarm_fdma.toml", {"mission.duration_s=300"},
                            {mean, percentile, largest});
  InformationAge ages;
  trial.ForEach(channels::Swarm("bravo"), [&](const swarm_t& swarm, int64_t) { ages.Add(swarm); });
  const AgeSummary summary = ages.Summaries().at({"bravo", "alpha"});
  EXPECT_GT(summary.num_reports, 3);
  EXPECT_DOUBLE_EQ(trial.Metric(0), summary.mean_s);
  EXPECT_DOUBLE_EQ(trial.Metric(1), summary.age_95_s);
  EXPECT_DOUBLE_EQ(trial.Metric(2), summary.max_s);
}

}  // namespace shoal::trial_metrics_test
