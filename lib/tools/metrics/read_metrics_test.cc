#include "lib/tools/metrics/read_metrics.h"

#include <gtest/gtest.h>

#include <string>

#include "lib/tools/metrics/metrics_testing.h"

namespace shoal::read_metrics_test {

/// The only error of a file of the table and one line, which is its second.
std::string ErrorOf(const std::string& line) {
  const MetricsOfText read = ReadMetricsText("[metrics]\n" + line + "\n");
  EXPECT_EQ(read.errors.size(), 1U) << line;
  return read.errors.empty() ? "" : read.errors.front();
}

TEST(ReadMetrics, ReadsEachKindByName) {
  const MetricsOfText read = ReadMetricsText(R"([metrics]
way = { kind = "distance_travelled", vehicle = "group:survey" }
age = { kind = "information_age", vehicle = "alpha", to = "bravo", source = "reports", reduce = "max" }
closest_m = { kind = "closest_approach", vehicle = "alpha", to = "all", from_s = 5 }
depth = { channel = "NAV_ALPHA", field = "depth_m", reduce = "percentile", percentile = 90, from_s = 60 }
home = { kind = "arrival_time", point = [1, 2], within_m = 5, stays = true }
formation = { kind = "formation_error", reduce = "min" }
acks = { kind = "delivery_ratio", traffic = "acks", from = "alpha" }
work = { kind = "energy", vehicle = "alpha" }
swarm = { kind = "delivery_ratio", traffic = "swarm" }
)");
  ASSERT_EQ(read.errors, std::vector<std::string>());
  std::vector<MetricSpec> expected(9);
  expected[0] = {
      .name = "acks", .kind = MetricKind::kDeliveryRatio, .traffic = Kind::kAck, .from = "alpha"};
  expected[1] = {.name = "age",
                 .kind = MetricKind::kInformationAge,
                 .vehicle = "alpha",
                 .to = "bravo",
                 .source = AgeSource::kReports,
                 .reduction = Reduction::kMax};
  expected[2] = {
      .name = "closest_m", .kind = MetricKind::kClosestApproach, .vehicle = "alpha", .from_s = 5};
  expected[3] = {.name = "depth",
                 .kind = MetricKind::kField,
                 .channel = "NAV_ALPHA",
                 .field = "depth_m",
                 .reduction = Reduction::kPercentile,
                 .percentile = 90,
                 .from_s = 60};
  expected[4] = {
      .name = "formation", .kind = MetricKind::kFormationError, .reduction = Reduction::kMin};
  expected[5] = {.name = "home",
                 .kind = MetricKind::kArrivalTime,
                 .point_m = Eigen::Vector2d(1, 2),
                 .within_m = 5,
                 .stays = true};
  expected[6] = {.name = "swarm", .kind = MetricKind::kDeliveryRatio, .traffic = {}};
  expected[7] = {.name = "way", .kind = MetricKind::kDistanceTravelled, .vehicle = "group:survey"};
  expected[8] = {.name = "work", .kind = MetricKind::kEnergy, .vehicle = "alpha"};
  EXPECT_EQ(read.metrics, expected);
}

TEST(ReadMetrics, SuggestsTheNearestKindKeyAndWord) {
  EXPECT_EQ(ErrorOf("a = { kind = \"closest_aproach\" }"),
            "c.toml:2:14: unknown kind 'closest_aproach' (did you mean 'closest_approach'?)");
  EXPECT_EQ(ErrorOf("a = { kind = \"energy\", vehicel = \"alpha\" }"),
            "c.toml:2:24: unknown key 'vehicel' (did you mean 'vehicle'?)");
  EXPECT_EQ(ErrorOf("a = { kind = \"formation_error\", reduce = \"maen\" }"),
            "c.toml:2:42: unknown reduce 'maen' (did you mean 'mean'?)");
}

TEST(ReadMetrics, RefusesWhatAKindDoesNotHave) {
  EXPECT_NE(ErrorOf("a = { kind = \"distance_travelled\", from_s = 5 }")
                .find("c.toml:2:36: unknown key 'from_s'"),
            std::string::npos);
  EXPECT_NE(ErrorOf("a = { kind = \"information_age\", reduce = \"last\" }").find("c.toml:2:42:"),
            std::string::npos)
      << "of several contacts none is the last";
  EXPECT_NE(ErrorOf("a = { kind = \"formation_error\", percentile = 90 }").find("c.toml:2:46:"),
            std::string::npos);
}

TEST(ReadMetrics, DemandsWhatIsMissing) {
  EXPECT_NE(ErrorOf("a = { vehicle = \"alpha\" }").find("kind = \"closest_approach\""),
            std::string::npos);
  EXPECT_NE(ErrorOf("a = { channel = \"NAV_ALPHA\" }").find("field = \"speed_mps\""),
            std::string::npos);
  EXPECT_NE(ErrorOf("a = { kind = \"field\", field = \"x_m\" }").find("channel = \"NAV_ALPHA\""),
            std::string::npos);
}

TEST(ReadMetrics, RefusesNamesThatAreTakenOrIllegal) {
  EXPECT_EQ(ErrorOf("pass = { kind = \"energy\" }"),
            "c.toml:2:1: 'pass' is the name of what a campaign has without asking: choose another");
  EXPECT_EQ(ErrorOf("expect_2 = { kind = \"energy\" }"),
            "c.toml:2:1: 'expect_2' is the name of what a campaign has without asking: choose "
            "another");
  EXPECT_EQ(ErrorOf("\"a b\" = { kind = \"energy\" }"),
            "c.toml:2:1: the name of a metric has 1 to 64 letters, digits and '_', not 'a b'");
}

TEST(ReadMetrics, RefusesNumbersOutOfRange) {
  EXPECT_NE(ErrorOf("a = { kind = \"formation_error\", reduce = \"percentile\", percentile = 0 }")
                .find("c.toml:2:69:"),
            std::string::npos);
  EXPECT_NE(ErrorOf("a = { kind = \"energy\", from_s = -1 }").find("c.toml:2:33:"),
            std::string::npos);
  EXPECT_NE(ErrorOf("a = { kind = \"arrival_time\", within_m = 0 }").find("c.toml:2:41:"),
            std::string::npos);
}

TEST(ReadMetrics, FindsAllErrorsInOneGo) {
  const MetricsOfText read = ReadMetricsText(
      "[metrics]\na = { kind = \"enrgy\" }\nb = 5\nc = { kind = \"energy\", x = 1, y = 2 }\n");
  ASSERT_EQ(read.errors.size(), 4U);
  EXPECT_EQ(read.errors[0].find("c.toml:2:"), 0U) << read.errors[0];
  EXPECT_EQ(read.errors[1].find("c.toml:3:"), 0U) << read.errors[1];
  EXPECT_EQ(read.errors[2].find("c.toml:4:24:"), 0U) << read.errors[2];
  EXPECT_EQ(read.errors[3].find("c.toml:4:31:"), 0U) << read.errors[3];
}

TEST(ReadMetrics, RefusesWhatIsNoTable) {
  const MetricsOfText read = ReadMetricsText("metrics = 3\n");
  ASSERT_EQ(read.errors.size(), 1U);
  EXPECT_EQ(read.errors[0],
            "c.toml:1:11: metrics must be a table like [metrics], not a whole "
            "number");
}

}  // namespace shoal::read_metrics_test
