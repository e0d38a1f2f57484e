// A whole trial, and its metrics found a second way: from its log, by other code.
#include "sim/run_trial.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_reader.h"
#include "lib/mission/file/load.h"
#include "lib/tools/metrics/trial_watch.h"
#include "lib/tools/plot/plot_distances.h"
#include "lib/tools/rebroker/link_table.h"
#include "sim/simulation.h"

namespace shoal::run_trial_test {

Mission LoadFile(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded =
      LoadMission(std::string(SHOAL_SOURCE_DIR) + "/missions/" + name, overrides);
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

std::string LogPath(const std::string& name) {
  return testing::TempDir() + "/run_trial_test_" + std::to_string(getpid()) + name + ".lcm";
}

std::string ContentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Calls `use` with each message of a channel of the log, and its step's time.
template <class T, class Use>
void ForEach(const std::string& path, const Channel<T>& channel, Use use) {
  Result<LogReader> reader = LogReader::Open(path);
  ASSERT_TRUE(reader.ok());
  while (const auto event = reader->Next()) {
    if (event->channel != channel.name) continue;
    T message{};
    ASSERT_TRUE(Decode(event->data, &message));
    use(message, event->utime);
  }
}

const std::vector<MetricSpec>& BertaMetrics() {
  static const std::vector<MetricSpec> metrics = {
      {.name = "age_mean", .kind = MetricKind::kInformationAge, .vehicle = "bravo", .to = "alpha"},
      {.name = "closest", .kind = MetricKind::kClosestApproach, .vehicle = "alpha"},
      {.name = "delivered", .kind = MetricKind::kDeliveryRatio, .from = "alpha", .to = "bravo"},
      {.name = "home", .kind = MetricKind::kArrivalTime, .vehicle = "alpha", .stays = true},
      {.name = "speed",
       .kind = MetricKind::kField,
       .channel = "NAV_ALPHA",
       .field = "speed_mps",
       .reduction = Reduction::kPercentile,
       .percentile = 90},
      {.name = "way", .kind = MetricKind::kDistanceTravelled, .vehicle = "alpha"}};
  return metrics;
}

class Berta : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    mission_ = new Mission(LoadFile("berta.toml"));
    result_ = new TrialResult(RunTrial(*mission_, BertaMetrics(), {}, LogPath("berta")));
  }
  static void TearDownTestSuite() {
    std::filesystem::remove(LogPath("berta"));
    delete mission_;
    delete result_;
  }

  static double Metric(const std::string& name) {
    const std::vector<MetricName> names = TrialWatch::Names(*mission_, BertaMetrics());
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const MetricName& each) { return each.name == name; });
    return result_->metrics.at(static_cast<size_t>(found - names.begin()));
  }

  static Mission* mission_;
  static TrialResult* result_;
};
Mission* Berta::mission_ = nullptr;
TrialResult* Berta::result_ = nullptr;

TEST_F(Berta, PassesWithoutAReason) {
  EXPECT_EQ(result_->outcome, TrialOutcome::kPass) << result_->why;
  EXPECT_EQ(result_->why, "");
  EXPECT_EQ(result_->metrics.size(), 4U + 6U);
}

TEST_F(Berta, HasTheLogThatItHasWithoutMetrics) {
  const std::string path = LogPath("plain");
  {
    Simulation simulation(*mission_, path);
    while (simulation.Step()) {
    }
  }
  const std::string plain = ContentOf(path);
  EXPECT_GT(plain.size(), 1'000'000U);
  EXPECT_TRUE(plain == ContentOf(LogPath("berta")));
  std::filesystem::remove(path);
}

TEST_F(Berta, ComesAsCloseAsItsTracksDo) {
  std::map<int64_t, std::vector<Eigen::Vector3d>> positions_m;
  for (const auto& vehicle : {"alpha", "bravo"}) {
    ForEach(LogPath("berta"), channels::Nav(vehicle), [&](const nav_t& nav, int64_t utime) {
      positions_m[utime].emplace_back(nav.x_m, nav.y_m, nav.z_m);
    });
  }
  double closest_m = 1e9;
  for (const auto& [utime, both] : positions_m) {
    closest_m = std::min(closest_m, NearestDistances_m(both)[0]);
  }
  EXPECT_DOUBLE_EQ(Metric("closest"), closest_m);
  EXPECT_DOUBLE_EQ(Metric("expect_2"), closest_m);
}

TEST_F(Berta, DeliversWhatItsTableOfLinksHas) {
  LinkTable table;
  ForEach(LogPath("berta"), channels::CommsFates(), [&](const comms_fates_t& fates, int64_t) {
    for (const fate_t& fate : fates.fates) table.AddRecorded(fate);
  });
  const auto count = [&](const std::string& cause) {
    return static_cast<double>(table.Of("report", "alpha", "bravo", cause).recorded);
  };
  const double delivered = count("delivered");
  EXPECT_GT(delivered, 0);
  EXPECT_DOUBLE_EQ(Metric("delivered"), 100 * delivered / (delivered + count("out_of_range")));
  EXPECT_EQ(Metric("expect_3"), delivered);
}

TEST_F(Berta, KnowsAsOldAsTheReportsThatArrived) {
  // The area below the saw tooth, step by step.
  std::map<int64_t, int64_t> received;  // By step's time: when the last report was made.
  ForEach(LogPath("berta"), channels::NodeReport("bravo"),
          [&](const node_report_t& report, int64_t utime) { received[utime] = report.utime; });
  ASSERT_GT(received.size(), 50U);
  const int64_t end_utime = mission_->UtimeOf(mission_->LastStep());
  double area_s2 = 0;
  int64_t made_utime = 0;
  for (int64_t utime = received.begin()->first; utime < end_utime; utime += mission_->tick_us) {
    if (received.contains(utime)) made_utime = received[utime];
    const double age_s = Seconds(utime - made_utime);
    const double tick_s = Seconds(mission_->tick_us);
    area_s2 += tick_s * (age_s + tick_s / 2);
  }
  const double whole_s = Seconds(end_utime - received.begin()->first);
  EXPECT_NEAR(Metric("age_mean"), area_s2 / whole_s, 1e-9);
  EXPECT_GT(Metric("age_mean"), 1) << "they are out of range for long";
}

TEST_F(Berta, TravelsAndArrivesAsItsTrackDoes) {
  std::vector<double> speeds_mps;
  double way_m = 0;
  double there_since_s = -1;
  std::vector<Eigen::Vector2d> track_m;
  const Eigen::Vector2d home_m = mission_->vehicles[0].return_task.point_m;
  ForEach(LogPath("berta"), channels::Nav("alpha"), [&](const nav_t& nav, int64_t utime) {
    speeds_mps.push_back(nav.speed_mps);
    track_m.emplace_back(nav.x_m, nav.y_m);
    if (track_m.size() > 1) way_m += (track_m.back() - track_m[track_m.size() - 2]).norm();
    const bool is_there = (track_m.back() - home_m).norm() <= 20;
    if (!is_there) there_since_s = -1;
    if (is_there && there_since_s < 0) there_since_s = Seconds(utime);
  });
  EXPECT_NEAR(Metric("way"), way_m, 1e-6);
  EXPECT_DOUBLE_EQ(Metric("home"), there_since_s);
  std::sort(speeds_mps.begin(), speeds_mps.end());
  const size_t rank = (speeds_mps.size() * 90 + 99) / 100;
  EXPECT_EQ(Metric("speed"), speeds_mps[rank - 1]);
}

TEST(RunTrial, NamesWhatWasMissed) {
  const TrialResult result =
      RunTrial(LoadFile("berta.toml", {"comms.comms_range=\"nolimit\""}), {});
  EXPECT_EQ(result.outcome, TrialOutcome::kFail);
  EXPECT_NE(result.why.find(
                "at least 100 reports out_of_range from all to all: 0, 100 too few [berta.toml:"),
            std::string::npos)
      << result.why;
}

TEST(RunTrial, NamesCollisions) {
  const LoadedMission loaded = LoadMissionText(R"([mission]
duration_s = 20
[[vehicle]]
name = "alpha"
[[vehicle]]
name = "bravo"
start = { x_m = 1 }
)",
                                               "m.toml");
  const TrialResult result = RunTrial(loaded.mission, {});
  EXPECT_EQ(result.outcome, TrialOutcome::kFail);
  EXPECT_EQ(result.why, "alpha and bravo collide at 0.0 s");
}

TEST(RunTrial, IsAnErrorWhereTheLogCannotBeWritten) {
  const TrialResult result = RunTrial(LoadFile("berta.toml"), {}, {}, "/nowhere/at/all.lcm");
  EXPECT_EQ(result.outcome, TrialOutcome::kError);
  EXPECT_NE(result.why.find("/nowhere/at/all.lcm"), std::string::npos) << result.why;
  EXPECT_TRUE(result.metrics.empty());
}

TEST(RunTrial, ReportsEachStep) {
  const LoadedMission loaded =
      LoadMissionText("[mission]\nduration_s = 1\n[[vehicle]]\nname = \"alpha\"\n", "m.toml");
  std::vector<int64_t> steps;
  const TrialResult result =
      RunTrial(loaded.mission, {}, [&](int64_t step) { steps.push_back(step); });
  EXPECT_EQ(result.outcome, TrialOutcome::kPass) << result.why;
  ASSERT_EQ(steps.size(), 11U);
  EXPECT_EQ(steps.front(), 0);
  EXPECT_EQ(steps.back(), 10);
}

}  // namespace shoal::run_trial_test
