#include "lib/vehicle/control/reference_filters.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/geometry/angles.h"
#include "tests/golden/read_golden.h"

namespace shoal::reference_filters_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(HeadingObserver, MatchesMunetsFilter) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/nav_headingFilterLOS.csv")) {
    HeadingObserver observer{.psi_d_rad = Number(row, "psi_d"), .r_d_radps = Number(row, "r_d")};
    observer.Update(Number(row, "K_f"), Number(row, "psi_ref"), Number(row, "h"));
    EXPECT_NEAR(WrapPi(observer.psi_d_rad - Number(row, "n_psi_d")), 0, 1e-12);
    EXPECT_NEAR(observer.r_d_radps, Number(row, "n_r_d"), 1e-12);
  }
}

TEST(HeadingObserver, SettlesOnTheReferenceAcrossTheSeamTheShorterWay) {
  HeadingObserver observer{.psi_d_rad = 3.0};
  observer.Update(0.5, -3.0, 0.02);
  EXPECT_GT(observer.psi_d_rad, 3.0);
  for (int i = 0; i < 2000; ++i) observer.Update(0.5, -3.0, 0.02);
  EXPECT_NEAR(observer.psi_d_rad, -3.0, 1e-6);
  EXPECT_NEAR(observer.r_d_radps, 0, 1e-6);
}

TEST(HeadingObserver, EstimatesTheRateOfASteadyTurn) {
  HeadingObserver observer;
  for (int i = 0; i < 5000; ++i) observer.Update(0.5, 0.05 * 0.02 * i, 0.02);
  const double before_rad = observer.psi_d_rad;
  observer.Update(0.5, 0.05 * 0.02 * 5000, 0.02);
  EXPECT_NEAR(WrapPi(observer.psi_d_rad - before_rad) / 0.02, 0.05, 1e-6);
}

RC_GTEST_PROP(HeadingObserver, StaysFiniteWhateverItIsGiven, ()) {
  const auto any = rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::element(1e308, -1e308));
  const auto finite = [&] {
    const double value = *any;
    return std::isfinite(value) ? value : 0;
  };
  HeadingObserver observer{.psi_d_rad = finite(), .r_d_radps = finite()};
  for (int i = 0; i < 20; ++i) observer.Update(0.5, finite(), 0.1);
  RC_ASSERT(std::isfinite(observer.psi_d_rad));
  RC_ASSERT(std::isfinite(observer.r_d_radps));
}

TEST(DepthFilter, MatchesMunetsFilterWithItsTimeConstants) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/nav_depthFilter.csv")) {
    const DepthLimits limits = {.max_z_m = Number(row, "z_max"),
                                .seabed_clearance_m = Number(row, "z_safe")};
    const double z_m = LimitDepth(Number(row, "z_wpt"), limits, Number(row, "seabed_z"));
    EXPECT_NEAR(z_m, Number(row, "z_limited"), 1e-12 * Number(row, "z_limited"));
    const bool is_per_step = std::abs(Number(row, "wn_d_z") * Number(row, "h") - 1) < 1e-9;
    const DepthFilterParams params = {.time_s = 1 / Number(row, "wn_d_z"),
                                      .settles_per_step = is_per_step};
    DepthFilter filter{.z_d_m = Number(row, "z_d")};
    EXPECT_NEAR(filter.Update(params, z_m, Number(row, "h")), Number(row, "n_z_d"),
                1e-12 * Number(row, "n_z_d"));
  }
}

TEST(DepthFilter, DoesNotDependOnTheStep) {
  DepthFilter coarse, fine;
  for (int i = 0; i < 100; ++i) coarse.Update({.time_s = 20}, 50, 0.1);
  for (int i = 0; i < 500; ++i) fine.Update({.time_s = 20}, 50, 0.02);
  EXPECT_NEAR(coarse.z_d_m, fine.z_d_m, 1e-9);
  EXPECT_NEAR(coarse.z_d_m, 50 * (1 - std::exp(-0.5)), 1e-9);
}

TEST(LimitDepth, KeepsAboveTheLimitAndTheSeabedAndBelowTheSurface) {
  const DepthLimits limits = {.max_z_m = 100, .seabed_clearance_m = 5};
  EXPECT_EQ(LimitDepth(30, limits, kInfinity), 30);
  EXPECT_EQ(LimitDepth(130, limits, kInfinity), 100);
  EXPECT_EQ(LimitDepth(30, limits, 32), 27);
  EXPECT_EQ(LimitDepth(-3, limits, 32), 0);
  EXPECT_EQ(LimitDepth(30, limits, 2), 0);
}

TEST(RampRpm, ChangesNoFasterThanItsRateAndArrives) {
  EXPECT_DOUBLE_EQ(RampRpm(0, 1200, 100, 0.1), 10);
  EXPECT_DOUBLE_EQ(RampRpm(1200, 0, 100, 0.1), 1190);
  EXPECT_DOUBLE_EQ(RampRpm(1195, 1200, 100, 0.1), 1200);
  EXPECT_DOUBLE_EQ(RampRpm(0, 1200, kInfinity, 0.1), 1200);
  EXPECT_DOUBLE_EQ(RampRpm(300, 1200, 0, 0.1), 300);
  EXPECT_TRUE(std::isfinite(RampRpm(-1e308, 1e308, kInfinity, 0.1)));
}

}  // namespace shoal::reference_filters_test
