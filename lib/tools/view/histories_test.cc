#include <gtest/gtest.h>

#include <limits>

#include "lib/tools/view/fate_history.h"
#include "lib/tools/view/link_history.h"
#include "lib/tools/view/trail.h"
#include "lib/tools/view/vehicle_history.h"
#include "lib/tools/view/view_testing.h"

namespace shoal::histories_test {

FateView ViewOfFate(const fate_t& fate) {
  FateView view;
  EXPECT_TRUE(ViewOf(fate, 0, &view));
  return view;
}

std::vector<int64_t> Ids(const std::vector<const KeptFate*>& fates) {
  std::vector<int64_t> ids;
  for (const KeptFate* fate : fates) ids.push_back(fate->id);
  return ids;
}

class FateHistoryTest : public testing::Test {
 protected:
  FateHistoryTest() {
    Add("alpha", "bravo", "delivered");     // 1
    Add("alpha", "bravo", "out_of_range");  // 2
    Add("bravo", "charlie", "damaged");     // 3
    fate_t ack = FateOf("charlie", "ALPHA", "dropped");
    ack.kind = "ack";
    history_.Add(ViewOfFate(ack));  // 4
  }
  void Add(std::string_view source, std::string_view destination, std::string_view cause) {
    history_.Add(ViewOfFate(FateOf(source, destination, cause)));
  }

  FateHistory history_;
};

TEST_F(FateHistoryTest, FindsTheNewestFirst) {
  EXPECT_EQ(Ids(history_.Find({})), (std::vector<int64_t>{4, 3, 2, 1}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.limit = 2; }))),
            (std::vector<int64_t>{4, 3}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.limit = -7; }))),
            (std::vector<int64_t>{4}));
}

TEST_F(FateHistoryTest, FiltersByVehicleKindAndCause) {
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.vehicle = "Alpha"; }))),
            (std::vector<int64_t>{4, 2, 1}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.kind = "ack"; }))),
            (std::vector<int64_t>{4}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.cause = "out_of_range"; }))),
            (std::vector<int64_t>{2}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.only_blocked = true; }))),
            (std::vector<int64_t>{4, 2}));
  EXPECT_TRUE(history_.Find(Asked([](FateQuery& q) { q.vehicle = "unknown"; })).empty());
}

TEST_F(FateHistoryTest, MissesNoneWhenAskedAgainAndAgain) {
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) {
              q.after = 1;
              q.limit = 2;
            }))),
            (std::vector<int64_t>{3, 2}));
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.after = 3; }))),
            (std::vector<int64_t>{4}));
  EXPECT_TRUE(history_.Find(Asked([](FateQuery& q) { q.after = 4; })).empty());
  EXPECT_TRUE(
      history_.Find(Asked([](FateQuery& q) { q.after = std::numeric_limits<int64_t>::max(); }))
          .empty());
  EXPECT_EQ(Ids(history_.Find(Asked([](FateQuery& q) { q.after = 0; }))).size(), 4U);
}

TEST_F(FateHistoryTest, FindsTheLastOfOneLink) {
  EXPECT_EQ(Ids(history_.OfLink("ALPHA", "bravo", 50)), (std::vector<int64_t>{2, 1}));
  EXPECT_EQ(Ids(history_.OfLink("alpha", "bravo", 1)), (std::vector<int64_t>{2}));
  EXPECT_TRUE(history_.OfLink("bravo", "alpha", 50).empty());
}

TEST_F(FateHistoryTest, RemembersWhichKindsAndCausesItHasSeen) {
  EXPECT_TRUE(history_.kinds_seen()[static_cast<size_t>(Kind::kAck)]);
  EXPECT_FALSE(history_.kinds_seen()[static_cast<size_t>(Kind::kPacket)]);
  EXPECT_TRUE(history_.causes_seen()[static_cast<size_t>(Cause::kDropped)]);
  EXPECT_FALSE(history_.causes_seen()[static_cast<size_t>(Cause::kTooSoon)]);
}

TEST(FateHistory, ForgetsTheOldest) {
  FateHistory history(1, 10);
  for (int i = 0; i < 25; ++i) {
    fate_t fate = FateOf(std::string(1000, 'x'), "bravo", "delivered");
    fate.number = i;
    history.Add(ViewOfFate(fate));
  }
  EXPECT_EQ(history.size(), 10U);
  EXPECT_EQ(history.num_forgotten(), 15);
  const auto found = history.Find({});
  ASSERT_EQ(found.size(), 10U);
  EXPECT_EQ(found.front()->id, 25);
  EXPECT_EQ(found.back()->id, 16);
  EXPECT_EQ(found.back()->facts.number, 15);
  EXPECT_EQ(found.back()->source.size(), 64U);
  EXPECT_EQ(Ids(history.Find(Asked([](FateQuery& q) {
              q.after = 2;
              q.limit = 3;
            }))),
            (std::vector<int64_t>{18, 17, 16}))
      << "the oldest that are left";
}

FateFacts FactsOf(Cause cause, float range_m = -1) {
  FateFacts facts;
  facts.cause = cause;
  facts.range_m = range_m;
  facts.limit_m = 250;
  return facts;
}

TEST(LinkHistory, CountsInBinsThatGrow) {
  LinkHistory history;
  for (int t = 0; t < 1000; ++t) {
    history.Add(FactsOf(t % 4 == 0 ? Cause::kOutOfRange : Cause::kDelivered), t);
  }
  const std::vector<RatioBin> bins = history.Bins();
  EXPECT_LE(bins.size(), LinkHistory::kMaxBins);
  EXPECT_GT(bins.size(), LinkHistory::kMaxBins / 2);
  int64_t received = 0;
  int64_t offered = 0;
  for (const RatioBin& bin : bins) {
    received += bin.received;
    offered += bin.offered;
  }
  EXPECT_EQ(offered, 1000);
  EXPECT_EQ(received, 750);
  EXPECT_EQ(bins[0].begin_s, 0);
  EXPECT_EQ(bins[1].begin_s, 16);
  EXPECT_EQ(bins[0].offered, 16);
  EXPECT_EQ(bins[0].received, 12);
}

TEST(LinkHistory, LeavesOutBinsWithoutFatesAndSurvivesAnyTime) {
  LinkHistory history;
  history.Add(FactsOf(Cause::kDelivered), -1e300);
  history.Add(FactsOf(Cause::kDelivered), 50.5);
  ASSERT_EQ(history.Bins().size(), 2U);
  EXPECT_EQ(history.Bins()[1].begin_s, 50);
  history.Add(FactsOf(Cause::kDelivered), 1e300);
  EXPECT_EQ(history.Bins().size(), 2U);
}

TEST(LinkHistory, KeepsTheLastRanges) {
  LinkHistory history;
  for (int t = 0; t < 400; ++t) {
    history.Add(FactsOf(Cause::kDelivered, static_cast<float>(t)), t);
    history.Add(FactsOf(Cause::kStaleReceiver), t);
  }
  ASSERT_EQ(history.ranges().size(), LinkHistory::kMaxRanges);
  EXPECT_EQ(history.ranges().front().range_m, 100);
  EXPECT_EQ(history.ranges().back().t_s, 399);
  EXPECT_EQ(history.ranges().back().limit_m, 250);
}

TEST(Trail, IsThinnedEvenlyAndBounded) {
  Trail trail;
  const int num_steps = 200'000;
  for (int i = 0; i <= num_steps; ++i) trail.Add(i / 10.0, i, -i);
  const auto points = trail.points();
  EXPECT_LE(points.size(), Trail::kMaxPoints);
  EXPECT_GT(points.size(), Trail::kMaxPoints / 2);
  EXPECT_EQ(points[0].t_s, 0);
  const double step_s = points[1].t_s - points[0].t_s;
  EXPECT_EQ(step_s, 16);
  for (size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].t_s - points[i - 1].t_s, step_s, 1e-9);
    EXPECT_FLOAT_EQ(points[i].x_m, static_cast<float>(10 * points[i].t_s));
  }
  EXPECT_GT(points.back().t_s, num_steps / 10.0 - step_s);
}

TEST(Trail, BeginsAnewWhenTimeGoesBack) {
  Trail trail;
  for (int t = 0; t < 5000; ++t) trail.Add(t, t, 0);
  trail.Add(10, 7, 8);
  ASSERT_EQ(trail.points().size(), 1U);
  EXPECT_EQ(trail.points()[0].x_m, 7);
  trail.Add(10.5, 9, 9);
  EXPECT_EQ(trail.points().size(), 2U) << "as dense as at first";
}

TEST(Trail, IgnoresPositionsThatAreNotFinite) {
  Trail trail;
  trail.Add(0, std::numeric_limits<double>::quiet_NaN(), 0);
  trail.Add(std::numeric_limits<double>::infinity(), 0, 0);
  EXPECT_TRUE(trail.points().empty());
  trail.Add(1e11, 0, 0);
  trail.Add(-1e11, 0, 0);
  EXPECT_EQ(trail.points().size(), 1U);
}

TEST(VehicleHistory, KeepsTheLastMinutesDenselyAndAnHourSparsely) {
  VehicleHistory history;
  desired_t desired{};
  desired.heading_deg = 90;
  for (int i = 0; i <= 72'000; ++i) {  // Two hours.
    nav_t nav = NavAt(0, 0, 0);
    nav.speed_mps = i;
    history.Add(i / 10.0, nav, i < 60'000 ? std::nullopt : std::optional(desired));
  }
  const auto minute = history.Window(7200, 60);
  ASSERT_EQ(minute.size(), 301U);
  EXPECT_NEAR(minute[1].t_s - minute[0].t_s, 0.2, 1e-9);
  EXPECT_EQ(minute.back().t_s, 7200);
  EXPECT_EQ(minute.back().speed_mps, 72'000);
  EXPECT_EQ(minute.back().desired_heading_deg, 90);
  EXPECT_TRUE(std::isnan(minute.back().altitude_m)) << "a negative one is not known";
  const auto hour = history.Window(7200, 3600);
  EXPECT_LE(hour.size(), VehicleHistory::kMaxAnswer);
  EXPECT_GT(hour.size(), VehicleHistory::kMaxAnswer / 2);
  EXPECT_LT(hour.front().t_s, 3620);
  EXPECT_TRUE(std::isnan(hour.front().desired_heading_deg));
  for (size_t i = 1; i < hour.size(); ++i) EXPECT_LT(hour[i - 1].t_s, hour[i].t_s);
  EXPECT_TRUE(history.Window(100, 60).empty()) << "forgotten";
}

TEST(VehicleHistory, BeginsAnewWhenTimeGoesBack) {
  VehicleHistory history;
  history.Add(100, NavAt(0, 0, 0), std::nullopt);
  history.Add(100.1, NavAt(0, 0, 0), std::nullopt);
  history.Add(50, NavAt(0, 0, 0), std::nullopt);
  EXPECT_EQ(history.Window(100, 1000).size(), 1U);
}

TEST(ThinEvenly, KeepsTheLast) {
  std::vector<ChartPoint> points;
  for (int i = 0; i < 1001; ++i) points.push_back({.t_s = static_cast<double>(i)});
  ThinEvenly(&points, 100);
  EXPECT_LE(points.size(), 100U);
  EXPECT_GT(points.size(), 80U);
  EXPECT_EQ(points.back().t_s, 1000);
  ThinEvenly(&points, 1);
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].t_s, 1000);
}

}  // namespace shoal::histories_test
