#include <gtest/gtest.h>

#include <string>

#include "lib/tools/metrics/metrics_testing.h"

namespace shoal::check_metrics_test {

constexpr char kMission[] = R"([mission]
duration_s = 100
[[vehicle]]
name = "Alpha"
group = "Survey"
[[vehicle]]
name = "bravo"
model = "remus100"
[[vehicle.task]]
kind = "target_track"
target = "charlie"
[[vehicle]]
name = "charlie"
model = "remus100"
)";

Mission Load(const std::string& text) {
  const LoadedMission loaded = LoadMissionText(text, "m.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

MetricsOfText Check(const std::string& lines) {
  const Mission mission = Load(kMission);
  return ReadMetricsText("[metrics]\n" + lines, &mission);
}

std::string ErrorOf(const std::string& line) {
  const MetricsOfText read = Check(line + "\n");
  EXPECT_EQ(read.errors.size(), 1U) << line;
  return read.errors.empty() ? "" : read.errors.front();
}

TEST(CheckMetrics, AcceptsWhatTheMissionHas) {
  const MetricsOfText read = Check(R"(
a = { kind = "closest_approach", vehicle = "ALPHA", to = "group:survey" }
b = { kind = "closest_approach", vehicle = "bravo", to = "group:survey" }
c = { kind = "formation_error", vehicle = "bravo" }
d = { channel = "HELM_STATE_ALPHA", field = "distance_m" }
e = { channel = "COMMS_FATES", field = "fates[0].range_m", reduce = "max" }
f = { kind = "energy", vehicle = "charlie" }
g = { kind = "information_age" }
h = { kind = "delivery_ratio", traffic = "acks", from = "bravo", to = "alpha" }
)");
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_EQ(read.errors[0].find("c.toml:3:"), 0U)
      << "alpha is the only one of its group: " << read.errors[0];
  EXPECT_EQ(read.metrics[1].to, "group:Survey");
  EXPECT_EQ(read.metrics[7].to, "Alpha") << "as the mission writes it";
}

TEST(CheckMetrics, RefusesVehiclesAndGroupsThatDoNotExist) {
  EXPECT_EQ(ErrorOf("a = { kind = \"arrival_time\", vehicle = \"brabo\" }"),
            "c.toml:2:40: unknown vehicle 'brabo' (did you mean 'bravo'?)");
  EXPECT_EQ(
      ErrorOf("a = { kind = \"delivery_ratio\", to = \"group:surwey\" }").find("c.toml:2:37:"), 0U);
}

TEST(CheckMetrics, RefusesChannelsThatDoNotExist) {
  EXPECT_EQ(ErrorOf("a = { channel = \"NAV_BRAWO\", field = \"x_m\" }"),
            "c.toml:2:17: the mission has no channel 'NAV_BRAWO' (did you mean 'NAV_BRAVO'?)");
  EXPECT_EQ(
      ErrorOf("a = { channel = \"QQQQ\", field = \"x_m\" }"),
      "c.toml:2:17: the mission has no channel 'QQQQ'; docs/reference/channels.md has them all");
  EXPECT_EQ(ErrorOf("a = { channel = \"TICK\", field = \"step\" }"),
            "c.toml:2:17: TICK is not in a mission's log: name a channel that is");
}

TEST(CheckMetrics, RefusesFieldsThatDoNotExistOrAreNoNumbers) {
  EXPECT_EQ(ErrorOf("a = { channel = \"NAV_BRAVO\", field = \"speed_mp\" }"),
            "c.toml:2:38: nav_t has no field 'speed_mp' (did you mean 'speed_mps'?)");
  EXPECT_EQ(ErrorOf("a = { channel = \"HELM_STATE_BRAVO\", field = \"state\" }"),
            "c.toml:2:45: state of helm_state_t is text, no number");
}

TEST(CheckMetrics, RefusesEnergyWhereTheModelHasNone) {
  EXPECT_EQ(ErrorOf("a = { kind = \"energy\" }"),
            "c.toml:2:5: Alpha is a surface_craft, whose model has no power: name vehicles with "
            "model = \"remus100\", or take kind = \"field\" of ACTUATORS_ALPHA, field = "
            "\"thrust_pct\"");
}

TEST(CheckMetrics, RefusesAFormationErrorOfVehiclesThatFollowNone) {
  EXPECT_EQ(
      ErrorOf("a = { kind = \"formation_error\", vehicle = \"charlie\" }").find("c.toml:2:43:"),
      0U);
}

TEST(CheckMetrics, RefusesWhatNeedsASwarm) {
  EXPECT_EQ(
      ErrorOf("a = { kind = \"information_age\", source = \"swarm\" }").find("c.toml:2:42: there"),
      0U);
  EXPECT_EQ(ErrorOf("a = { kind = \"delivery_ratio\", traffic = \"swarm\" }").find("c.toml:2:42:"),
            0U);
}

TEST(CheckMetrics, RefusesTimesBehindTheEnd) {
  EXPECT_EQ(ErrorOf("a = { kind = \"closest_approach\", from_s = 100 }"),
            "c.toml:2:43: from_s = 100 is not before the end of the mission, 100 s: there is "
            "nothing left to measure");
}

TEST(CheckMetrics, RefusesAVehicleWithItself) {
  EXPECT_EQ(
      ErrorOf("a = { kind = \"closest_approach\", vehicle = \"bravo\", to = \"BRAVO\" }"),
      "c.toml:2:58: both ends are the same vehicle: there is nothing to measure between them");
}

TEST(CheckMetrics, LeavesOutMetricsThatAreUnsound) {
  EXPECT_EQ(ErrorOf("a = { kind = \"arrival_time\", vehicle = \"brabo\", within_m = 0 }"),
            "c.toml:2:60: within_m = 0 is out of range; allowed: greater than 0, at most 100000");
}

}  // namespace shoal::check_metrics_test
