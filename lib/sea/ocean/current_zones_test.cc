#include "lib/sea/ocean/current_zones.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "lib/sea/ocean/distribution_testing.h"

namespace shoal::current_zones_test {

TEST(CurrentZones, HaveTheNumbersOfMunet) {
  EXPECT_EQ(FindZone(CurrentSpeedZones(), "typical")->range.low, 0.05);
  EXPECT_EQ(FindZone(CurrentSpeedZones(), "swift")->range.high, 1.8);
  EXPECT_EQ(FindZone(CurrentSpeedDeviationZones(), "unsteady")->range.high, 1.5);
  EXPECT_EQ(FindZone(CurrentHalfPeriodZones(), "smooth")->range.low, 90);
  EXPECT_EQ(FindZone(CurrentHalfPeriodZones(), "calm")->range.high, 600);
  EXPECT_EQ(FindZone(CurrentDirectionDeviationZones(), "varied")->range.low, kPi / 18);
}

TEST(CurrentZones, OfNoNameAreNone) {
  EXPECT_EQ(FindZone(CurrentSpeedZones(), ""), nullptr);
  EXPECT_EQ(FindZone(CurrentSpeedZones(), "Typical"), nullptr);
  EXPECT_EQ(FindZone(CurrentSpeedZones(), "north"), nullptr);
}

TEST(CurrentZones, OfDirectionsCoverTheCircleOnce) {
  double covered_rad = 0;
  for (const Zone& zone : CurrentDirectionZones()) {
    if (zone.name != "any") covered_rad += zone.range.high - zone.range.low;
  }
  EXPECT_NEAR(covered_rad, 2 * kPi, 1e-12);
}

CurrentRanges StormyRanges() {
  return {.speed_mps = FindZone(CurrentSpeedZones(), "fast")->range,
          .speed_deviation_mps = FindZone(CurrentSpeedDeviationZones(), "unsteady")->range,
          .speed_half_period_s = FindZone(CurrentHalfPeriodZones(), "choppy")->range,
          .direction_rad = FindZone(CurrentDirectionZones(), "any")->range,
          .direction_deviation_rad = FindZone(CurrentDirectionDeviationZones(), "unsteady")->range,
          .direction_half_period_s = FindZone(CurrentHalfPeriodZones(), "choppy")->range};
}

CurrentRanges DeadRanges() {
  const DrawRange still = FindZone(CurrentSpeedZones(), "dead")->range;
  return {.speed_mps = still, .speed_deviation_mps = still, .direction_deviation_rad = still};
}

TEST(DrawnCurrent, LiesInItsRanges) {
  for (const CurrentRanges& ranges : {CurrentRanges(), DeadRanges(), StormyRanges()}) {
    for (uint64_t seed = 0; seed < 50; ++seed) {
      const CurrentParams params = DrawCurrent(ranges, StreamKey(seed, "current"));
      EXPECT_TRUE(IsCurrent(params));
      EXPECT_GE(params.speed_mps.mean, ranges.speed_mps.low);
      EXPECT_LE(params.speed_mps.mean, ranges.speed_mps.high);
      EXPECT_GE(params.speed_mps.half_period_s, ranges.speed_half_period_s.low);
      EXPECT_LE(params.direction_rad.deviation, ranges.direction_deviation_rad.high);
    }
  }
}

TEST(DrawnCurrent, OfADeadSeaIsStill) {
  const CurrentParams params = DrawCurrent(DeadRanges(), StreamKey(4, "current"));
  EXPECT_EQ(Velocity(Current(params, StreamKey(4, "current")).At(123)), Eigen::Vector2d(0, 0));
}

TEST(DrawnCurrent, TowardTheWestMayPointToEitherSideOfIt) {
  CurrentRanges ranges;
  ranges.direction_rad = FindZone(CurrentDirectionZones(), "west")->range;
  std::set<bool> sides;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const double psi = DrawCurrent(ranges, StreamKey(seed, "current")).direction_rad.mean;
    EXPECT_GE(std::abs(psi), 7 * kPi / 8 - 1e-12);
    EXPECT_LE(std::abs(psi), kPi);
    sides.insert(psi > 0);
  }
  EXPECT_EQ(sides.size(), 2U);
}

TEST(DrawnCurrent, KeepsItsOtherNumbersWhenOneRangeChanges) {
  CurrentRanges ranges;
  const CurrentParams before = DrawCurrent(ranges, StreamKey(5, "current"));
  ranges.speed_mps = {1, 1};
  const CurrentParams after = DrawCurrent(ranges, StreamKey(5, "current"));
  EXPECT_EQ(after.speed_mps.mean, 1);
  EXPECT_EQ(after.speed_mps.deviation, before.speed_mps.deviation);
  EXPECT_EQ(after.direction_rad.mean, before.direction_rad.mean);
}

TEST(DrawnCurrent, IsUniformInItsRange) {
  std::vector<double> speeds_mps;
  for (uint64_t seed = 0; seed < 2000; ++seed) {
    speeds_mps.push_back(DrawCurrent({}, StreamKey(seed, "current")).speed_mps.mean);
  }
  // 99.9 % of good generators pass.
  EXPECT_LT(KolmogorovSmirnov(speeds_mps, [](double speed) { return (speed - 0.05) / 0.45; }),
            kKolmogorov999);
}

}  // namespace shoal::current_zones_test
