#include "lib/helm/encounters/scenario.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "lib/helm/encounters/encounter_testing.h"

namespace shoal::scenario_test {

const ScenarioScale kScale;

TEST(ImazuCases, HaveAllVesselsMeetAtTheOriginAfterTwoMinutes) {
  for (int number = 1; number <= kNumImazuCases; ++number) {
    const EncounterScenario scenario = ImazuCase(number, kScale);
    EXPECT_NEAR(scenario.meeting_s, 120.0096, 1e-9);
    for (const ScenarioVessel& vessel : scenario.vessels) {
      const VesselMotion& start = vessel.start;
      const Eigen::Vector2d met_m = start.position_m + UnitVector(DegToRad(start.heading_deg)) *
                                                           (start.speed_mps * scenario.meeting_s);
      EXPECT_LT(met_m.norm(), 1e-9) << scenario.name << " " << vessel.name;
      EXPECT_LT((vessel.goal_m + start.position_m).norm(), 1e-9);
    }
  }
}

TEST(ImazuCases, StandWhereThePaperPrintsThem) {
  // Case 6, course -10: (-5.909, 1.042) NM, X ahead and Y to starboard.
  const double nautical_mile_m = MeetingRange_m(kScale) / 6;
  const Eigen::Vector2d target_m = ImazuCase(6, kScale).vessels.at(1).start.position_m;
  EXPECT_NEAR(target_m.y() / nautical_mile_m, -5.909, 0.0005);
  EXPECT_NEAR(target_m.x() / nautical_mile_m, 1.042, 0.0005);
  // Case 3: 4.2 NM ahead, 8.4 knots where own ship has 12.
  const ScenarioVessel slow = ImazuCase(3, kScale).vessels.at(1);
  EXPECT_NEAR(slow.start.position_m.y() / nautical_mile_m, -4.2, 1e-9);
  EXPECT_NEAR(slow.start.speed_mps / kScale.speed_mps, 8.4 / 12, 1e-12);
}

TEST(ImazuCases, AreTwentyTwoWithOneToThreeTargets) {
  std::vector<size_t> counts(5);
  for (int number = 1; number <= kNumImazuCases; ++number) {
    ++counts.at(ImazuCase(number, kScale).vessels.size());
  }
  EXPECT_EQ(counts, (std::vector<size_t>{0, 0, 4, 7, 11}));
}

TEST(SingleTargets, HaveTheRoleThatTheyAreMadeForWhereverTheyBegin) {
  for (const std::string_view name : SingleTargetNames()) {
    const auto scenario = SingleTarget(name, kScale);
    ASSERT_TRUE(scenario) << name;
    EXPECT_EQ(scenario->name, name);
    const auto encounters = EncountersOf(PlanOf(*scenario), 2 * scenario->meeting_s, {}, 0.5);
    if (scenario->role == EncounterRole::kNone) {
      EXPECT_TRUE(encounters.empty()) << name;
      continue;
    }
    ASSERT_EQ(encounters.size(), 1U) << name;
    EXPECT_EQ(Name(encounters[0].sides[0].role), Name(*scenario->role)) << name;
    EXPECT_TRUE(encounters[0].has_touched) << name << ": " << encounters[0].closest_m;
  }
}

TEST(SingleTargets, HaveAMirrorImageEach) {
  const std::set<std::string_view> names(SingleTargetNames().begin(), SingleTargetNames().end());
  int num_pairs = 0;
  for (const std::string_view name : names) {
    std::string other(name);
    const size_t port = other.find("port");
    if (port == other.npos) continue;
    ++num_pairs;
    other.replace(port, 4, "starboard");
    ASSERT_TRUE(names.contains(other)) << other;
    const auto left = SingleTarget(name, kScale)->vessels.at(1);
    const auto right = SingleTarget(other, kScale)->vessels.at(1);
    EXPECT_NEAR(left.start.position_m.x(), -right.start.position_m.x(), 1e-6) << name;
    EXPECT_NEAR(left.start.position_m.y(), right.start.position_m.y(), 1e-6) << name;
  }
  EXPECT_GE(num_pairs, 8);
}

TEST(SingleTargets, AreOnBothSidesOfTheBoundaries) {
  const auto entry = [](std::string_view name) {
    const EncounterScenario scenario = *SingleTarget(name, kScale);
    return GeometryOf(scenario.vessels[0].start, scenario.vessels[1].start);
  };
  EXPECT_NEAR(entry("crossing_starboard_14").beta_deg, 14, 1e-6);
  EXPECT_NEAR(entry("head_on_port_10").beta_deg, 350, 1e-6);
  EXPECT_NEAR(entry("overtaking_port_117").alpha_deg, 242.5, 1e-6);
  EXPECT_NEAR(entry("faster_starboard_107").alpha_deg, 107.5, 1e-6);
  EXPECT_NEAR(entry("overtaken_starboard_117").beta_deg, 117.5, 1e-6);
  EXPECT_NEAR(entry("slower_port_107").beta_deg, 252.5, 1e-6);
}

TEST(SingleTargets, AreUnknownByOtherNames) { EXPECT_FALSE(SingleTarget("head_off", kScale)); }

TEST(RandomEncounters, StartApartAndPassACommonRegion) {
  const double range_m = MeetingRange_m(kScale);
  for (uint64_t seed = 0; seed < 300; ++seed) {
    const int num_vessels = 2 + static_cast<int>(seed % 7);
    const EncounterScenario scenario = RandomEncounter(seed, num_vessels, kScale);
    ASSERT_EQ(scenario.vessels.size(), static_cast<size_t>(num_vessels));
    for (size_t i = 0; i < scenario.vessels.size(); ++i) {
      const ScenarioVessel& vessel = scenario.vessels[i];
      const double nearest_m = ClosestApproach(
          vessel.start.position_m,
          UnitVector(DegToRad(vessel.start.heading_deg)) * vessel.start.speed_mps, 1e6);
      EXPECT_LE(nearest_m, range_m / 6 + 1e-6) << seed;
      for (size_t k = 0; k < i; ++k) {
        const ScenarioVessel& other = scenario.vessels[k];
        EXPECT_GE((vessel.start.position_m - other.start.position_m).norm(), range_m / 4) << seed;
        EXPECT_GE((vessel.goal_m - other.goal_m).norm(), range_m / 10) << seed;
      }
    }
  }
}

TEST(RandomEncounters, HaveAnEncounterEachWhereNoVesselAlters) {
  for (uint64_t seed = 0; seed < 30; ++seed) {
    const EncounterScenario scenario = RandomEncounter(seed, 2, kScale);
    const auto encounters = EncountersOf(PlanOf(scenario), 2 * scenario.meeting_s, {}, 0.5);
    ASSERT_EQ(encounters.size(), 1U) << seed;
    EXPECT_TRUE(encounters[0].has_touched) << seed;
  }
}

TEST(RandomEncounters, AreTheSameForTheSameSeedAndNoOther) {
  const auto start = [](uint64_t seed, int num_vessels) {
    return RandomEncounter(seed, num_vessels, kScale).vessels[0].start.position_m;
  };
  EXPECT_EQ(start(7, 4), start(7, 4));
  EXPECT_NE(start(7, 4), start(8, 4));
  EXPECT_NE(start(7, 4), start(7, 5));
}

TEST(Scenarios, KeepTheirShapeAtTheScaleOfShips) {
  const EncounterScenario small = ImazuCase(9, kScale);
  const EncounterScenario large = ImazuCase(9, {.length = 1, .speed_mps = 12 * 1852 / 3600.});
  EXPECT_NEAR(large.meeting_s, 1800, 1e-6);
  for (size_t i = 0; i < small.vessels.size(); ++i) {
    EXPECT_LT(
        (small.vessels[i].start.position_m / kScale.length - large.vessels[i].start.position_m)
            .norm(),
        1e-6);
  }
}

}  // namespace shoal::scenario_test
