#include "lib/helm/colregs/colregs_state.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>

#include "lib/base/geometry/angles.h"
#include "tests/golden/read_golden.h"

namespace shoal::colregs_state_test {

const ColregsLimits kLimits = {.outer_m = 80, .min_cpa_m = 8, .max_cpa_m = 25};

/// A contact at a range and relative bearing of own ship, which is at the origin and goes North.
VesselMotion ContactAt(double range_m, double beta_deg, double heading_deg, double speed_mps) {
  return {.position_m = range_m * UnitVector(DegToRad(beta_deg)),
          .heading_deg = heading_deg,
          .speed_mps = speed_mps};
}

VesselMotion Northbound(double speed_mps) { return {.heading_deg = 0, .speed_mps = speed_mps}; }

ColregsState First(const VesselMotion& own, const VesselMotion& contact,
                   const ColregsLimits& limits = kLimits) {
  return NextColregsState({}, own, contact, limits, 0);
}

std::string RoleOnMeeting(const VesselMotion& contact, double own_mps = 2) {
  return TextOf(First(Northbound(own_mps), contact));
}

VesselMotion After(const VesselMotion& vessel, double time_s) {
  VesselMotion later = vessel;
  later.position_m += vessel.speed_mps * time_s * UnitVector(DegToRad(vessel.heading_deg));
  return later;
}

/// Roles in order, both vessels holding course and speed.
std::string RolesOfHoldingOn(const VesselMotion& own, const VesselMotion& contact, double until_s,
                             const ColregsLimits& limits = kLimits) {
  ColregsState state;
  std::string roles;
  std::string last;
  for (double time_s = 0; time_s <= until_s; time_s += 0.25) {
    state = NextColregsState(state, After(own, time_s), After(contact, time_s), limits, time_s);
    const std::string role(Name(state.mode));
    if (role != last) roles += (roles.empty() ? "" : " ") + role;
    last = role;
  }
  return roles;
}

TEST(Rule13, GivesTheFasterVesselFromAbaftTheBeamTheDutyToKeepClear) {
  const VesselMotion ahead = ContactAt(40, 5, 0, 1);
  EXPECT_EQ(RoleOnMeeting(ahead), "overtaking:port");
  EXPECT_EQ(RuleOf(First(Northbound(2), ahead)), "13");
  EXPECT_EQ(RoleOnMeeting(ContactAt(40, 355, 0, 1)), "overtaking:starboard");
}

TEST(Rule13, LetsTheVesselThatIsOvertakenStandOn) {
  const VesselMotion behind = ContactAt(40, 175, 0, 3);
  EXPECT_EQ(First(Northbound(1), behind).mode, ColregsMode::kOvertaken);
  EXPECT_EQ(RuleOf(First(Northbound(1), behind)), "13/17");
}

TEST(Rule13, EndsAtTheSidelight) {
  // The contact goes North-West; own ship comes from 112.5 degrees abaft its bow, and 2 degrees
  // off.
  for (const double alpha_deg : {110.5, 114.5}) {
    const VesselMotion contact = {.heading_deg = 0, .speed_mps = 1};
    const Eigen::Vector2d seen_from_contact_m = 40 * UnitVector(DegToRad(alpha_deg));
    const VesselMotion own = {
        .position_m = seen_from_contact_m, .heading_deg = 320, .speed_mps = 3};
    EXPECT_EQ(First(own, contact).mode == ColregsMode::kOvertaking, alpha_deg > 112.5) << alpha_deg;
  }
}

TEST(Rule13, KeepsTheDutyUntilFinallyPastAndClear) {
  EXPECT_EQ(RolesOfHoldingOn(Northbound(2.5), ContactAt(40, 20, 0, 1), 120), "overtaking cpa none");
  EXPECT_EQ(RolesOfHoldingOn(Northbound(1), ContactAt(40, 200, 0, 2.5), 120), "overtaken cpa none");
}

TEST(Rule13, SurvivesAMomentInWhichTheVesselsOpen) {
  const VesselMotion contact = ContactAt(25, 60, 0, 1);
  ColregsState state = First({.heading_deg = 20, .speed_mps = 2}, contact);
  ASSERT_EQ(state.mode, ColregsMode::kOvertaking);
  state = NextColregsState(state, {.heading_deg = 20, .speed_mps = 2}, contact, kLimits, 4);
  const VesselMotion opening = {.heading_deg = 180, .speed_mps = 2};
  state = NextColregsState(state, opening, contact, kLimits, 5);
  state = NextColregsState(state, opening, contact, kLimits, 7.75);
  EXPECT_EQ(state.mode, ColregsMode::kOvertaking);
  state = NextColregsState(state, opening, contact, kLimits, 8);
  EXPECT_EQ(state.mode, ColregsMode::kCpa);
}

TEST(Rule13, ChangesTheSideInTheOriginalsWayWhereTheContactIsClearlyOnTheOther) {
  ColregsLimits original = kLimits;
  original.steady = false;
  const auto sub_mode_at = [&](ColregsSubMode before, double beta_deg) {
    const ColregsState state = {.mode = ColregsMode::kOvertaking, .sub_mode = before};
    return NextColregsState(state, Northbound(2), ContactAt(40, beta_deg, 0, 1), original, 0)
        .sub_mode;
  };
  EXPECT_EQ(sub_mode_at(ColregsSubMode::kPort, 356), ColregsSubMode::kPort);
  EXPECT_EQ(sub_mode_at(ColregsSubMode::kPort, 354), ColregsSubMode::kStarboard);
  EXPECT_EQ(sub_mode_at(ColregsSubMode::kStarboard, 4), ColregsSubMode::kStarboard);
  EXPECT_EQ(sub_mode_at(ColregsSubMode::kStarboard, 6), ColregsSubMode::kPort);
}

TEST(Rule14, IsForReciprocalCourses) {
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 0, 180, 2)), "head-on");
  EXPECT_EQ(RuleOf(First(Northbound(2), ContactAt(60, 0, 180, 2))), "14");
  EXPECT_EQ(RoleOnMeeting(ContactAt(159, 3, 180, 2)), "head-on");
  EXPECT_EQ(RoleOnMeeting(ContactAt(161, 3, 180, 2)), "none");
}

TEST(Rule14, EndsAtTwelveDegreesOffEitherBow) {
  // Alpha is 0 where the contact's heading is the reciprocal of the bearing.
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 11.9, 191.9, 2)), "head-on");
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 12.1, 192.1, 2)), "cpa");
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 0, 191.9, 2)), "head-on");
  EXPECT_EQ(First(Northbound(2), ContactAt(60, 1, 181 + 12.1, 2)).mode, ColregsMode::kGiveWay);
}

TEST(Rule14, EndsOnceThePairHasPassed) {
  EXPECT_EQ(RolesOfHoldingOn(Northbound(2), ContactAt(60, 359, 181, 2), 60), "head-on cpa none");
}

TEST(Rule15, MakesTheVesselWithTheOtherToStarboardGiveWay) {
  const VesselMotion from_starboard = ContactAt(60, 45, 270, 2);
  EXPECT_EQ(RoleOnMeeting(from_starboard), "give-way:stern");
  EXPECT_EQ(RuleOf(First(Northbound(2), from_starboard)), "15/16");
  EXPECT_EQ(First(Northbound(2), ContactAt(60, 315, 90, 2)).mode, ColregsMode::kStandOn);
  EXPECT_EQ(RuleOf(First(Northbound(2), ContactAt(60, 315, 90, 2))), "15/17");
}

TEST(Rule15, CrossesAheadOnlyWithDistanceOrWhereThereIsNoRoomAstern) {
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 50, 270, 0.5), 3), "give-way:bow");
  // Ahead by 17 m, and the contact's line is 12 m off.
  EXPECT_EQ(RoleOnMeeting(ContactAt(31.5, 45.7, 247.3, 1.71), 2.84), "give-way:bow");
  EXPECT_EQ(RoleOnMeeting(ContactAt(60, 45, 270, 2)), "give-way:stern");
}

TEST(Rule15, CountsTheOwnTurningCircleAsRoom) {
  const VesselMotion contact = ContactAt(60, 45, 270, 1.5);
  EXPECT_EQ(TextOf(First(Northbound(2), contact)), "give-way:stern");
  ColregsLimits limits = kLimits;
  limits.turn_radius_m = 30;
  EXPECT_EQ(TextOf(First(Northbound(2), contact, limits)), "give-way:bow");
}

TEST(Rule15, KeepsTheWayThatWasChosenAtEntry) {
  ColregsState state = First(Northbound(2), ContactAt(60, 45, 270, 2));
  ASSERT_EQ(state.sub_mode, ColregsSubMode::kStern);
  state = NextColregsState(state, Northbound(3), ContactAt(50, 50, 270, 0.5), kLimits, 1);
  EXPECT_EQ(state.sub_mode, ColregsSubMode::kStern);
}

TEST(Rule16, EndsOnceOwnShipIsOnTheOtherSide) {
  EXPECT_EQ(RolesOfHoldingOn(Northbound(2), ContactAt(60, 60, 270, 2), 60), "give-way cpa none");
}

TEST(Rule17, HoldsUntilTheyOpen) {
  EXPECT_EQ(RolesOfHoldingOn(Northbound(2), ContactAt(60, 330, 90, 2), 60), "stand-on cpa none");
}

TEST(Rule17, HoldsOnAfterTheOtherHasCrossedAhead) {
  // At first to port; after 12 s to starboard, still closing.
  const VesselMotion own = Northbound(1);
  const VesselMotion crossing = {.position_m = {-24, 60}, .heading_deg = 120, .speed_mps = 2.5};
  ColregsState state = First(own, crossing);
  ASSERT_EQ(state.mode, ColregsMode::kStandOn);
  const VesselMotion own_then = After(own, 13);
  const VesselMotion crossed = After(crossing, 13);
  ASSERT_GT(crossed.position_m.x(), own_then.position_m.x());
  state = NextColregsState(state, own_then, crossed, kLimits, 13);
  EXPECT_EQ(state.mode, ColregsMode::kStandOn);
}

TEST(Rule17, RemembersWhatItHolds) {
  ColregsState state = First({.heading_deg = 7, .speed_mps = 1.7}, ContactAt(60, 315, 90, 2));
  state = NextColregsState(state, {.heading_deg = 9, .speed_mps = 1.8}, ContactAt(55, 315, 90, 2),
                           kLimits, 1);
  EXPECT_EQ(state.entry_heading_deg, 7);
  EXPECT_EQ(state.entry_speed_mps, 1.7);
}

TEST(Rule17, HoldsNoCourseThatTheVesselHasLeft) {
  const VesselMotion contact = ContactAt(60, 315, 90, 2);
  for (const auto& [turned_deg, held_deg] : {std::pair{25.0, 7.0}, {57.0, 37.0}, {320.0, 340.0}}) {
    ColregsState state = First({.heading_deg = 7, .speed_mps = 1.7}, contact);
    ASSERT_TRUE(state.stands_on());
    const VesselMotion turned = {.heading_deg = turned_deg, .speed_mps = 1.7};
    EXPECT_NEAR(NextColregsState(state, turned, contact, kLimits, 1).entry_heading_deg, held_deg,
                1e-9);
    ColregsLimits original = kLimits;
    original.steady = false;
    EXPECT_EQ(NextColregsState(state, turned, contact, original, 1).entry_heading_deg, 7);
  }
}

TEST(Rule17b, ActsWhenTheOtherAloneCanNotKeepClearAnyMore) {
  const ColregsState state = First(Northbound(2), ContactAt(24, 315, 90, 2));
  EXPECT_EQ(TextOf(state), "stand-on:in_extremis");
  EXPECT_EQ(RuleOf(state), "17(b)");
  EXPECT_NE(TextOf(First(Northbound(2), ContactAt(26, 315, 90, 2))), "stand-on:in_extremis");
}

TEST(Rule17b, IsLatchedWhenTheManoeuvreTakesEffect) {
  ColregsState state = First(Northbound(2), ContactAt(24, 315, 90, 2));
  ASSERT_TRUE(state.in_extremis());
  // Own ship has turned to starboard: the closest distance is out of the band, the danger not over.
  const VesselMotion evading = {.heading_deg = 60, .speed_mps = 2};
  state = NextColregsState(state, evading, ContactAt(23, 312, 90, 2), kLimits, 4);
  EXPECT_TRUE(state.in_extremis());
  // A moment of opening does not end it; three seconds do.
  const VesselMotion opening = {.heading_deg = 120, .speed_mps = 2};
  state = NextColregsState(state, opening, ContactAt(23, 312, 90, 2), kLimits, 5);
  EXPECT_TRUE(state.in_extremis());
  state = NextColregsState(state, opening, ContactAt(24, 312, 90, 2), kLimits, 8);
  EXPECT_FALSE(state.in_extremis());
}

TEST(Dwell, KeepsARoleForItsTimeAndDoesNotTakeItBackAtOnce) {
  const VesselMotion crossing = ContactAt(60, 45, 270, 2);
  const VesselMotion opening = ContactAt(60, 45, 90, 3);
  ColregsState state = First(Northbound(2), crossing);
  state = NextColregsState(state, Northbound(2), opening, kLimits, 2.9);
  EXPECT_EQ(state.mode, ColregsMode::kGiveWay);
  state = NextColregsState(state, Northbound(2), opening, kLimits, 3);
  EXPECT_EQ(state.mode, ColregsMode::kCpa);
  state = NextColregsState(state, Northbound(2), crossing, kLimits, 5.9);
  EXPECT_EQ(state.mode, ColregsMode::kCpa);
  state = NextColregsState(state, Northbound(2), crossing, kLimits, 6);
  EXPECT_EQ(state.mode, ColregsMode::kGiveWay);
}

TEST(Dwell, NeverKeepsAContactThatIsOutOfRange) {
  const ColregsState state = First(Northbound(2), ContactAt(79, 45, 270, 2));
  ASSERT_EQ(state.mode, ColregsMode::kGiveWay);
  EXPECT_EQ(NextColregsState(state, Northbound(2), ContactAt(81, 45, 270, 2), kLimits, 0.25).mode,
            ColregsMode::kNone);
}

TEST(NoWay, IsKeptClearOfWithoutARole) {
  for (const double beta_deg : {0.0, 30.0, 90.0, 200.0, 330.0}) {
    for (double heading_deg = 0; heading_deg < 360; heading_deg += 15) {
      EXPECT_EQ(RoleOnMeeting(ContactAt(40, beta_deg, heading_deg, 0.05)), "cpa");
      EXPECT_EQ(RoleOnMeeting(ContactAt(40, beta_deg, heading_deg, 2), 0), "cpa");
    }
  }
}

TEST(HeadOnOnly, LeavesEverythingElseWithoutRole) {
  ColregsLimits limits = kLimits;
  limits.head_on_only = true;
  EXPECT_EQ(TextOf(First(Northbound(2), ContactAt(60, 45, 270, 2), limits)), "cpa");
  EXPECT_EQ(TextOf(First(Northbound(2), ContactAt(60, 0, 180, 2), limits)), "head-on");
}

std::string GoldenNameOf(const ColregsState& state) {
  static const std::map<ColregsMode, std::string> kModes = {
      {ColregsMode::kNone, "none"},
      {ColregsMode::kCpa, "cpa"},
      {ColregsMode::kOvertaking, "overtaking"},
      {ColregsMode::kHeadOn, "headon"},
      {ColregsMode::kOvertaken, "standon_ot"},
      {ColregsMode::kGiveWay, "giveway"},
      {ColregsMode::kStandOn, "standon"}};
  const std::string sub_mode(Name(state.sub_mode));
  return kModes.at(state.mode) + ":" +
         (sub_mode.empty()      ? "none"
          : state.in_extremis() ? "inextremis"
                                : sub_mode);
}

TEST(Golden, HasTheSameModeInTheFirstIteration) {
  std::map<std::string, GoldenRow> states;
  for (const GoldenRow& row : ReadGoldenCsv("helm/states.csv")) states[row.at("state")] = row;
  int num_compared = 0;
  ColregsLimits original = kLimits;
  original.steady = false;
  for (const GoldenRow& row : ReadGoldenCsv("helm/functions.csv")) {
    if (row.at("behavior") != "colregs_exact") continue;
    const GoldenRow& at = states.at(row.at("state"));
    const VesselMotion own = {.position_m = {Number(at, "osx"), Number(at, "osy")},
                              .heading_deg = Number(at, "osh"),
                              .speed_mps = Number(at, "osv")};
    const VesselMotion contact = {.position_m = {Number(at, "cnx"), Number(at, "cny")},
                                  .heading_deg = Number(at, "cnh"),
                                  .speed_mps = Number(at, "cnv")};
    EXPECT_EQ(GoldenNameOf(First(own, contact, original)), row.at("mode")) << row.at("state");
    ++num_compared;
  }
  EXPECT_EQ(num_compared, 48);
}

VesselMotion DrawVessel() {
  const auto real = [](int from, int to) {
    return *rc::gen::inRange(from * 100, to * 100) / 100.0;
  };
  return {.position_m = {real(-40, 40), real(-40, 40)},
          .heading_deg = real(0, 360),
          .speed_mps = real(0, 4)};
}

RC_GTEST_PROP(ColregsState, TurnsWithTheWorld, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 1);
  const int turn_deg = *rc::gen::inRange(0, 360);
  const auto turned = [&](VesselMotion vessel) {
    const double range_m = vessel.position_m.norm();
    vessel.position_m = range_m * UnitVector(HeadingOf(vessel.position_m) + DegToRad(turn_deg));
    vessel.heading_deg = Wrap360(vessel.heading_deg + turn_deg);
    return vessel;
  };
  RC_ASSERT(First(own, contact).mode == First(turned(own), turned(contact)).mode);
}

RC_GTEST_PROP(ColregsState, GivesBothVesselsRolesThatFit, ()) {
  const VesselMotion own = DrawVessel();
  const VesselMotion contact = DrawVessel();
  RC_PRE((own.position_m - contact.position_m).norm() > 1);
  const ColregsMode a = First(own, contact).mode;
  const ColregsMode b = First(contact, own).mode;
  RC_ASSERT((a == ColregsMode::kHeadOn) == (b == ColregsMode::kHeadOn));
  // Two vessels never both hold on: each of those that stand on has one that keeps clear.
  if (a == ColregsMode::kStandOn) RC_ASSERT(b == ColregsMode::kGiveWay);
  if (a == ColregsMode::kOvertaken)
    RC_ASSERT(b == ColregsMode::kOvertaking || b == ColregsMode::kCpa);
}

RC_GTEST_PROP(ColregsState, IsNotItsMirrorImageInACrossing, ()) {
  const double beta_deg = *rc::gen::inRange(15, 100);
  const VesselMotion contact = ContactAt(50, beta_deg, Wrap360(beta_deg + 180 + 45), 2);
  const VesselMotion mirrored = ContactAt(50, 360 - beta_deg, 360 - contact.heading_deg, 2);
  RC_PRE(First(Northbound(2), contact).mode == ColregsMode::kGiveWay);
  RC_ASSERT(First(Northbound(2), mirrored).mode != ColregsMode::kGiveWay);
}

TEST(Danger, IsSeenInEveryRole) {
  const VesselMotion own = Northbound(3);
  const std::pair<VesselMotion, ColregsMode> cases[] = {
      {ContactAt(20, 0, 180, 3), ColregsMode::kHeadOn},
      {ContactAt(20, 45, 270, 3), ColregsMode::kGiveWay},
      {ContactAt(20, 315, 90, 3), ColregsMode::kStandOn},
      {ContactAt(15, 0, 0, 1), ColregsMode::kOvertaking},
      {ContactAt(15, 180, 0, 6), ColregsMode::kOvertaken},
      {ContactAt(15, 0, 0, 0), ColregsMode::kCpa}};
  for (const auto& [contact, mode] : cases) {
    const ColregsState state = First(own, contact);
    EXPECT_EQ(state.mode, mode);
    EXPECT_TRUE(state.danger_s.has_value()) << Name(mode);
    ColregsLimits original = kLimits;
    original.steady = false;
    EXPECT_FALSE(First(own, contact, original).danger_s.has_value()) << Name(mode);
  }
}

TEST(Danger, IsNoneFarAwayOrClearOrOpening) {
  EXPECT_TRUE(First(Northbound(3), ContactAt(24, 0, 180, 3)).danger_s.has_value());
  EXPECT_FALSE(First(Northbound(3), ContactAt(26, 0, 180, 3)).danger_s.has_value());
  const VesselMotion aside = {.position_m = {8.1, 20}, .heading_deg = 180, .speed_mps = 3};
  EXPECT_FALSE(First(Northbound(3), aside).danger_s.has_value());
  EXPECT_FALSE(First(Northbound(3), ContactAt(7, 180, 180, 3)).danger_s.has_value());
}

TEST(Rule17, HoldsAVesselThatIsOvertakenUntilDangerIsImminent) {
  const VesselMotion own = Northbound(1);
  const auto from_astern = [](double range_m) { return ContactAt(range_m, 180, 0, 2.4); };
  ColregsState state = First(own, from_astern(24));
  EXPECT_EQ(state.mode, ColregsMode::kOvertaken);
  EXPECT_TRUE(state.stands_on());
  state = NextColregsState(state, own, from_astern(14), kLimits, 7);
  EXPECT_TRUE(state.in_extremis());
}

TEST(Rule17, LeavesInExtremisWhenStandingOnIsClearAgain) {
  const VesselMotion own = Northbound(1);
  ColregsState state = First(own, ContactAt(14, 180, 0, 2.4));
  ASSERT_TRUE(state.in_extremis());
  // The other has turned away and will pass 14 m off.
  const VesselMotion passes = {.position_m = {-14, -6}, .heading_deg = 0, .speed_mps = 2.4};
  state = NextColregsState(state, own, passes, kLimits, 2.75);
  EXPECT_TRUE(state.in_extremis());  // For min_dwell.
  state = NextColregsState(state, own, passes, kLimits, 3.25);
  EXPECT_TRUE(state.stands_on());
  ColregsLimits original = kLimits;
  original.steady = false;
  state = First(own, ContactAt(14, 180, 0, 2.4), original);
  ASSERT_TRUE(state.in_extremis());
  state = NextColregsState(state, own, passes, original, 3.25);
  EXPECT_TRUE(state.in_extremis());
}

TEST(Rule13, KeepsTheSideOfPassingOnceItIsChosen) {
  const ColregsState state = {.mode = ColregsMode::kOvertaking, .sub_mode = ColregsSubMode::kPort};
  EXPECT_EQ(NextColregsState(state, Northbound(2), ContactAt(40, 340, 0, 1), kLimits, 0).sub_mode,
            ColregsSubMode::kPort);
}

}  // namespace shoal::colregs_state_test
