// The result of a trial from its log is that of the simulation, number by number.
#include "sim/judge_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/mission/file/load.h"
#include "lib/tools/metrics/trial_watch.h"
#include "sim/run_trial.h"

namespace shoal::judge_log_test {

Mission LoadFile(const std::string& name, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded =
      LoadMission(std::string(SHOAL_SOURCE_DIR) + "/missions/" + name, overrides);
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

constexpr char kEndsWithItsTasks[] = R"([mission]
duration_s = 200
[[vehicle]]
name = "alpha"
helm_options = { deploy_at_start = true, end_of_tasks = "end_mission" }
[[vehicle.task]]
kind = "waypoints"
points = [[40, 0]]
speed_mps = 2
[[vehicle]]
name = "bravo"
start = { x_m = 50, y_m = 40 }
[[expect]]
kind = "arrival"
vehicle = "alpha"
point = [40, 0]
within_m = 0.001
)";

Mission LoadText(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = LoadMissionText(text, "m.toml", overrides);
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

/// Metrics of every kind that any mission has.
std::vector<MetricSpec> AnyMetrics(const Mission& mission) {
  const std::string& first = mission.vehicles.front().name;
  std::vector<MetricSpec> metrics = {
      {.name = "age", .kind = MetricKind::kInformationAge, .source = AgeSource::kReports},
      {.name = "age_swarm",
       .kind = MetricKind::kInformationAge,
       .source = AgeSource::kSwarm,
       .reduction = Reduction::kPercentile},
      {.name = "closest", .kind = MetricKind::kClosestApproach, .vehicle = first, .from_s = 30},
      {.name = "closest_of_all", .kind = MetricKind::kClosestApproach},
      {.name = "delivered", .kind = MetricKind::kDeliveryRatio},
      {.name = "packets", .kind = MetricKind::kDeliveryRatio, .traffic = Kind::kPacket},
      {.name = "swarm", .kind = MetricKind::kDeliveryRatio, .traffic = {}},
      {.name = "formation",
       .kind = MetricKind::kFormationError,
       .reduction = Reduction::kPercentile},
      {.name = "home", .kind = MetricKind::kArrivalTime, .vehicle = first},
      {.name = "way", .kind = MetricKind::kDistanceTravelled},
      {.name = "work", .kind = MetricKind::kEnergy, .from_s = 10},
      {.name = "range",
       .kind = MetricKind::kField,
       .channel = "COMMS_FATES",
       .field = "fates[0].range_m",
       .reduction = Reduction::kMean}};
  for (const Reduction reduction : {Reduction::kMin, Reduction::kMax, Reduction::kMean,
                                    Reduction::kPercentile, Reduction::kLast}) {
    metrics.push_back({.name = "speed_" + std::to_string(static_cast<int>(reduction)),
                       .kind = MetricKind::kField,
                       .channel = channels::Nav(first).name,
                       .field = "speed_mps",
                       .reduction = reduction});
  }
  return metrics;
}

std::string LogPath(const std::string& name) {
  return testing::TempDir() + "/judge_log_test_" + std::to_string(getpid()) + name + ".lcm";
}

/// Returns how many of the metrics have a value.
int ExpectSame(const Mission& mission, const std::string& log_name) {
  const std::string path = LogPath(log_name);
  const std::vector<MetricSpec> metrics = AnyMetrics(mission);
  const TrialResult simulated = RunTrial(mission, metrics, {}, path);
  const TrialResult judged = JudgeLog(mission, metrics, path);
  std::filesystem::remove(path);
  EXPECT_EQ(judged.outcome, simulated.outcome) << judged.why;
  EXPECT_EQ(judged.why, simulated.why);
  const std::vector<MetricName> names = TrialWatch::Names(mission, metrics);
  EXPECT_EQ(simulated.metrics.size(), names.size());
  EXPECT_EQ(judged.metrics.size(), names.size());
  int num_values = 0;
  for (size_t i = 0; i < std::min(judged.metrics.size(), simulated.metrics.size()); ++i) {
    EXPECT_EQ(std::bit_cast<uint64_t>(judged.metrics[i]),
              std::bit_cast<uint64_t>(simulated.metrics[i]))
        << names[i].name << ": " << judged.metrics[i] << " and " << simulated.metrics[i];
    if (!std::isnan(simulated.metrics[i])) ++num_values;
  }
  return num_values;
}

TEST(JudgeLog, AgreesWithTheSimulationOfSurfaceCraft) {
  EXPECT_EQ(ExpectSame(LoadFile("berta.toml"), "berta"), 4 + 12);
}

TEST(JudgeLog, AgreesWithTheSimulationOfAFormation) {
  EXPECT_EQ(ExpectSame(LoadFile("swarm_direct.toml", {"mission.duration_s=300"}), "swarm_direct"),
            4 + 14);
}

TEST(JudgeLog, AgreesWithTheSimulationOfAcousticReports) {
  EXPECT_EQ(ExpectSame(LoadFile("acoustic_shared.toml", {"mission.duration_s=300"}), "shared"),
            4 + 12);
}

TEST(JudgeLog, AgreesWithTheSimulationOfASwarm) {
  EXPECT_GE(ExpectSame(LoadFile("swarm_fdma.toml", {"mission.duration_s=200"}), "swarm_fdma"), 15);
}

TEST(JudgeLog, AgreesWithTheSimulationOfMediaAndGateways) {
  EXPECT_GE(ExpectSame(LoadFile("search_gateway.toml"), "gateway"), 12);
}

TEST(JudgeLog, AgreesWithTheSimulationOfEncounters) {
  const Mission mission = LoadFile("encounters/crossing_starboard_75.toml");
  EXPECT_GE(ExpectSame(mission, "encounters"), static_cast<int>(mission.expectations.size()) + 10);
}

TEST(JudgeLog, AgreesWithTheSimulationOfAMissionThatEndsWithItsTasks) {
  const Mission mission = LoadText(kEndsWithItsTasks);
  int64_t last_step = 0;
  const TrialResult result = RunTrial(mission, {}, [&](int64_t step) { last_step = step; });
  EXPECT_LT(last_step, 1000) << "it ends before its time";
  EXPECT_NE(result.why, "");
  EXPECT_GE(ExpectSame(mission, "ends"), 10);
}

TEST(JudgeLog, IsAnErrorWhereTheLogEndsTooEarlyOrIsNone) {
  const Mission mission = LoadText(kEndsWithItsTasks, {"mission.duration_s=5"});
  const std::string path = LogPath("short");
  const TrialResult whole = RunTrial(mission, {}, {}, path);
  EXPECT_NE(whole.outcome, TrialOutcome::kError);
  const Mission longer = LoadText(kEndsWithItsTasks, {"mission.duration_s=6"});
  EXPECT_EQ(JudgeLog(longer, {}, path).why,
            path + ": the log ends before the mission does, which lasts 6 s");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 3);
  const TrialResult torn = JudgeLog(mission, {}, path);
  EXPECT_EQ(torn.outcome, TrialOutcome::kError);
  EXPECT_NE(torn.why, "");
  EXPECT_TRUE(torn.metrics.empty());
  std::filesystem::remove(path);
  EXPECT_EQ(JudgeLog(mission, {}, path).outcome, TrialOutcome::kError);
}

}  // namespace shoal::judge_log_test
