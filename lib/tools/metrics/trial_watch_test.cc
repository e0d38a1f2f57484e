// Metrics of hand-made messages with known answers.
#include "lib/tools/metrics/trial_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/mission/file/load.h"
#include "lib/tools/analysis/swarm_testing.h"
#include "lib/tools/metrics/report_ages.h"
#include "lib/tools/metrics/trial.h"

namespace shoal::trial_watch_test {

constexpr int64_t kSecond_us = 1'000'000;

constexpr char kThree[] = R"([mission]
duration_s = 100
[[vehicle]]
name = "alpha"
[[vehicle]]
name = "bravo"
model = "remus100"
group = "auv"
[[vehicle.task]]
name = "follow"
kind = "target_track"
target = "charlie"
[[vehicle]]
name = "charlie"
model = "remus100"
group = "auv"
)";

/// A mission, its judge and a watch, step by step.
class Trial {
 public:
  Trial(const std::string& text, const std::vector<MetricSpec>& metrics)
      : mission_(Load(text)),
        judge_(mission_),
        watch_(mission_, metrics),
        publisher_(hub_.Join("publisher")),
        embedder_(hub_.Join("embedder")) {
    watch_.Subscribe(embedder_);
  }
  /// Of one metric.
  Trial(const std::string& text, MetricSpec metric) : Trial(text, std::vector{std::move(metric)}) {}

  Bus& bus() { return publisher_; }
  Judge& judge() { return judge_; }
  int64_t utime() const { return mission_.UtimeOf(step_); }

  void EndStep() {
    hub_.NextStep();
    hub_.HandleAll();
    judge_.EndStep(utime());
    watch_.EndStep(judge_);
    ++step_;
  }
  void EndSteps(int count) {
    for (int i = 0; i < count; ++i) EndStep();
  }
  /// A report of `name`, `age_s` old, that `to` receives.
  void Report(const std::string& to, const std::string& name, double age_s) {
    node_report_t report{};
    report.name = name;
    report.utime = utime() - static_cast<int64_t>(age_s * kSecond_us);
    Publish(bus(), channels::NodeReport(to), report);
  }
  /// Of the last metric.
  double Value() const { return watch_.Values(judge_).back(); }

 private:
  static Mission Load(const std::string& text) {
    LoadedMission loaded = LoadMissionText(text, "m.toml");
    EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
    loaded.mission.tick_us = kSecond_us;  // For short tests.
    return loaded.mission;
  }

  Mission mission_;
  Judge judge_;
  TrialWatch watch_;
  MemoryBus hub_;
  Bus& publisher_;
  Bus& embedder_;
  int64_t step_ = 0;
};

TEST(TrialWatch, NamesExpectationsFirstAndThenMetricsByName) {
  const LoadedMission loaded = LoadMissionText(std::string(kThree) + R"(
[[expect]]
kind = "separation"
min_m = 5
[[expect]]
kind = "reports"
at_least_pct = 40
)",
                                               "m.toml");
  const std::vector<MetricSpec> metrics = {
      {.name = "work", .kind = MetricKind::kEnergy, .vehicle = "group:auv", .from_s = 5},
      {.name = "depth",
       .kind = MetricKind::kField,
       .channel = "NAV_BRAVO",
       .field = "z_m",
       .reduction = Reduction::kPercentile}};
  EXPECT_EQ(
      TrialWatch::Names(loaded.mission, metrics),
      (std::vector<MetricName>{
          {.name = "expect_1", .unit = "m", .text = "no two vehicles closer than 5 m"},
          {.name = "expect_2",
           .unit = "%",
           .text = "at least 40 % of reports delivered from all to all"},
          {.name = "depth", .unit = "m", .text = "95 % percentile of z_m of NAV_BRAVO"},
          {.name = "work", .unit = "J", .text = "propeller shaft work of group auv from 5 s on"}}));
}

TEST(TrialWatch, HasAValueForEachNameInTheirOrder) {
  Trial trial(std::string(kThree) + "[[expect]]\nkind = \"separation\"\nmin_m = 5\n",
              std::vector<MetricSpec>{
                  {.name = "z", .kind = MetricKind::kDistanceTravelled, .vehicle = "alpha"},
                  {.name = "a", .kind = MetricKind::kClosestApproach, .vehicle = "alpha"}});
  trial.judge().TakeNav(0, {0, 0, 0});
  trial.judge().TakeNav(1, {30, 40, 0});
  trial.EndStep();
  trial.judge().TakeNav(0, {7, 0, 0});
  trial.judge().TakeNav(1, {100, 0, 0});
  trial.EndStep();
  EXPECT_EQ(trial.Value(), 7);
}

TEST(FieldMetric, TakesEveryMessageFromItsTimeOn) {
  const auto run = [](Reduction reduction) {
    Trial trial(kThree, {.name = "m",
                         .kind = MetricKind::kField,
                         .channel = "NAV_BRAVO",
                         .field = "z_m",
                         .reduction = reduction,
                         .percentile = 50,
                         .from_s = 1});
    for (const double depth_m : {100.0, 2.0, 8.0, 5.0, 3.0}) {
      nav_t nav{};
      nav.z_m = depth_m;
      Publish(trial.bus(), channels::Nav("bravo"), nav);
      Publish(trial.bus(), channels::Nav("alpha"), nav_t{});
      trial.EndStep();
    }
    return trial.Value();
  };
  EXPECT_EQ(run(Reduction::kMean), 4.5) << "the first is before 1 s";
  EXPECT_EQ(run(Reduction::kMin), 2);
  EXPECT_EQ(run(Reduction::kMax), 8);
  EXPECT_EQ(run(Reduction::kLast), 3);
  EXPECT_EQ(run(Reduction::kPercentile), 3);
}

TEST(FieldMetric, HasNoValueWithoutAMessage) {
  Trial trial(kThree,
              {.name = "m", .kind = MetricKind::kField, .channel = "NAV_BRAVO", .field = "z_m"});
  trial.EndStep();
  EXPECT_TRUE(std::isnan(trial.Value()));
}

TEST(FieldMetric, HasNoValueOfAChannelOrFieldThatIsNotThere) {
  for (const auto& [channel, field] :
       {std::pair("NAV_GOLF", "z_m"), std::pair("NAV_BRAVO", "depth")}) {
    Trial trial(kThree,
                {.name = "m", .kind = MetricKind::kField, .channel = channel, .field = field});
    Publish(trial.bus(), channels::Nav("bravo"), nav_t{});
    trial.EndStep();
    EXPECT_TRUE(std::isnan(trial.Value()));
  }
}

TEST(ClosestApproachMetric, IsTheLeastRangeInThreeDimensions) {
  Trial trial(kThree, {.name = "m",
                       .kind = MetricKind::kClosestApproach,
                       .vehicle = "alpha",
                       .to = "group:auv",
                       .from_s = 1});
  trial.judge().TakeNav(0, {0, 0, 0});
  trial.judge().TakeNav(1, {1, 0, 0});
  trial.EndStep();
  EXPECT_TRUE(std::isnan(trial.Value())) << "before its time";
  trial.judge().TakeNav(1, {2, 3, 6});
  trial.judge().TakeNav(2, {2, 3, 7});
  trial.EndStep();
  EXPECT_DOUBLE_EQ(trial.Value(), 7) << "bravo and charlie are nearer to each other";
}

TEST(ClosestApproachMetric, OfAllIsThatOfAnyTwo) {
  Trial trial(kThree, {.name = "m", .kind = MetricKind::kClosestApproach});
  trial.judge().TakeNav(0, {0, 0, 0});
  trial.EndStep();
  EXPECT_TRUE(std::isnan(trial.Value())) << "one vehicle alone";
  trial.judge().TakeNav(1, {100, 3, 6});
  trial.judge().TakeNav(2, {100, 3, 7.5});
  trial.EndStep();
  EXPECT_DOUBLE_EQ(trial.Value(), 1.5);
}

TEST(DistanceMetric, IsTheSumOfTheVehicles) {
  Trial trial(kThree,
              {.name = "m", .kind = MetricKind::kDistanceTravelled, .vehicle = "group:auv"});
  EXPECT_TRUE(std::isnan(trial.Value()));
  for (const double x_m : {0.0, 3.0, -1.0}) {
    for (size_t i = 0; i < 3; ++i) trial.judge().TakeNav(i, {x_m, 0, 0});
    trial.EndStep();
  }
  EXPECT_DOUBLE_EQ(trial.Value(), 14);
}

MetricSpec Arrival(const std::string& vehicle, bool stays) {
  return {.name = "m",
          .kind = MetricKind::kArrivalTime,
          .vehicle = vehicle,
          .point_m = Eigen::Vector2d(100, 0),
          .within_m = 10,
          .stays = stays};
}

/// alpha is there at 2 s, leaves, and is there again from 4 s on; bravo at 3 s.
double ArrivalOf(const std::string& vehicle, bool stays) {
  Trial trial(kThree, Arrival(vehicle, stays));
  for (const auto& [alpha_m, bravo_m] :
       {std::pair(0.0, 0.0), std::pair(50.0, 0.0), std::pair(95.0, 0.0), std::pair(50.0, 110.0),
        std::pair(90.0, 105.0), std::pair(100.0, 105.0)}) {
    trial.judge().TakeNav(0, {alpha_m, 0, 0});
    trial.judge().TakeNav(1, {bravo_m, 0, 50});
    trial.judge().TakeNav(2, {0, 0, 0});
    trial.EndStep();
  }
  return trial.Value();
}

TEST(ArrivalMetric, IsTheFirstTimeOrThatFromWhichOnItStays) {
  EXPECT_EQ(ArrivalOf("alpha", false), 2);
  EXPECT_EQ(ArrivalOf("alpha", true), 4);
  EXPECT_EQ(ArrivalOf("bravo", false), 3);
}

TEST(ArrivalMetric, IsNoneWhereOneNeverArrives) {
  EXPECT_TRUE(std::isnan(ArrivalOf("charlie", false)));
  EXPECT_TRUE(std::isnan(ArrivalOf("all", false)));
}

TEST(FormationMetric, IsTheDistanceToTheZoneOfRestWhileItFollows) {
  const auto run = [](Reduction reduction) {
    Trial trial(kThree, {.name = "m",
                         .kind = MetricKind::kFormationError,
                         .vehicle = "all",
                         .reduction = reduction});
    trial.judge().TakeNav(2, {0, 0, 0});
    trial.judge().TakeNav(1, {0, 0, 500});
    trial.EndStep();  // It has not reported what it does.
    trial.judge().TakeHelm(1, {.state = "DRIVE", .task = "follow"}, trial.utime());
    for (const double range_m : {150.0, 100.0, 75.0}) {  // 80 to 120 m is right.
      trial.judge().TakeNav(1, {0, 0, range_m});
      trial.EndStep();
    }
    trial.judge().TakeHelm(1, {.state = "DRIVE", .task = "end_of_tasks"}, trial.utime());
    trial.judge().TakeNav(1, {0, 0, 900});
    trial.EndStep();
    return trial.Value();
  };
  EXPECT_DOUBLE_EQ(run(Reduction::kMax), 30);
  EXPECT_DOUBLE_EQ(run(Reduction::kMin), 0);
  EXPECT_DOUBLE_EQ(run(Reduction::kMean), 35.0 / 3);
}

TEST(DeliveryMetric, IsTheShareOfTheLinksThatItNames) {
  const auto run = [](std::string from, std::string to, std::optional<Kind> traffic) {
    Trial trial(kThree, {.name = "m",
                         .kind = MetricKind::kDeliveryRatio,
                         .traffic = traffic,
                         .from = std::move(from),
                         .to = std::move(to)});
    FateCounts& reports = trial.judge().tally().fates(Kind::kReport);
    reports.Add("alpha", "bravo", "delivered", 3);
    reports.Add("alpha", "bravo", "stale_receiver", 1);
    reports.Add("alpha", "charlie", "out_of_range", 4);
    reports.Add("bravo", "charlie", "delivered", 1);
    reports.Add("bravo", "*", "out_of_range", 11);
    trial.judge().tally().fates(Kind::kAck).Add("bravo", "alpha", "delivered", 1);
    trial.judge().TakeSwarm(1, "charlie", {.clean = 5, .recovered = 1, .rejected = 2});
    return trial.Value();
  };
  EXPECT_EQ(run("alpha", "bravo", Kind::kReport), 75);
  EXPECT_EQ(run("alpha", "group:auv", Kind::kReport), 37.5);
  EXPECT_EQ(run("group:auv", "group:auv", Kind::kReport), 100);
  EXPECT_EQ(run("all", "all", Kind::kReport), 20) << "those counted together too";
  EXPECT_EQ(run("all", "all", Kind::kAck), 100);
  EXPECT_EQ(run("charlie", "bravo", std::nullopt), 75) << "6 of 8 received were applied";
  EXPECT_TRUE(std::isnan(run("charlie", "all", Kind::kReport))) << "nothing was offered";
}

/// From 1 s to 11 s an age of 0 to 10 s, then of 2 to 12 s until 21 s, the last step.
double ReportAge(Reduction reduction, double percentile, double from_s, const std::string& to) {
  Trial trial(kThree, {.name = "m",
                       .kind = MetricKind::kInformationAge,
                       .vehicle = "alpha",
                       .to = to,
                       .reduction = reduction,
                       .percentile = percentile,
                       .from_s = from_s});
  trial.EndStep();
  trial.Report("alpha", "bravo", 0);
  trial.Report("alpha", "outsider", 0);
  trial.Report("bravo", "charlie", 0);
  trial.EndSteps(10);
  trial.Report("alpha", "bravo", 2);
  trial.EndStep();
  trial.Report("alpha", "bravo", 30);  // Older than what it knows: no news.
  trial.EndSteps(10);
  return trial.Value();
}

TEST(ReportAgeMetric, IsTakenOverTime) {
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kMean, 95, 0, "bravo"), 6);
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kMax, 95, 0, "bravo"), 12);
  // 2 s of the 20 below 2 s, then 2 s in each second up to 10 s: 18 s, then 1 s in each.
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kPercentile, 95, 0, "bravo"), 11);
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kPercentile, 10, 0, "bravo"), 2);
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kPercentile, 100, 0, "bravo"), 12);
}

TEST(ReportAgeMetric, LeavesOutWhatWasBeforeItsTime) {
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kMean, 95, 11, "bravo"), 7);
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kMean, 95, 16, "bravo"), 9.5);
  EXPECT_DOUBLE_EQ(ReportAge(Reduction::kMax, 95, 16, "all"), 12);
}

TEST(ReportAgeMetric, HasNoValueWhereNoReportCame) {
  EXPECT_TRUE(std::isnan(ReportAge(Reduction::kMean, 95, 0, "charlie")));
  EXPECT_TRUE(std::isnan(ReportAge(Reduction::kMean, 95, 50, "bravo"))) << "it ended before";
}

TEST(ReportAges, LeaveOutTimesThatNoMissionHas) {
  ReportAges ages;
  ages.Add(0, 1, std::numeric_limits<int64_t>::min(), 5);
  ages.Add(0, 1, std::numeric_limits<int64_t>::max(), 5);
  EXPECT_TRUE(ages.Teeth(0, 1, 10).empty());
  ages.Add(0, 1, 7, 5);  // From the future.
  ASSERT_EQ(ages.Teeth(0, 1, 9).size(), 1U);
  EXPECT_EQ(ages.Teeth(0, 1, 9)[0].begin_us, 0);
  EXPECT_EQ(ages.Teeth(0, 1, 9)[0].length_us, 4);
}

constexpr char kSwarm[] = R"([mission]
duration_s = 100
[acoustics]
access_mode = "tdma"
[swarm]
leader = "alpha"
[[vehicle]]
name = "alpha"
model = "remus100"
[[vehicle]]
name = "bravo"
model = "remus100"
[[vehicle.task]]
kind = "target_track"
target = "alpha"
swarm = "acoustic"
)";

TEST(SwarmAgeMetric, IsThatOfTheContactsOfTheSwarm) {
  const auto run = [](Reduction reduction, const std::string& to) {
    Trial trial(kSwarm, {.name = "m",
                         .kind = MetricKind::kInformationAge,
                         .vehicle = "bravo",
                         .to = to,
                         .reduction = reduction});
    for (const auto& [time_s, report_s] : {std::pair(1, 1), std::pair(11, 11), std::pair(21, 11)}) {
      Publish(trial.bus(), channels::Swarm("bravo"),
              SwarmAt(time_s * kSecond_us, "bravo", {ContactAt("alpha", report_s * kSecond_us)}));
      Publish(trial.bus(), channels::Swarm("alpha"),
              SwarmAt(time_s * kSecond_us, "alpha", {ContactAt("bravo", -kSecond_us)}));
      trial.EndStep();
    }
    return trial.Value();
  };
  EXPECT_DOUBLE_EQ(run(Reduction::kMean, "alpha"), 5);
  EXPECT_DOUBLE_EQ(run(Reduction::kMax, "alpha"), 10);
  EXPECT_DOUBLE_EQ(run(Reduction::kPercentile, "all"), 9.5);
  EXPECT_TRUE(std::isnan(run(Reduction::kMean, "bravo")));
}

TEST(EnergyMetric, IsTheShaftWorkOfAllStepsFromItsTimeOn) {
  const auto run = [](double from_s) {
    Trial trial(
        kThree,
        {.name = "m", .kind = MetricKind::kEnergy, .vehicle = "group:auv", .from_s = from_s});
    for (int i = 0; i < 60; ++i) {
      for (const auto& vehicle : {"bravo", "charlie"}) {
        actuators_t actuators{};
        actuators.propeller_rpm = 1200;
        Publish(trial.bus(), channels::Actuators(vehicle), actuators);
        Publish(trial.bus(), channels::Nav(vehicle), nav_t{});
      }
      trial.EndStep();
    }
    return trial.Value();
  };
  // Two propellers at rest in the water, at 20 revolutions per second, for 10 s.
  const double torque_nm = 0.07 * 1026 * std::pow(0.14, 5) * 20 * 20;
  EXPECT_NEAR(run(50), 2 * 10 * 2 * std::numbers::pi * 20 * torque_nm, 1e-6);
  EXPECT_GT(run(0), 4 * run(50)) << "60 s, less the time in which they begin to turn";
}

TEST(EnergyMetric, IsNoneWithoutAPosition) {
  Trial trial(kThree, {.name = "m", .kind = MetricKind::kEnergy, .vehicle = "bravo"});
  trial.EndSteps(5);
  EXPECT_TRUE(std::isnan(trial.Value()));
}

}  // namespace shoal::trial_watch_test
