#include "lib/sea/ocean/plume.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/base/geometry/angles.h"
#include "tests/golden/read_golden.h"

namespace shoal::plume_test {

TEST(Plume, IsThatOfMunet) {
  for (const GoldenRow& row : ReadGoldenCsv("munet/pollution_plume.csv")) {
    const Plume plume{.source_m = {Number(row, "xs"), Number(row, "ys"), Number(row, "zs")},
                      .rate_gps = Number(row, "Q"),
                      .current_mps = Number(row, "u_in"),
                      .direction_rad = Number(row, "dir"),
                      .floor_z_m = Number(row, "ocean_depth")};
    const double golden = Number(row, "concentration");
    // Less than 1e-100 is e to the power of -230 or less, which magnifies rounding that much.
    const double tolerance = golden > 1e-100 ? 1e-12 : 1e-11;
    EXPECT_NEAR(Concentration(plume, {Number(row, "x"), Number(row, "y"), Number(row, "z")}),
                golden, tolerance * golden);
  }
}

TEST(Plume, IsStrongestAtItsAxisAndFadesAlongIt) {
  const Plume plume;
  EXPECT_GT(Concentration(plume, {50, 0, 30}), Concentration(plume, {50, 5, 30}));
  EXPECT_GT(Concentration(plume, {50, 0, 30}), Concentration(plume, {100, 0, 30}));
  EXPECT_DOUBLE_EQ(Concentration(plume, {50, 5, 30}), Concentration(plume, {50, -5, 30}));
}

TEST(Plume, IsNowhereUpTheCurrentOrOutsideTheWater) {
  const Plume plume;
  EXPECT_EQ(Concentration(plume, {-1, 0, 30}), 0);
  EXPECT_EQ(Concentration(plume, {50, 0, -0.1}), 0);
  EXPECT_EQ(Concentration(plume, {50, 0, 125.1}), 0);
}

// What leaks must come by, at any distance: the flux through a plane across the current is the
// rate, as the surface gives back what would leave through it, and the floor is too deep to matter.
TEST(Plume, CarriesWhatItsSourceGives) {
  Plume plume;
  plume.floor_z_m = 300;
  for (const double x : {20.0, 100.0, 400.0}) {
    double flux_gps = 0;
    const double step_y = 1.36 * std::pow(x, 0.82) / 8;
    const double step_z = 0.275 * std::pow(x, 0.69) / 8;
    for (double y = -60 * step_y; y < 60 * step_y; y += step_y) {
      for (double z = step_z / 2; z < 300; z += step_z) {
        flux_gps += Concentration(plume, {x, y, z}) * plume.current_mps * step_y * step_z;
      }
    }
    EXPECT_NEAR(flux_gps, plume.rate_gps, 1e-3 * plume.rate_gps) << "at " << x << " m";
  }
}

TEST(Plume, InStillWaterIsThatOfASlowCurrent) {
  Plume still;
  still.current_mps = 0;
  Plume slow;
  slow.current_mps = kMinPlumeCurrent_mps;
  EXPECT_EQ(Concentration(still, {10, 1, 30}), Concentration(slow, {10, 1, 30}));
}

RC_GTEST_PROP(Plume, IsFiniteAndNotNegativeEverywhere, ()) {
  const auto coordinate = [] {
    return *rc::gen::inRange(-1000, 1000) * std::pow(10, *rc::gen::inRange(-300, 300));
  };
  Plume plume;
  plume.direction_rad = *rc::gen::inRange(-1000, 1000) / 100.0;
  plume.current_mps = *rc::gen::inRange(0, 500) / 10.0;
  plume.rate_gps = 1e9;
  const double concentration = Concentration(plume, {coordinate(), coordinate(), coordinate()});
  RC_ASSERT(std::isfinite(concentration));
  RC_ASSERT(concentration >= 0);
}

TEST(PlumeParameters, ThatAreInvalidAreFound) {
  EXPECT_TRUE(IsPlume({}));
  for (const double nonsense :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Plume plume;
    plume.rate_gps = nonsense;
    EXPECT_FALSE(IsPlume(plume));
    plume = {};
    plume.source_m.z() = nonsense;
    EXPECT_FALSE(IsPlume(plume));
    plume = {};
    plume.direction_rad = nonsense;
    EXPECT_FALSE(IsPlume(plume));
  }
}

}  // namespace shoal::plume_test
