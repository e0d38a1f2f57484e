#include "lib/ocean/current_zones.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "lib/ocean/distribution_testing.h"

namespace shoal {
namespace {

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
  EXPECT_EQ(FindOceanPreset("choppy"), nullptr);
}

TEST(CurrentZones, OfDirectionsCoverTheCircleOnce) {
  double covered_rad = 0;
  for (const Zone& zone : CurrentDirectionZones()) {
    if (zone.name != "any") covered_rad += zone.range.high - zone.range.low;
  }
  EXPECT_NEAR(covered_rad, 2 * kPi, 1e-12);
}

TEST(OceanPresets, AreMadeOfZones) {
  const auto expect_zone = [](const Range& range, std::span<const Zone> zones, const char* name) {
    EXPECT_EQ(range.low, FindZone(zones, name)->range.low) << name;
    EXPECT_EQ(range.high, FindZone(zones, name)->range.high) << name;
  };
  const OceanPreset& calm = *FindOceanPreset("calm");
  expect_zone(calm.current.speed_mps, CurrentSpeedZones(), "typical");
  expect_zone(calm.current.speed_half_period_s, CurrentHalfPeriodZones(), "calm");
  expect_zone(calm.current.direction_rad, CurrentDirectionZones(), "northeast");
  EXPECT_EQ(calm.floor_z_m, 200);
  const OceanPreset& stormy = *FindOceanPreset("stormy");
  expect_zone(stormy.current.speed_mps, CurrentSpeedZones(), "fast");
  expect_zone(stormy.current.speed_deviation_mps, CurrentSpeedDeviationZones(), "unsteady");
  expect_zone(stormy.current.direction_deviation_rad, CurrentDirectionDeviationZones(), "unsteady");
  expect_zone(stormy.current.direction_half_period_s, CurrentHalfPeriodZones(), "choppy");
}

TEST(DrawnCurrent, LiesInItsRanges) {
  for (const OceanPreset& preset : OceanPresets()) {
    for (uint64_t seed = 0; seed < 50; ++seed) {
      const CurrentParams params = DrawCurrent(preset.current, StreamKey(seed, "current"));
      EXPECT_TRUE(IsCurrent(params)) << preset.name;
      EXPECT_GE(params.speed_mps.mean, preset.current.speed_mps.low) << preset.name;
      EXPECT_LE(params.speed_mps.mean, preset.current.speed_mps.high) << preset.name;
      EXPECT_GE(params.speed_mps.half_period_s, preset.current.speed_half_period_s.low);
      EXPECT_LE(params.direction_rad.deviation, preset.current.direction_deviation_rad.high);
    }
  }
}

TEST(DrawnCurrent, OfADeadSeaIsStill) {
  const CurrentParams params =
      DrawCurrent(FindOceanPreset("dead")->current, StreamKey(4, "current"));
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

}  // namespace
}  // namespace shoal
