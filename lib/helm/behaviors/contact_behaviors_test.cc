#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "lib/base/geometry/angles.h"
#include "lib/helm/behaviors/approach_function.h"
#include "lib/helm/behaviors/avoid_collision.h"
#include "lib/helm/behaviors/colregs.h"
#include "lib/helm/behaviors/contact_aim.h"
#include "lib/helm/behaviors/contact_testing.h"
#include "lib/helm/behaviors/convoy.h"
#include "lib/helm/behaviors/cut_range.h"
#include "lib/helm/behaviors/shadow.h"
#include "lib/helm/behaviors/trail.h"
#include "lib/helm/decision/decide.h"

namespace shoal::contact_behaviors_test {

const ContactOptions kBravo = {.contact = "bravo"};
const VesselMotion kNorthbound = {.heading_deg = 0, .speed_mps = 2};

VesselMotion Southbound(double x_m, double y_m) {
  return {.position_m = {x_m, y_m}, .heading_deg = 180, .speed_mps = 2};
}

TEST(Relevance, IsFullAtTheInnerDistanceAndNoneAtTheOuter) {
  EXPECT_EQ(RelevanceAt(80, 20, 80, "linear"), 0);
  EXPECT_EQ(RelevanceAt(20, 20, 80, "linear"), 1);
  EXPECT_EQ(RelevanceAt(1, 20, 80, "linear"), 1);
  EXPECT_NEAR(RelevanceAt(50, 20, 80, "linear"), 0.5, 1e-12);
  EXPECT_NEAR(RelevanceAt(50, 20, 80, "quasi"), std::pow(0.5, 1.5), 1e-12);
  EXPECT_NEAR(RelevanceAt(50, 20, 80, "quadratic"), 0.25, 1e-12);
  EXPECT_EQ(RelevanceAt(50, 90, 80, "linear"), 1);
}

TEST(ContactBehavior, WarnsWithoutAContactOrStopsIfAsked) {
  TestMeeting meeting(kNorthbound, Southbound(0, 50));
  meeting.contacts.clear();
  AvoidCollisionBehavior lenient({.contact = kBravo});
  const BehaviorAnswer warned = meeting.Run(lenient);
  EXPECT_FALSE(warned.objective.has_value());
  EXPECT_NE(warned.warning, "");
  EXPECT_EQ(warned.error, "");
  AvoidCollisionBehavior strict({.contact = {.contact = "bravo", .on_no_contact_ok = false}});
  EXPECT_NE(meeting.Run(strict).error, "");
}

TEST(ContactBehavior, StatesItsRole) {
  TestMeeting meeting(kNorthbound, Southbound(0, 50));
  meeting.contact().age_s = 3;
  ColregsBehavior behavior({.contact = {.contact = "bravo", .post_per_contact_info = true}});
  const BehaviorAnswer answer = meeting.Run(behavior);
  ASSERT_TRUE(answer.role.has_value());
  EXPECT_EQ(answer.role->contact, "bravo");
  EXPECT_EQ(answer.role->role, "head-on");
  EXPECT_EQ(answer.role->rule, "14");
  EXPECT_NEAR(answer.role->range_m, 50, 1e-9);
  EXPECT_NEAR(answer.role->cpa_m, 0, 1e-9);
  EXPECT_EQ(answer.role->age_s, 3);
  EXPECT_EQ(std::get<std::string>(PostOf(answer, "ROLE_BRAVO")), "head-on");
  EXPECT_EQ(std::get<double>(PostOf(answer, "RANGE_BRAVO")), 50);
  EXPECT_EQ(std::get<double>(PostOf(answer, "CLOSING_SPEED_BRAVO")), 4);
}

TEST(AvoidCollision, HasNoPreferenceFromTheOuterDistanceOn) {
  const TestMeeting meeting(kNorthbound, Southbound(0, 200));
  AvoidCollisionBehavior behavior({.contact = kBravo});
  EXPECT_FALSE(meeting.Run(behavior).objective.has_value());
  EXPECT_TRUE(behavior.is_constraint());
}

TEST(AvoidCollision, IgnoresContactsAboveADivingVehicle) {
  TestMeeting meeting(kNorthbound, Southbound(0, 50));
  AvoidCollisionBehavior behavior({.contact = kBravo, .collision_depth = 5});
  meeting.vessel.own.depth_m = 5;
  EXPECT_TRUE(meeting.Run(behavior).objective.has_value());
  meeting.vessel.own.depth_m = 5.1;
  EXPECT_FALSE(meeting.Run(behavior).objective.has_value());
}

TEST(AvoidCollision, WidensTheDistanceToAContactByItsAge) {
  TestMeeting meeting(kNorthbound, Southbound(15, 80));
  AvoidCollisionBehavior behavior(
      {.contact = kBravo, .min_util_cpa_dist = 8, .max_util_cpa_dist = 12, .widen_per_s = 0.5});
  EXPECT_NEAR(ValueOf(*meeting.Run(behavior).objective, 0, 20, 0), 100, 1e-9);
  meeting.contact().age_s = 20;
  EXPECT_NEAR(ValueOf(*meeting.Run(behavior).objective, 0, 20, 0), 0, 1e-9);
}

TEST(AvoidCollision, IsTheMirrorImageInAMirror) {
  AvoidCollisionBehavior behavior({.contact = kBravo});
  const TestMeeting meeting(kNorthbound, Southbound(7, 70));
  const TestMeeting mirrored(kNorthbound, Southbound(-7, 70));
  const Objective a = *meeting.Run(behavior).objective;
  const Objective b = *mirrored.Run(behavior).objective;
  for (int course = 0; course < 360; course += 5) {
    EXPECT_NEAR(ValueOf(a, course, 20, 0), ValueOf(b, (360 - course) % 360, 20, 0), 1e-6) << course;
  }
}

TEST(Colregs, BreaksToStarboardHeadOnAndInItsMirrorImage) {
  for (const double x_m : {-3.0, 3.0}) {
    const TestMeeting meeting(kNorthbound, Southbound(x_m, 70));
    ColregsBehavior behavior({.contact = kBravo});
    const BestPoint best = meeting.Best(behavior);
    EXPECT_GT(best.course_deg, 10) << x_m;
    EXPECT_LT(best.course_deg, 180) << x_m;
  }
}

TEST(Colregs, JudgesAnewAfterAnIdleTime) {
  TestMeeting meeting(kNorthbound, {.position_m = {40, 40}, .heading_deg = 270, .speed_mps = 1.5});
  ColregsBehavior behavior({.contact = kBravo});
  EXPECT_EQ(meeting.Run(behavior).role->role, "give-way:bow");
  meeting.contact().now.heading_deg = 225;
  meeting.vessel.time_s = 1;
  meeting.vessel.own.motion.heading_deg = 45;
  EXPECT_EQ(meeting.Run(behavior).role->role, "give-way:bow");
  (void)behavior.Idle(meeting.Inputs());
  EXPECT_EQ(meeting.Run(behavior).role->role, "head-on");
}

TEST(Trail, EndsUpOnItsPointBehindTheContact) {
  TestMeeting meeting({.position_m = {-60, -60}, .heading_deg = 0, .speed_mps = 2},
                      {.position_m = {0, 0}, .heading_deg = 90, .speed_mps = 1.5});
  TrailBehavior behavior({.contact = kBravo, .trail_range = 20, .radius = 5, .nm_radius = 15});
  for (int i = 0; i < 400; ++i) (void)meeting.Step(behavior, 0.25);
  const Eigen::Vector2d point_m = meeting.contact().now.position_m - Eigen::Vector2d(20, 0);
  EXPECT_LT((meeting.vessel.own.motion.position_m - point_m).norm(), 5.5);
  EXPECT_EQ(std::get<std::string>(PostOf(meeting.Run(behavior), "REGION")), "inside radius");
}

TEST(Trail, TakesAnAbsoluteAngle) {
  const TestMeeting meeting(kNorthbound,
                            {.position_m = {0, 60}, .heading_deg = 90, .speed_mps = 1});
  TrailBehavior behavior(
      {.contact = kBravo, .trail_range = 30, .trail_angle = 0, .trail_angle_type = "absolute"});
  const BehaviorAnswer answer = meeting.Run(behavior);
  ASSERT_TRUE(answer.view.steers_for_m.has_value());
  EXPECT_NEAR((*answer.view.steers_for_m - Eigen::Vector2d(0, 90)).norm(), 0, 1e-9);
}

TEST(Trail, RestsBeyondItsOuterDistance) {
  const TestMeeting meeting(kNorthbound, Southbound(0, 60));
  TrailBehavior behavior({.contact = kBravo, .pwt_outer_dist = 60});
  const BehaviorAnswer answer = meeting.Run(behavior);
  EXPECT_FALSE(answer.objective.has_value());
  EXPECT_EQ(std::get<double>(PostOf(answer, "PURSUIT")), 0);
}

TEST(Shadow, CopiesHeadingAndSpeed) {
  const TestMeeting meeting(kNorthbound,
                            {.position_m = {500, 0}, .heading_deg = 217, .speed_mps = 1.3});
  ShadowBehavior behavior({.contact = kBravo});
  EXPECT_EQ(meeting.Best(behavior).course_deg, 217);
  EXPECT_NEAR(meeting.Best(behavior).speed_mps, 1.3, 1e-9);
}

TEST(CutRange, PursuesWithoutAGiveUpDistanceToo) {
  const TestMeeting meeting(kNorthbound, Southbound(300, 0));
  CutRangeBehavior behavior({.contact = kBravo});
  const BehaviorAnswer answer = meeting.Run(behavior);
  EXPECT_EQ(answer.flags, std::vector<std::string>{"pursueflag"});
  EXPECT_EQ(answer.relevance, 1);
  EXPECT_EQ(meeting.vessel.Best(answer).course_deg, 90);
  EXPECT_NEAR(meeting.vessel.Best(answer).speed_mps, 4, 1e-9);
}

TEST(CutRange, LeadsTheContactWhereItIsPatient) {
  const TestMeeting meeting(kNorthbound, Southbound(30, 0));
  CutRangeBehavior behavior({.contact = kBravo, .pwt_outer_dist = 20, .patience = 85});
  const double course_deg = meeting.Best(behavior).course_deg;
  EXPECT_GT(course_deg, 95);
  EXPECT_LT(course_deg, 180);
}

TEST(CutRange, GivesUpOnce) {
  TestMeeting meeting(kNorthbound, Southbound(60, 0));
  CutRangeBehavior behavior({.contact = kBravo, .giveup_dist = 100});
  EXPECT_EQ(meeting.Run(behavior).flags, std::vector<std::string>{"pursueflag"});
  meeting.contact().now.position_m = {101, 0};
  const BehaviorAnswer given_up = meeting.Run(behavior);
  EXPECT_EQ(given_up.flags, std::vector<std::string>{"giveupflag"});
  EXPECT_FALSE(given_up.objective.has_value());
  EXPECT_TRUE(meeting.Run(behavior).flags.empty());
}

TEST(Convoy, FollowsTheTrackOfTheContactAtItsDistance) {
  // The contact goes East for 60 m, then North: own ship does not cut the corner.
  TestMeeting meeting({.position_m = {-25, 0}, .heading_deg = 90, .speed_mps = 1.5},
                      {.position_m = {0, 0}, .heading_deg = 90, .speed_mps = 1.5});
  ConvoyBehavior behavior({.contact = kBravo, .range = 25});
  double farthest_m = 0;  // From the contact's track.
  for (int i = 0; i < 400; ++i) {
    if (meeting.contact().now.position_m.x() >= 60) meeting.contact().now.heading_deg = 0;
    (void)meeting.Step(behavior, 0.25);
    const Eigen::Vector2d own_m = meeting.vessel.own.motion.position_m;
    farthest_m = std::max(farthest_m, std::min(std::abs(own_m.y()), std::abs(own_m.x() - 60)));
  }
  EXPECT_LT(farthest_m, 3);
  const double behind_m =
      (meeting.contact().now.position_m - meeting.vessel.own.motion.position_m).norm();
  EXPECT_NEAR(behind_m, 25, 3);
}

TEST(Convoy, WaitsForASlowContact) {
  TestMeeting meeting({.position_m = {-5, 0}, .heading_deg = 90, .speed_mps = 1},
                      {.position_m = {0, 0}, .heading_deg = 90, .speed_mps = 0.1});
  ConvoyBehavior behavior({.contact = kBravo, .range = 25});
  EXPECT_LT(meeting.Best(behavior).speed_mps, 0.1);
}

TEST(ApproachFunction, IsBoundedInEveryBox) {
  const Domain domain;
  const ApproachFunction function(
      {.offset_m = {30, -20}, .velocity_mps = {0.5, 1.2}, .horizon_s = 15},
      {.closing = 55, .near = 45}, domain);
  for (int course = 0; course < 360; course += 12) {
    for (int speed = 0; speed <= 36; speed += 4) {
      const GridBox box = {.first_course = course,
                           .last_course = course + 11,
                           .first_speed = speed,
                           .last_speed = speed + 4};
      const CourseSpeedFunction::Range range = function.Bound(box);
      for (int i = box.first_course; i <= box.last_course; ++i) {
        for (int j = box.first_speed; j <= box.last_speed; ++j) {
          EXPECT_GE(function.At(i, j), range.min);
          EXPECT_LE(function.At(i, j), range.max);
        }
      }
    }
  }
}

TEST(ImminentDanger, CountsEightTimesInEveryRole) {
  // 23 m ahead, going on passes at 0.8 m: nothing may outvote that.
  TestMeeting meeting(kNorthbound, Southbound(0.8, 23));
  ColregsBehavior colregs({.contact = kBravo});
  AvoidCollisionBehavior avoid({.contact = kBravo});
  EXPECT_EQ(meeting.Run(colregs).urgency, kUrgencyInDanger);
  EXPECT_EQ(meeting.Run(avoid).urgency, kUrgencyInDanger);
  ColregsBehavior original_colregs({.contact = kBravo, .steady = false});
  AvoidCollisionBehavior original_avoid({.contact = kBravo, .steady = false});
  EXPECT_EQ(meeting.Run(original_colregs).urgency, 1);
  EXPECT_EQ(meeting.Run(original_avoid).urgency, 1);
}

TEST(VerticalSeparation, LeavesContactsFarAboveOrBelowAlone) {
  TestMeeting meeting(kNorthbound, Southbound(0, 50));
  for (const auto& [own_m, contact_m, is_avoided] : {std::tuple(0.0, 20.0, false),
                                                     {20.0, 0.0, false},
                                                     {0.0, 10.0, false},
                                                     {0.0, 9.9, true},
                                                     {25.0, 20.0, true}}) {
    meeting.vessel.own.depth_m = own_m;
    meeting.contact().depth_m = contact_m;
    ColregsBehavior colregs({.contact = kBravo});
    AvoidCollisionBehavior avoid({.contact = kBravo});
    EXPECT_EQ(meeting.Run(colregs).objective.has_value(), is_avoided) << own_m << contact_m;
    EXPECT_EQ(meeting.Run(avoid).objective.has_value(), is_avoided) << own_m << contact_m;
    AvoidCollisionBehavior flat({.contact = {.contact = "bravo", .vertical_separation = -1}});
    EXPECT_TRUE(meeting.Run(flat).objective.has_value());
  }
}

TEST(VerticalSeparation, CountsHowFarAContactMayHaveComeSinceItsReport) {
  TestMeeting meeting(kNorthbound, Southbound(0, 50));
  meeting.contact().depth_m = 20;
  for (const auto& [age_s, is_avoided] : {std::pair(20.0, false), {20.5, true}}) {
    meeting.contact().age_s = age_s;
    ColregsBehavior colregs({.contact = kBravo});
    AvoidCollisionBehavior avoid({.contact = kBravo});
    EXPECT_EQ(meeting.Run(colregs).objective.has_value(), is_avoided) << age_s;
    EXPECT_EQ(meeting.Run(avoid).objective.has_value(), is_avoided) << age_s;
  }
}

}  // namespace shoal::contact_behaviors_test
