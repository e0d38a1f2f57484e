#include "lib/helm/encounters/encounter_watch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/helm/encounters/encounter_score.h"
#include "lib/helm/encounters/encounter_testing.h"

namespace shoal::encounter_watch_test {

/// Own ship goes North from the origin at 3 m/s; the target comes toward it, 300 m ahead and
/// `aside_m` to the East.
std::vector<PlannedVessel> HeadOn(double aside_m) {
  return {{.motion = {{0, 0}, 0, 3}}, {.motion = {{aside_m, 300}, 180, 3}}};
}

TEST(EncounterWatch, BeginsWithinTheEntryRangeAndEndsWhereTheyHaveOpened) {
  const auto encounters = EncountersOf(HeadOn(20), 100);
  ASSERT_EQ(encounters.size(), 1U);
  const Encounter& encounter = encounters[0];
  EXPECT_NEAR(encounter.begin_s, (300 - std::sqrt(150. * 150 - 400)) / 6, 0.11);
  EXPECT_NEAR(encounter.closest_m, 20, 1e-9);
  EXPECT_NEAR(encounter.closest_s, 50, 1e-6);
  EXPECT_TRUE(encounter.is_over);
  EXPECT_NEAR(encounter.end_s, 60, 0.11);  // Ten seconds of opening, at 63 m.
  EXPECT_FALSE(encounter.has_touched);
  EXPECT_EQ(encounter.sides[0].role, EncounterRole::kHeadOn);
  EXPECT_EQ(encounter.sides[1].role, EncounterRole::kHeadOn);
}

TEST(EncounterWatch, BeginsNothingForVesselsThatPassFarEnoughApart) {
  EXPECT_EQ(EncountersOf(HeadOn(39.9), 100).size(), 1U);
  EXPECT_EQ(EncountersOf(HeadOn(40.1), 100).size(), 0U);
}

TEST(EncounterWatch, BeginsNothingForOneThatDoesNotMakeWay) {
  auto vessels = HeadOn(0);
  vessels[1].motion.speed_mps = 0.1;
  EXPECT_EQ(EncountersOf(vessels, 200).size(), 0U);
}

TEST(EncounterWatch, BeginsNothingForVesselsInOtherDepths) {
  EncounterWatch watch;
  for (const double depth_m : {10.0, 2.0}) {
    const std::vector<VesselSample> samples = {
        {.is_seen = true, .motion = {{0, 0}, 0, 3}},
        {.is_seen = true, .motion = {{0, 100}, 180, 3}, .depth_m = depth_m}};
    watch.Look(10 - depth_m, samples);
    EXPECT_EQ(watch.Encounters().size(), depth_m > 5 ? 0U : 1U);
  }
}

TEST(EncounterWatch, FindsTheClosestApproachBetweenTwoLooks) {
  const auto encounters = EncountersOf(HeadOn(7), 100, {}, 1.7);
  ASSERT_EQ(encounters.size(), 1U);
  EXPECT_NEAR(encounters[0].closest_m, 7, 1e-9);
  EXPECT_NEAR(encounters[0].closest_s, 50, 1e-6);
  EXPECT_NEAR(encounters[0].sides[0].beta_deg, 90, 1e-6);
}

TEST(EncounterWatch, SeesThatVesselsTouch) {
  EXPECT_TRUE(EncountersOf(HeadOn(2.9), 100).at(0).has_touched);
  EXPECT_FALSE(EncountersOf(HeadOn(3.1), 100).at(0).has_touched);
}

TEST(EncounterWatch, EndsWithAVesselThatIsSeenNoMore) {
  EncounterWatch watch;
  std::vector<VesselSample> samples = {{.is_seen = true, .motion = {{0, 0}, 0, 3}},
                                       {.is_seen = true, .motion = {{0, 100}, 180, 3}}};
  watch.Look(0, samples);
  ASSERT_EQ(watch.Encounters().size(), 1U);
  EXPECT_FALSE(watch.Encounters()[0].is_over);
  samples[1].is_seen = false;
  watch.Look(1, samples);
  EXPECT_TRUE(watch.Encounters().at(0).is_over);
}

TEST(EncounterWatch, IgnoresALookOutOfOrder) {
  EncounterWatch watch;
  const std::vector<VesselSample> samples = {{.is_seen = true, .motion = {{0, 0}, 0, 3}},
                                             {.is_seen = true, .motion = {{0, 100}, 180, 3}}};
  watch.Look(5, {});
  watch.Look(5, samples);
  watch.Look(4, samples);
  EXPECT_TRUE(watch.Encounters().empty());
}

TEST(EncounterWatch, EndsWhereAVesselIsPutElsewhere) {
  EncounterWatch watch;
  std::vector<VesselSample> samples = {{.is_seen = true, .motion = {{0, 0}, 0, 3}},
                                       {.is_seen = true, .motion = {{0, 100}, 180, 3}}};
  watch.Look(0, samples);
  samples[1].motion.position_m = {0, -100};  // Past the other, through its place.
  watch.Look(0.1, samples);
  ASSERT_EQ(watch.Encounters().size(), 1U);
  EXPECT_TRUE(watch.Encounters()[0].is_over);
  EXPECT_EQ(watch.Encounters()[0].closest_m, 100);
}

TEST(EncounterWatch, NotesWhenAndWhereToAVesselAltered) {
  auto vessels = HeadOn(0);
  vessels[0].turns = {{.at_s = 30, .course_change_deg = 3}, {.at_s = 35, .course_change_deg = 20}};
  vessels[1].turns = {{.at_s = 32, .speed_factor = 0.5}};
  const auto encounters = EncountersOf(vessels, 120);
  ASSERT_EQ(encounters.size(), 1U);
  const Conduct& first = encounters[0].sides[0].conduct;
  EXPECT_NEAR(first.first_alteration_s.value_or(0), 35.1, 0.06);
  EXPECT_EQ(first.altered_to, 1);
  EXPECT_NEAR(first.largest_course_change_deg, 23, 1e-9);
  const Conduct& second = encounters[0].sides[1].conduct;
  EXPECT_NEAR(second.first_alteration_s.value_or(0), 32.1, 0.06);
  EXPECT_EQ(second.altered_to, 0);
  EXPECT_NEAR(second.largest_speed_change_share, -0.5, 1e-9);
}

TEST(EncounterWatch, LeavesOutWhatAVesselDoesAfterTheClosestApproach) {
  auto vessels = HeadOn(20);
  vessels[0].turns = {{.at_s = 52, .course_change_deg = 40}};
  const auto encounters = EncountersOf(vessels, 100);
  EXPECT_FALSE(encounters.at(0).sides[0].conduct.first_alteration_s);
  EXPECT_EQ(encounters.at(0).sides[0].conduct.largest_course_change_deg, 0);
}

/// Own ship goes North at 3 m/s; the target comes from starboard and would pass `ahead_m` ahead.
std::vector<PlannedVessel> FromStarboard(double ahead_m) {
  return {{.motion = {{0, -200}, 0, 3}}, {.motion = {{200, ahead_m}, 270, 3}}};
}

TEST(EncounterWatch, NotesWhichOfTwoCrossesAheadOfTheOther) {
  const auto behind = EncountersOf(FromStarboard(30), 120);
  ASSERT_EQ(behind.size(), 1U);
  EXPECT_FALSE(behind[0].sides[0].crossed_ahead_m);
  EXPECT_TRUE(behind[0].sides[0].crossed_astern);
  ASSERT_TRUE(behind[0].sides[1].crossed_ahead_m);
  EXPECT_NEAR(*behind[0].sides[1].crossed_ahead_m, 30, 0.5);
  EXPECT_EQ(PassedHow(behind[0], 0), "astern");
  EXPECT_EQ(PassedHow(behind[0], 1), "ahead");

  const auto ahead = EncountersOf(FromStarboard(-30), 120);
  EXPECT_TRUE(ahead.at(0).sides[0].crossed_ahead_m);
  EXPECT_FALSE(ahead.at(0).sides[1].crossed_ahead_m);
}

TEST(EncounterWatch, NotesOnWhichSideOneOvertakesTheOther) {
  std::vector<PlannedVessel> vessels = {{.motion = {{0, -120}, 0, 3}}, {.motion = {{0, 0}, 0, 1}}};
  vessels[0].turns = {{.at_s = 5, .course_change_deg = 15}, {.at_s = 50, .course_change_deg = -15}};
  const auto encounters = EncountersOf(vessels, 120);
  ASSERT_EQ(encounters.size(), 1U);
  EXPECT_EQ(encounters[0].sides[0].role, EncounterRole::kOvertaking);
  EXPECT_EQ(PassedHow(encounters[0], 0), "on its starboard side");
  EXPECT_EQ(PassedHow(encounters[0], 1), "on its port side");
}

TEST(EncounterWatch, NotesInExtremisAndWhatTheVesselThatStandsOnDoesThen) {
  auto vessels = FromStarboard(0);
  vessels[1].turns = {{.at_s = 65, .course_change_deg = 60}};
  const auto encounters = EncountersOf(vessels, 120);
  const EncounterSide& side = encounters.at(0).sides[1];
  ASSERT_EQ(side.role, EncounterRole::kStandOn);
  // 37.5 m apart where each has 26.5 m to go.
  EXPECT_NEAR(side.conduct.in_extremis_s.value_or(0), (200 - 37.5 / std::sqrt(2)) / 3, 0.11);
  EXPECT_TRUE(side.conduct.acted_in_extremis);
  EXPECT_FALSE(side.conduct.turned_to_port_in_extremis);
  EXPECT_EQ(side.conduct.held_course_change_deg, 0);
  EXPECT_FALSE(encounters[0].sides[0].conduct.in_extremis_s) << "it gives way";
}

TEST(EncounterWatch, ExcusesAVesselThatHasToKeepClearOfAThird) {
  // The second stands on toward the first, and gives way to the third, on its own starboard side.
  auto vessels = FromStarboard(0);
  vessels.push_back({.motion = {{0, 205}, 180, 3}});
  vessels[1].turns = {{.at_s = 45, .course_change_deg = 40}};
  for (const Encounter& encounter : EncountersOf(vessels, 120)) {
    for (const EncounterSide& side : encounter.sides) {
      if (side.vessel != 1 || side.role != EncounterRole::kStandOn) continue;
      EXPECT_TRUE(side.excused_s);
      EXPECT_EQ(side.conduct.held_course_change_deg, 0);
    }
  }
}

TEST(EncounterWatch, ExcusesAVesselThatIsInExtremisTowardAThird) {
  // The second stands on toward the first and toward the third, which comes 60 m behind; it turns
  // to port when the first alone can no longer avoid it.
  auto vessels = FromStarboard(0);
  vessels.push_back(vessels[0]);
  vessels[2].motion.position_m -= 60 * UnitVector(DegToRad(vessels[0].motion.heading_deg));
  vessels[1].turns = {{.at_s = 60, .course_change_deg = -40}};
  int num_toward_third = 0;
  for (const Encounter& encounter : EncountersOf(vessels, 120)) {
    if (encounter.sides[0].vessel != 1 && encounter.sides[1].vessel != 1) continue;
    const int own = encounter.sides[0].vessel == 1 ? 0 : 1;
    const EncounterSide& side = encounter.sides[own];
    ASSERT_EQ(side.role, EncounterRole::kStandOn);
    if (encounter.sides[1 - own].vessel == 0) {
      EXPECT_TRUE(side.conduct.in_extremis_s);
      EXPECT_FALSE(side.excused_s) << "its own extremis is no third vessel";
      EXPECT_TRUE(side.conduct.turned_to_port_while_standing_on);
    } else {
      ++num_toward_third;
      EXPECT_TRUE(side.excused_s);
      EXPECT_FALSE(side.conduct.turned_to_port_while_standing_on);
    }
  }
  EXPECT_EQ(num_toward_third, 1);
}

TEST(EncounterWatch, StaysOneEncounterWhileAVesselTurnsAwayAndComesBack) {
  auto vessels = FromStarboard(0);
  vessels[0].turns = {{.at_s = 35, .course_change_deg = 90},
                      {.at_s = 42, .course_change_deg = -90}};
  EXPECT_EQ(EncountersOf(vessels, 150).size(), 1U);
}

RC_GTEST_PROP(EncounterWatch, FindsTheSameWhereverTheWorldIsTurned, ()) {
  const auto angle_deg = static_cast<double>(*rc::gen::inRange(1, 360));
  const auto ahead_m = static_cast<double>(*rc::gen::inRange(-35, 35));
  auto vessels = FromStarboard(ahead_m);
  const auto plain = EncountersOf(vessels, 120);
  for (PlannedVessel& vessel : vessels) {
    const double range_m = vessel.motion.position_m.norm();
    const double bearing_rad = HeadingOf(vessel.motion.position_m) + DegToRad(angle_deg);
    vessel.motion.position_m = UnitVector(bearing_rad) * range_m;
    vessel.motion.heading_deg = Wrap360(vessel.motion.heading_deg + angle_deg);
  }
  const auto turned = EncountersOf(vessels, 120);
  RC_ASSERT(turned.size() == 1U);
  RC_ASSERT(plain.size() == 1U);
  RC_ASSERT(std::abs(turned[0].closest_m - plain[0].closest_m) < 1e-6);
  for (size_t i = 0; i < 2; ++i) {
    RC_ASSERT(turned[0].sides[i].role == plain[0].sides[i].role);
    RC_ASSERT(std::abs(ScoreOf(turned[0], i, {}).overall - ScoreOf(plain[0], i, {}).overall) <
              1e-3);
  }
}

TEST(EncounterWatch, NotesATurnToPortOfAVesselThatStandsOn) {
  // The target crosses from port.
  const PlannedVessel target = {.motion = {{-100, 100}, 90, 3}};
  const auto turned = [&](double at_s, double course_change_deg) {
    const auto encounters = EncountersOf(
        {{.motion = {{0, 0}, 0, 3}, .turns = {{at_s, course_change_deg, 1}}}, target}, 60);
    return encounters.at(0).sides[0].conduct.turned_to_port_while_standing_on;
  };
  EXPECT_TRUE(turned(10, -12));
  EXPECT_FALSE(turned(10, -8));
  EXPECT_FALSE(turned(10, 30));
}

TEST(EncounterWatch, CountsNoTurnToPortThatBeginsWhereThereIsNoRiskOfCollision) {
  // The vessel passes 28 m ahead of the target, in 40 s, and goes back to its way.
  const PlannedVessel target = {.motion = {{-140, 100}, 90, 3}};
  const auto turned = [&](double at_s) {
    const auto encounters =
        EncountersOf({{.motion = {{0, 0}, 0, 3}, .turns = {{at_s, -30, 1}}}, target}, 80);
    return encounters.at(0).sides[0].conduct.turned_to_port_while_standing_on;
  };
  EXPECT_TRUE(turned(30));
  EXPECT_FALSE(turned(38.5)) << "it passes in less than 3 s";
}

TEST(EncounterWatch, CountsNoTurnToPortWhereTheTwoPassPortToPort) {
  // Each has the other to port: neither has to keep out of the way, so none has to stand on.
  const auto encounters = EncountersOf(
      {{.motion = {{0, 0}, 0, 3}, .turns = {{5, -12, 1}}}, {.motion = {{-30, 100}, 180, 3}}}, 60);
  ASSERT_EQ(encounters.at(0).sides[0].role, EncounterRole::kStandOn);
  ASSERT_EQ(encounters[0].sides[1].role, EncounterRole::kStandOn);
  EXPECT_FALSE(encounters[0].sides[0].conduct.turned_to_port_while_standing_on);
}

TEST(EncounterWatch, CountsThatAVesselFleesThatIsOvertaken) {
  // From dead astern, too close to clear it alone: in extremis any change but this is allowed.
  const auto encounters = EncountersOf(
      {{.motion = {{0, 0}, 0, 1}, .turns = {{30, 0, 2.4}}}, {.motion = {{2, -60}, 0, 2.4}}}, 80);
  ASSERT_EQ(encounters.at(0).sides[0].role, EncounterRole::kOvertaken);
  ASSERT_TRUE(encounters[0].sides[0].conduct.in_extremis_s.has_value());
  EXPECT_EQ(ScoreOf(encounters[0], 0, {}).rule_17, 0);
}

}  // namespace shoal::encounter_watch_test
