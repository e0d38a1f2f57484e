#include "lib/tools/plot/plot_curve.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

namespace shoal::plot_curve_test {

Stroke AllPoints(const ThinnedCurve& curve) {
  Stroke all;
  for (const Stroke& stroke : curve.Strokes()) all.insert(all.end(), stroke.begin(), stroke.end());
  return all;
}

TEST(ThinnedCurve, KeepsAShortCurveAsItIs) {
  ThinnedCurve curve;
  const Stroke points = {{0, 3}, {1, 1}, {2, 2}};
  for (const CurvePoint& point : points) EXPECT_TRUE(curve.Add(point.x, point.y));
  EXPECT_EQ(curve.Strokes(), std::vector<Stroke>{points});
}

TEST(ThinnedCurve, HasFiveThousandPointsAtMostAndStillEveryPeak) {
  ThinnedCurve curve;
  constexpr int kPoints = 300'000;
  for (int i = 0; i < kPoints; ++i) {
    double y = (i * 37) % 100;
    if (i == 123'457) y = 1000;
    if (i == 234'568) y = -1000;
    curve.Add(i, y);
  }
  const Stroke points = AllPoints(curve);
  EXPECT_LE(points.size(), 5000u);
  EXPECT_GE(points.size(), 2000u);
  EXPECT_EQ(points.front(), (CurvePoint{0, 0}));
  EXPECT_EQ(points.back().x, kPoints - 1);
  EXPECT_NE(std::find(points.begin(), points.end(), CurvePoint{123'457, 1000}), points.end());
  EXPECT_NE(std::find(points.begin(), points.end(), CurvePoint{234'568, -1000}), points.end());
  EXPECT_TRUE(std::is_sorted(points.begin(), points.end(),
                             [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; }));
}

TEST(ThinnedCurve, KeepsGapsWhenItBecomesLong) {
  ThinnedCurve curve;
  for (int i = 0; i < 50'000; ++i) {
    if (i == 20'000) curve.Break();
    curve.Add(i, 0);
  }
  const auto strokes = curve.Strokes();
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0].back().x, 19'999);
  EXPECT_EQ(strokes[1].front().x, 20'000);
}

TEST(ThinnedCurve, BreaksWhereAValueCannotBeDrawn) {
  ThinnedCurve curve;
  EXPECT_TRUE(curve.Add(0, 0));
  EXPECT_FALSE(curve.Add(1, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(curve.Add(std::numeric_limits<double>::infinity(), 1));
  EXPECT_FALSE(curve.Add(2, 1e300));
  EXPECT_TRUE(curve.Add(3, 0));
  EXPECT_EQ(curve.Strokes(), (std::vector<Stroke>{{{0, 0}}, {{3, 0}}}));
}

TEST(ThinnedCurve, StaysSmallWhenItIsNothingButGaps) {
  ThinnedCurve curve;
  for (int i = 0; i < 20'000; ++i) {
    curve.Break();
    curve.Add(i, i);
  }
  EXPECT_LE(curve.num_runs(), ThinnedCurve::kMaxRuns);
  EXPECT_EQ(AllPoints(curve).back(), (CurvePoint{19'999, 19'999}));
}

RC_GTEST_PROP(ThinnedCurve, NeverLosesAnExtremeHoweverFewRunsItMayHave, ()) {
  const auto points = *rc::gen::nonEmpty<std::vector<std::tuple<int16_t, int16_t, bool>>>();
  ThinnedCurve curve;
  const auto limit = *rc::gen::inRange<size_t>(2, 20);
  const bool limit_first = *rc::gen::arbitrary<bool>();
  if (limit_first) curve.LimitTo(limit);
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
  for (const auto& [x, y, breaks] : points) {
    if (breaks) curve.Break();
    curve.Add(x, y);
    left = std::min<double>(left, x);
    right = std::max<double>(right, x);
    low = std::min<double>(low, y);
    high = std::max<double>(high, y);
  }
  if (!limit_first) curve.LimitTo(limit);
  RC_ASSERT(curve.num_runs() <= limit);
  const Stroke kept = AllPoints(curve);
  const auto by_x = [](const CurvePoint& a, const CurvePoint& b) { return a.x < b.x; };
  const auto by_y = [](const CurvePoint& a, const CurvePoint& b) { return a.y < b.y; };
  RC_ASSERT(std::min_element(kept.begin(), kept.end(), by_x)->x == left);
  RC_ASSERT(std::max_element(kept.begin(), kept.end(), by_x)->x == right);
  RC_ASSERT(std::min_element(kept.begin(), kept.end(), by_y)->y == low);
  RC_ASSERT(std::max_element(kept.begin(), kept.end(), by_y)->y == high);
}

}  // namespace shoal::plot_curve_test
