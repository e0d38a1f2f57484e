#include "lib/helm/colregs/preferences.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lib/base/geometry/angles.h"
#include "tests/golden/helm_functions.h"

namespace shoal::preferences_test {

const ColregsLimits kLimits = {.outer_m = 80, .min_cpa_m = 8, .max_cpa_m = 25, .steady = false};
const ColregsPreferences kPreferences = {.min_cpa_m = 8, .max_cpa_m = 25, .steady = false};
const Domain kDomain;

TEST(Golden, HasTheSameFunctions) {
  const auto encounters = ReadEncounters();
  int num_compared = 0;
  for (const GoldenRow& row : ReadFunctions("colregs_exact")) {
    const GoldenEncounter& at = encounters.at(row.at("state"));
    const ColregsState state = NextColregsState({}, at.own, at.contact, kLimits, 0);
    const Objective objective = ColregsObjective(state, at.own, at.contact, kPreferences, kDomain);
    EXPECT_LE(GreatestDifference(objective, row), 0.02)
        << "state " << row.at("state") << " " << row.at("mode");
    ++num_compared;
  }
  EXPECT_EQ(num_compared, 48);
}

double DrawReal(int from, int to) { return *rc::gen::inRange(from * 100, to * 100) / 100.0; }

VesselMotion DrawVessel() {
  return {.position_m = {DrawReal(-60, 60), DrawReal(-60, 60)},
          .heading_deg = DrawReal(0, 360),
          .speed_mps = DrawReal(0, 4)};
}

/// Any role that acts, whether the geometry fits it or not.
ColregsState DrawState() {
  const auto mode =
      *rc::gen::element(ColregsMode::kCpa, ColregsMode::kOvertaking, ColregsMode::kHeadOn,
                        ColregsMode::kGiveWay, ColregsMode::kStandOn, ColregsMode::kOvertaken);
  ColregsState state = {
      .mode = mode, .entry_heading_deg = DrawReal(0, 360), .entry_speed_mps = DrawReal(0, 4)};
  if (mode == ColregsMode::kOvertaking) {
    state.sub_mode = *rc::gen::element(ColregsSubMode::kPort, ColregsSubMode::kStarboard);
  } else if (mode == ColregsMode::kGiveWay) {
    state.sub_mode = *rc::gen::element(ColregsSubMode::kStern, ColregsSubMode::kBow);
  } else if (mode == ColregsMode::kStandOn || mode == ColregsMode::kOvertaken) {
    state.sub_mode = ColregsSubMode::kInExtremis;
  }
  if (*rc::gen::arbitrary<bool>()) state.danger_s = 0;
  return state;
}

GridBox DrawBox() {
  GridBox box;
  box.first_course = *rc::gen::inRange(0, 360);
  box.last_course = *rc::gen::inRange(box.first_course, std::min(box.first_course + 40, 360));
  box.first_speed = *rc::gen::inRange(0, 41);
  box.last_speed = *rc::gen::inRange(box.first_speed, 41);
  return box;
}

RC_GTEST_PROP(Bound, HoldsEveryValueOfTheBox, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 0.1);
  ColregsPreferences preferences = kPreferences;
  preferences.port_turns_ok = *rc::gen::arbitrary<bool>();
  preferences.steady = *rc::gen::arbitrary<bool>();
  const ColregsFunction function(DrawState(), own, contact, preferences, kDomain);
  const GridBox box = DrawBox();
  const CourseSpeedFunction::Range range = function.Bound(box);
  for (int course = box.first_course; course <= box.last_course; ++course) {
    for (int speed = box.first_speed; speed <= box.last_speed; ++speed) {
      const double value = function.At(course, speed);
      RC_ASSERT(value >= range.min - 1e-9);
      RC_ASSERT(value <= range.max + 1e-9);
    }
  }
}

RC_GTEST_PROP(Function, TurnsWithTheWorld, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 0.1);
  const int turn_deg = *rc::gen::inRange(0, 360);
  const auto turned = [&](VesselMotion vessel) {
    const double range_m = vessel.position_m.norm();
    vessel.position_m = range_m * UnitVector(HeadingOf(vessel.position_m) + DegToRad(turn_deg));
    vessel.heading_deg = Wrap360(vessel.heading_deg + turn_deg);
    return vessel;
  };
  const ColregsState state = DrawState();
  const ColregsFunction here(state, own, contact, kPreferences, kDomain);
  const ColregsFunction there(state, turned(own), turned(contact), kPreferences, kDomain);
  int num_jumped = 0;  // Points on a line at which the function jumps, by rounding.
  for (int course = 0; course < 360; course += 7) {
    for (int speed = 1; speed <= 40; speed += 3) {
      const double there_value = there.At((course + turn_deg) % 360, speed);
      if (std::abs(here.At(course, speed) - there_value) > 1e-6) ++num_jumped;
    }
  }
  RC_ASSERT(num_jumped <= 20);
}

TEST(Cpa, IsTheSameInAMirror) {
  const VesselMotion own = {.heading_deg = 0, .speed_mps = 2};
  const VesselMotion contact = {.position_m = {10, 40}, .heading_deg = 200, .speed_mps = 1.5};
  const VesselMotion mirrored = {.position_m = {-10, 40}, .heading_deg = 160, .speed_mps = 1.5};
  const ColregsState state = {.mode = ColregsMode::kCpa};
  const ColregsFunction a(state, own, contact, kPreferences, kDomain);
  const ColregsFunction b(state, own, mirrored, kPreferences, kDomain);
  for (int course = 0; course < 360; ++course) {
    EXPECT_NEAR(a.At(course, 20), b.At((360 - course) % 360, 20), 1e-6) << course;
  }
}

TEST(Rule14, PrefersStarboardThoughPortIsAsFar) {
  const VesselMotion own = {.heading_deg = 0, .speed_mps = 2};
  const VesselMotion contact = {.position_m = {0, 60}, .heading_deg = 180, .speed_mps = 2};
  const ColregsFunction function({.mode = ColregsMode::kHeadOn}, own, contact, kPreferences,
                                 kDomain);
  for (int turn_deg = 10; turn_deg <= 60; turn_deg += 10) {
    EXPECT_GT(function.At(turn_deg, 20), function.At(360 - turn_deg, 20) + 5) << turn_deg;
  }
  EXPECT_GT(function.At(40, 20), function.At(20, 20));
}

TEST(Rule15, NeverCrossesAhead) {
  const VesselMotion own = {.heading_deg = 0, .speed_mps = 2};
  const VesselMotion contact = {.position_m = {40, 40}, .heading_deg = 270, .speed_mps = 2};
  const ColregsState state = {.mode = ColregsMode::kGiveWay, .sub_mode = ColregsSubMode::kStern};
  const ColregsFunction function(state, own, contact, kPreferences, kDomain);
  EXPECT_EQ(function.At(0, 40), 0);
  EXPECT_EQ(function.At(340, 30), 0);
  EXPECT_GT(function.At(60, 20), 90);
}

TEST(Rule15, CanForbidEveryTurnToPort) {
  const VesselMotion own = {.heading_deg = 60, .speed_mps = 2};
  const VesselMotion contact = {.position_m = {40, 40}, .heading_deg = 315, .speed_mps = 3};
  const ColregsState state = {.mode = ColregsMode::kGiveWay, .sub_mode = ColregsSubMode::kStern};
  ColregsPreferences preferences = kPreferences;
  EXPECT_GT(ColregsFunction(state, own, contact, preferences, kDomain).At(50, 5), 0);
  preferences.port_turns_ok = false;
  EXPECT_EQ(ColregsFunction(state, own, contact, preferences, kDomain).At(50, 5), 0);
}

TEST(Rule17, HoldsTheCourseAndSpeedOfTheEntry) {
  const ColregsState state = {.mode = ColregsMode::kStandOn,
                              .sub_mode = ColregsSubMode::kUnsure,
                              .entry_heading_deg = 33,
                              .entry_speed_mps = 1.7};
  const Objective objective = ColregsObjective(state, {}, {}, kPreferences, kDomain);
  EXPECT_NEAR(ValueOf(objective, 33, 17, 0), 100, 1e-9);
  EXPECT_LT(ValueOf(objective, 34, 17, 0), 100);
  EXPECT_LT(ValueOf(objective, 33, 18, 0), 100);
}

TEST(ClosestDistance, IsStillRaisedWhereItIsTooClose) {
  EXPECT_EQ(CpaUtilityAt(20, 8, 25).lo_m, 8);
  EXPECT_EQ(CpaUtilityAt(8, 8, 25).lo_m, 4);
  EXPECT_GT(CpaUtilityAt(0, 8, 25).lo_m, 0);
}

TEST(Rule17, DoesNotTurnToPortForAVesselOnThePortSide) {
  const VesselMotion own = {.heading_deg = 30, .speed_mps = 2};
  const VesselMotion contact = {.position_m = {-15, 20}, .heading_deg = 110, .speed_mps = 2};
  const ColregsState state = {.mode = ColregsMode::kStandOn,
                              .sub_mode = ColregsSubMode::kInExtremis,
                              .entry_heading_deg = 30,
                              .entry_speed_mps = 2};
  ColregsPreferences preferences = kPreferences;
  preferences.steady = true;
  const ColregsFunction function(state, own, contact, preferences, kDomain);
  const ColregsFunction original(state, own, contact, kPreferences, kDomain);
  double most_to_port = 0;
  double most_to_port_of_original = 0;
  double most_to_starboard = 0;
  for (int turn_deg = 10; turn_deg <= 170; ++turn_deg) {
    const int to_port = (30 - turn_deg + 360) % 360;
    for (int speed = 0; speed <= 40; ++speed) {
      most_to_port = std::max(most_to_port, function.At(to_port, speed));
      most_to_port_of_original = std::max(most_to_port_of_original, original.At(to_port, speed));
      most_to_starboard = std::max(most_to_starboard, function.At(30 + turn_deg, speed));
    }
  }
  EXPECT_EQ(most_to_port, 0);
  EXPECT_GT(most_to_port_of_original, 0);
  EXPECT_GT(most_to_starboard, 0);
}

TEST(Rule17, DoesNotGoFasterWhereItIsOvertaken) {
  const VesselMotion own = {.heading_deg = 0, .speed_mps = 1};
  const VesselMotion contact = {.position_m = {1, -15}, .heading_deg = 0, .speed_mps = 2.4};
  const ColregsState state = {.mode = ColregsMode::kOvertaken,
                              .sub_mode = ColregsSubMode::kInExtremis,
                              .entry_speed_mps = 1,
                              .danger_s = 0};
  ColregsPreferences preferences = kPreferences;
  preferences.steady = true;
  const ColregsFunction function(state, own, contact, preferences, kDomain);
  const ColregsFunction original(state, own, contact, kPreferences, kDomain);
  double most_of_faster = 0;
  double most_of_faster_of_original = 0;
  double most_of_slower = 0;
  for (int course = 0; course < 360; ++course) {
    for (int speed = 0; speed <= 40; ++speed) {
      if (speed > 10) {
        most_of_faster = std::max(most_of_faster, function.At(course, speed));
        most_of_faster_of_original =
            std::max(most_of_faster_of_original, original.At(course, speed));
      } else {
        most_of_slower = std::max(most_of_slower, function.At(course, speed));
      }
    }
  }
  EXPECT_EQ(most_of_faster, 0);
  EXPECT_GT(most_of_faster_of_original, 0);
  EXPECT_GT(most_of_slower, 0);
}

TEST(ClosestDistance, IsWorthMoreTheFartherInDanger) {
  const CpaUtility utility = CpaUtilityInDanger(10);
  double last = 0;
  for (const double cpa_m : {1.0, 5.0, 9.0, 11.0, 19.0}) {
    EXPECT_GT(UtilityOfCpa(cpa_m, utility), last) << cpa_m;
    last = UtilityOfCpa(cpa_m, utility);
  }
  EXPECT_EQ(UtilityOfCpa(20.1, utility), 100);
}

RC_GTEST_PROP(Function, TurnsWithTheWorldByWholeDegreesExactly, ()) {
  // Courses of whole degrees, the contact's among them, where a sine is 0 but for rounding.
  const auto vessel = [] {
    return VesselMotion{.position_m = {DrawReal(-60, 60), DrawReal(-60, 60)},
                        .heading_deg = static_cast<double>(*rc::gen::inRange(0, 360)),
                        .speed_mps = *rc::gen::inRange(0, 40) / 10.0};
  };
  const VesselMotion own = vessel();
  VesselMotion contact = vessel();
  contact.position_m = own.position_m + DrawReal(30, 80) * UnitVector(DegToRad(DrawReal(0, 360)));
  const int turn_deg = *rc::gen::inRange(1, 360);
  const auto turned = [&](VesselMotion each) {
    const double range_m = each.position_m.norm();
    each.position_m = range_m * UnitVector(HeadingOf(each.position_m) + DegToRad(turn_deg));
    each.heading_deg = Wrap360(each.heading_deg + turn_deg);
    return each;
  };
  ColregsState state = DrawState();
  state.entry_heading_deg = static_cast<double>(*rc::gen::inRange(0, 360));
  ColregsState turned_state = state;
  turned_state.entry_heading_deg = Wrap360(state.entry_heading_deg + turn_deg);
  ColregsPreferences preferences = kPreferences;
  preferences.steady = *rc::gen::arbitrary<bool>();
  const ColregsFunction here(state, own, contact, preferences, kDomain);
  const ColregsFunction there(turned_state, turned(own), turned(contact), preferences, kDomain);
  for (const double course_deg :
       {contact.heading_deg, Wrap360(contact.heading_deg + 180), own.heading_deg,
        Wrap360(own.heading_deg + 180), state.entry_heading_deg}) {
    const int course = static_cast<int>(course_deg);
    for (int speed = 0; speed <= 40; speed += 5) {
      const double difference = here.At(course, speed) - there.At((course + turn_deg) % 360, speed);
      RC_ASSERT(std::abs(difference) < 1e-6);
    }
  }
}

}  // namespace shoal::preferences_test
