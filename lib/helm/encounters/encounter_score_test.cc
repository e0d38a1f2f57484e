#include "lib/helm/encounters/encounter_score.h"

#include <gtest/gtest.h>

#include "lib/helm/encounters/encounter_testing.h"

namespace shoal::encounter_score_test {

const EncounterOptions kOptions;

/// An encounter of one role that went as well as can be.
Encounter Perfect(EncounterRole role) {
  Encounter encounter;
  encounter.begin_s = 10;
  encounter.end_s = 60;
  encounter.is_over = true;
  encounter.closest_m = 30;
  encounter.closest_s = 35;
  encounter.touch_m = 3;
  EncounterSide& side = encounter.sides[0];
  side.role = role;
  side.entry.time_to_cpa_s = 25;
  side.alpha_deg = 225;
  side.beta_deg = 300;
  side.conduct.first_alteration_s = 12;
  side.conduct.altered_to = 1;
  side.conduct.largest_course_change_deg = 40;
  if (role == EncounterRole::kStandOn || role == EncounterRole::kOvertaken) side.conduct = {};
  return encounter;
}

constexpr EncounterRole kRoles[] = {EncounterRole::kOvertaking, EncounterRole::kOvertaken,
                                    EncounterRole::kHeadOn, EncounterRole::kGiveWay,
                                    EncounterRole::kStandOn};

TEST(EncounterScore, IsFullForEachRoleDoneWell) {
  for (const EncounterRole role : kRoles) {
    EXPECT_DOUBLE_EQ(ScoreOf(Perfect(role), 0, kOptions).overall, 100) << Name(role);
  }
}

TEST(EncounterScore, IsNothingWhereVesselsTouch) {
  for (const EncounterRole role : kRoles) {
    Encounter encounter = Perfect(role);
    encounter.has_touched = true;
    EXPECT_EQ(ScoreOf(encounter, 0, kOptions).overall, 0) << Name(role);
  }
}

TEST(EncounterScore, HasTheRulesOfTheRoleAndNoOthers) {
  const auto rules = [](EncounterRole role) {
    const EncounterScore score = ScoreOf(Perfect(role), 0, kOptions);
    std::string text;
    if (score.rule_8) text += "8 ";
    if (score.rule_13) text += "13 ";
    if (score.rule_14) text += "14 ";
    if (score.rule_15) text += "15 ";
    if (score.rule_16) text += "16 ";
    if (score.rule_17) text += "17 ";
    return text;
  };
  EXPECT_EQ(rules(EncounterRole::kOvertaking), "8 13 16 ");
  EXPECT_EQ(rules(EncounterRole::kHeadOn), "8 14 ");
  EXPECT_EQ(rules(EncounterRole::kGiveWay), "8 15 16 ");
  EXPECT_EQ(rules(EncounterRole::kStandOn), "17 ");
  EXPECT_EQ(rules(EncounterRole::kOvertaken), "17 ");
}

TEST(EncounterScore, FallsWithTheDistanceThroughItsThresholds) {
  Encounter encounter = Perfect(EncounterRole::kGiveWay);
  const auto range = [&](double closest_m) {
    encounter.closest_m = closest_m;
    return ScoreOf(encounter, 0, kOptions).parts.range;
  };
  EXPECT_DOUBLE_EQ(range(25), 1);
  EXPECT_DOUBLE_EQ(range(17.5), 0.8);
  EXPECT_DOUBLE_EQ(range(10), 0.6);
  EXPECT_DOUBLE_EQ(range(7.5), 0.4);
  EXPECT_DOUBLE_EQ(range(5), 0.2);
  EXPECT_DOUBLE_EQ(range(4), 0.1);
  EXPECT_DOUBLE_EQ(range(3), 0);
}

TEST(EncounterScore, OfSafetyLosesAQuarterDeadAhead) {
  Encounter encounter = Perfect(EncounterRole::kGiveWay);
  encounter.sides[0].alpha_deg = 0;
  EXPECT_DOUBLE_EQ(ScoreOf(encounter, 0, kOptions).safety, 75);
  encounter.sides[0].role = EncounterRole::kStandOn;
  EXPECT_DOUBLE_EQ(ScoreOf(encounter, 0, kOptions).safety, 100);
}

TEST(EncounterScore, OfRule8WantsAnEarlyAndApparentAction) {
  Encounter encounter = Perfect(EncounterRole::kGiveWay);
  Conduct& conduct = encounter.sides[0].conduct;
  conduct.largest_course_change_deg = 15;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_8, 75);
  conduct.largest_speed_change_share = -0.5;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_8, 100);
  conduct.first_alteration_s = 10 + 0.75 * 25;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_8, 75);
  encounter.sides[0].conduct = {};
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_8, 0);
}

TEST(EncounterScore, OfRule14WantsStarboardAndPortToPort) {
  Encounter encounter = Perfect(EncounterRole::kHeadOn);
  encounter.sides[0].conduct.altered_to = -1;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_14, 50);
  encounter.sides[0].beta_deg = 80;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_14, 0);
}

TEST(EncounterScore, OfRule15FallsWhereItCrossesAhead) {
  Encounter encounter = Perfect(EncounterRole::kGiveWay);
  encounter.sides[0].crossed_ahead_m = 50;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_15, 50);
  encounter.sides[0].crossed_ahead_m = 20;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_15, 0);
}

TEST(EncounterScore, OfRule17FallsWhereItDoesNotHold) {
  Encounter encounter = Perfect(EncounterRole::kStandOn);
  Conduct& conduct = encounter.sides[0].conduct;
  conduct.held_course_change_deg = 3;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 100);
  conduct.held_course_change_deg = 16.5;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 50);
  conduct.held_speed_change_share = 0.5;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 0);
}

TEST(EncounterScore, OfRule17WantsActionInExtremisAndNotToPort) {
  Encounter encounter = Perfect(EncounterRole::kStandOn);
  EncounterSide& side = encounter.sides[0];
  side.entry.beta_deg = 315;
  side.conduct.in_extremis_s = 30;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 100) << "the other cleared it";
  encounter.closest_m = 9;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 50);
  side.conduct.acted_in_extremis = true;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 100);
  side.conduct.turned_to_port_in_extremis = true;
  EXPECT_DOUBLE_EQ(*ScoreOf(encounter, 0, kOptions).rule_17, 50);
}

TEST(EncounterScore, PrefersTheVesselThatGivesWayToTheOneThatDoesNot) {
  std::vector<PlannedVessel> vessels = {{.motion = {{0, -200}, 0, 3}},
                                        {.motion = {{200, 0}, 270, 3}}};
  const double stubborn = ScoreOf(EncountersOf(vessels, 120).at(0), 0, kOptions).overall;
  vessels[0].turns = {{.at_s = 35, .course_change_deg = 60},
                      {.at_s = 60, .course_change_deg = -60}};
  const Encounter cleared = EncountersOf(vessels, 150).at(0);
  EXPECT_EQ(stubborn, 0);  // They touched.
  EXPECT_GT(cleared.closest_m, 25);
  EXPECT_DOUBLE_EQ(ScoreOf(cleared, 0, kOptions).overall, 100);
  EXPECT_DOUBLE_EQ(ScoreOf(cleared, 1, kOptions).overall, 100);
}

TEST(EncounterScore, OfHeadOnVesselsThatBothTurnToStarboardIsFull) {
  std::vector<PlannedVessel> vessels = {{.motion = {{0, 0}, 0, 3}}, {.motion = {{0, 300}, 180, 3}}};
  for (PlannedVessel& vessel : vessels) {
    vessel.turns = {{.at_s = 28, .course_change_deg = 35}, {.at_s = 45, .course_change_deg = -35}};
  }
  const Encounter starboard = EncountersOf(vessels, 120).at(0);
  EXPECT_DOUBLE_EQ(ScoreOf(starboard, 0, kOptions).overall, 100);
  EXPECT_EQ(PassedHow(starboard, 0), "port to port");
  for (PlannedVessel& vessel : vessels) {
    for (PlannedTurn& turn : vessel.turns) turn.course_change_deg *= -1;
  }
  const Encounter port = EncountersOf(vessels, 120).at(0);
  EXPECT_DOUBLE_EQ(ScoreOf(port, 0, kOptions).overall, 60);
  EXPECT_EQ(PassedHow(port, 0), "starboard to starboard");
}

}  // namespace shoal::encounter_score_test
