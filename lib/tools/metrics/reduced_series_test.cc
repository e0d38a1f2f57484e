#include "lib/tools/metrics/reduced_series.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shoal::reduced_series_test {

constexpr Reduction kAllReductions[] = {Reduction::kMin, Reduction::kMax, Reduction::kMean,
                                        Reduction::kPercentile, Reduction::kLast};

double Reduced(Reduction reduction, const std::vector<double>& values, double percentile = 95) {
  ReducedSeries series(reduction, percentile);
  for (const double value : values) series.Add(value);
  return series.Value();
}

TEST(ReducedSeries, HasNoValueWithoutAny) {
  for (const Reduction each : kAllReductions) EXPECT_TRUE(std::isnan(Reduced(each, {})));
}

TEST(ReducedSeries, IsTheOnlyValueWhereThereIsOne) {
  for (const Reduction each : kAllReductions) EXPECT_EQ(Reduced(each, {-2.5}), -2.5);
}

TEST(ReducedSeries, ReducesInEachWay) {
  const std::vector<double> values = {3, -1, 10, 4};
  EXPECT_EQ(Reduced(Reduction::kMin, values), -1);
  EXPECT_EQ(Reduced(Reduction::kMax, values), 10);
  EXPECT_EQ(Reduced(Reduction::kMean, values), 4);
  EXPECT_EQ(Reduced(Reduction::kLast, values), 4);
  EXPECT_EQ(Reduced(Reduction::kPercentile, values, 50), 3);
  EXPECT_EQ(Reduced(Reduction::kPercentile, values, 50.1), 4);
  EXPECT_EQ(Reduced(Reduction::kPercentile, values, 75), 4);
  EXPECT_EQ(Reduced(Reduction::kPercentile, values, 100), 10);
  EXPECT_EQ(Reduced(Reduction::kPercentile, values, 1e-9), -1);
}

TEST(ReducedSeries, LeavesOutWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Reduction each : kAllReductions) {
    EXPECT_TRUE(std::isnan(Reduced(each, {kNan, kInfinity, -kInfinity})));
    EXPECT_EQ(Reduced(each, {kNan, 7, kInfinity, kNan}), 7);
  }
  EXPECT_EQ(Reduced(Reduction::kMean, {1, kNan, 3}), 2) << "NaN counts as no value";
}

RC_GTEST_PROP(ReducedSeries, PercentileIsTheSmallestValueThatEnoughDoNotExceed, ()) {
  const auto values = *rc::gen::nonEmpty(rc::gen::container<std::vector<double>>(
      rc::gen::map(rc::gen::inRange(-50, 50), [](int i) { return static_cast<double>(i); })));
  const int percentile = *rc::gen::inRange(1, 101);
  const double found = Reduced(Reduction::kPercentile, values, percentile);
  const auto at_most = [&](double limit) {
    return std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit; });
  };
  const auto wanted = static_cast<int64_t>(values.size()) * percentile;
  RC_ASSERT(at_most(found) * 100 >= wanted);
  for (const double value : values) {
    if (value < found) RC_ASSERT(at_most(value) * 100 < wanted);
  }
}

}  // namespace shoal::reduced_series_test
