#include "lib/tools/analysis/information_age.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/tools/analysis/swarm_testing.h"

namespace shoal::information_age_test {

constexpr int64_t kSecond_us = 1'000'000;

/// A time and an age, in seconds.
using Corner = std::pair<double, double>;

struct Ages {
  std::vector<Corner> corners;
  InformationAge ages{
      [this](const AgePoint& point) { corners.emplace_back(Seconds(point.utime), point.age_s); }};

  /// bravo knows at `time_s` where alpha was at `report_s`.
  void Add(double time_s, double report_s) {
    ages.Add(SwarmAt(static_cast<int64_t>(time_s * 1e6), "bravo",
                     {ContactAt("alpha", static_cast<int64_t>(report_s * 1e6))}));
  }
  AgeSummary Summary() { return ages.Summaries().at({"bravo", "alpha"}); }
};

TEST(InformationAge, GrowsWithTimeAndFallsWithANewReport) {
  Ages ages;
  ages.Add(1, 0.5);
  ages.Add(2, 0.5);
  ages.Add(5, 4.5);
  EXPECT_EQ(ages.corners, (std::vector<Corner>{{1, 0.5}, {2, 1.5}, {5, 4.5}, {5, 0.5}}));
}

TEST(InformationAge, HasMeanAndPercentileOverTime) {
  Ages ages;
  ages.Add(1, 1);  // From 0 to 10 in ten seconds, from 0 to 10 again.
  ages.Add(11, 11);
  ages.Add(21, 11);
  const AgeSummary summary = ages.Summary();
  EXPECT_EQ(summary.num_reports, 2);
  EXPECT_TRUE(summary.is_target);
  EXPECT_DOUBLE_EQ(summary.first_report_s, 1);
  EXPECT_DOUBLE_EQ(summary.mean_s, 5);
  EXPECT_DOUBLE_EQ(summary.age_95_s, 9.5);
  EXPECT_DOUBLE_EQ(summary.max_s, 10);
}

TEST(InformationAge, WeighsAgesByHowLongTheyLast) {
  Ages ages;
  ages.Add(0, -100);  // Very old for a second, then fresh for 99.
  for (int time_s = 1; time_s <= 100; ++time_s) ages.Add(time_s, time_s);
  const AgeSummary summary = ages.Summary();
  EXPECT_NEAR(summary.mean_s, (100.5 + 99 * 0.5) / 100, 1e-9);
  EXPECT_NEAR(summary.age_95_s, 95.0 / 99, 1e-9);
  EXPECT_DOUBLE_EQ(summary.max_s, 101);
}

TEST(InformationAge, IsThatOfTheOnlyMessageWhereThereIsOne) {
  Ages ages;
  ages.Add(3, 1);
  EXPECT_DOUBLE_EQ(ages.Summary().mean_s, 2);
  EXPECT_DOUBLE_EQ(ages.Summary().age_95_s, 2);
  EXPECT_DOUBLE_EQ(ages.Summary().max_s, 2);
}

TEST(InformationAge, IsNoneWhileAContactIsNotReceived) {
  Ages ages;
  ages.Add(0, 0);
  ages.Add(2, 0);
  swarm_contact_t unheard = ContactAt("alpha", 0);
  unheard.is_heard = 0;
  ages.ages.Add(SwarmAt(50 * kSecond_us, "bravo", {unheard}));  // A process that began again.
  ages.Add(60, 60);
  ages.Add(62, 60);
  EXPECT_DOUBLE_EQ(ages.Summary().max_s, 2);
  EXPECT_DOUBLE_EQ(ages.Summary().mean_s, 1);
  EXPECT_EQ(ages.Summary().num_reports, 2);
}

TEST(InformationAge, IsNoneWhileTheReportsOfAContactCannotBeUsed) {
  Ages ages;
  ages.Add(0, 0);
  ages.Add(2, 0);
  swarm_contact_t unusable = ContactAt("alpha", 0);
  unusable.is_known = 0;
  ages.ages.Add(SwarmAt(50 * kSecond_us, "bravo", {unusable}));
  ages.Add(60, 60);
  ages.Add(62, 60);
  EXPECT_DOUBLE_EQ(ages.Summary().max_s, 2);
}

TEST(InformationAge, SurvivesTimesThatCannotBe) {
  Ages ages;
  ages.Add(10, 12);
  EXPECT_EQ(ages.ages.num_future(), 1);
  EXPECT_DOUBLE_EQ(ages.Summary().max_s, 0);
  ages.Add(9, 8);
  for (const int64_t utime :
       {std::numeric_limits<int64_t>::min(), std::numeric_limits<int64_t>::max()}) {
    ages.ages.Add(SwarmAt(utime, "bravo", {ContactAt("alpha", 0)}));
    ages.ages.Add(SwarmAt(10 * kSecond_us, "bravo", {ContactAt("alpha", utime)}));
  }
  EXPECT_EQ(ages.ages.num_impossible(), 5);
  EXPECT_EQ(ages.Summary().num_reports, 1);
}

TEST(InformationAge, IsShownForTargetsWhereThereAreMany) {
  InformationAge ages;
  ages.Add(SwarmAt(0, "bravo", {ContactAt("alpha", 0), ContactAt("charlie", -kSecond_us, false)}));
  ages.Add(SwarmAt(4 * kSecond_us, "bravo",
                   {ContactAt("alpha", 0), ContactAt("charlie", -kSecond_us, false)}));
  EXPECT_EQ(ages.Text(50),
            "Age of information [s]            reports first report       mean       95 %        "
            "max\n"
            "  bravo of alpha, its target            1          0.0      2.000      3.800      "
            "4.000\n"
            "  bravo of charlie                      1          0.0      3.000      4.800      "
            "5.000\n"
            "\n");
  const std::string text = ages.Text(1);
  EXPECT_EQ(text.find("charlie"), std::string::npos) << text;
  EXPECT_NE(text.find("(1 contacts that are not targets not shown"), std::string::npos) << text;
  EXPECT_EQ(InformationAge().Text(50), "");
}

TEST(InformationAge, IsATableForOtherPrograms) {
  Ages ages;
  ages.Add(0, 0);
  ages.Add(4, 0);
  EXPECT_EQ(ages.ages.Csv(),
            "vehicle,contact,is_target,num_reports,first_heard_s,age_mean_s,age_95_s,age_max_s\n"
            "bravo,alpha,1,1,0.000000,2.000000,3.800000,4.000000\n");
}

RC_GTEST_PROP(InformationAge, IsWhatItIsInEachMomentOnAverage, ()) {
  Ages ages;
  double report_s = 0;
  std::vector<double> moments;  // The age in the middle of each hundredth of a second.
  const int num_steps = *rc::gen::inRange(1, 30);
  for (int step = 0; step < num_steps; ++step) {
    if (*rc::gen::arbitrary<bool>()) report_s = step - *rc::gen::inRange(0, 4) * 0.25;
    ages.Add(step, report_s);
    for (int i = 0; i < 100; ++i) moments.push_back(step + 0.01 * i + 0.005 - report_s);
  }
  ages.Add(num_steps, report_s);
  double sum_s = 0;
  for (const double age_s : moments) sum_s += age_s;
  std::sort(moments.begin(), moments.end());
  const auto num_moments = static_cast<double>(moments.size());
  RC_ASSERT(std::abs(ages.Summary().mean_s - sum_s / num_moments) < 1e-6);
  const auto rank = static_cast<size_t>(0.95 * num_moments);
  RC_ASSERT(std::abs(ages.Summary().age_95_s - moments[rank]) < 0.02);
}

}  // namespace shoal::information_age_test
