#include "lib/helm/behaviors/steadiness.h"

#include <gtest/gtest.h>

#include "lib/helm/behaviors/avoid_collision.h"
#include "lib/helm/behaviors/contact_testing.h"

namespace shoal::steadiness_test {

const VesselMotion kNorthbound = {.heading_deg = 0, .speed_mps = 2};

/// A contact that comes from ahead, 60 m away.
TestMeeting HeadOn() {
  return {kNorthbound, {.position_m = {0, 60}, .heading_deg = 180, .speed_mps = 2}};
}

AvoidCollisionOptions Options(bool steady) {
  return {.contact = {.contact = "bravo"},
          .pwt_outer_dist = 100,
          .pwt_inner_dist = 80,
          .min_util_cpa_dist = 8,
          .max_util_cpa_dist = 20,
          .steady = steady};
}

BehaviorAnswer Answer(const TestMeeting& meeting, double last_course_deg, bool steady = true) {
  AvoidCollisionBehavior behavior(Options(steady));
  BehaviorInputs inputs = meeting.Inputs();
  inputs.last_course_deg = last_course_deg;
  inputs.last_speed_mps = 2;
  return behavior.Run(inputs);
}

TEST(PreferLastDecision, LikesTheSideThatWasDecided) {
  const TestMeeting meeting = HeadOn();
  EXPECT_NEAR(meeting.vessel.Best(Answer(meeting, 60)).course_deg, 60, 0.1);
  EXPECT_NEAR(meeting.vessel.Best(Answer(meeting, 300)).course_deg, 300, 0.1);
}

TEST(PreferLastDecision, CountsForNothingWhereItLeadsTooClose) {
  const TestMeeting meeting = HeadOn();
  const BehaviorAnswer ahead = Answer(meeting, 2);
  const BehaviorAnswer never = Answer(meeting, 2, false);
  EXPECT_EQ(ahead.urgency, 1);
  EXPECT_EQ(ValueOf(*ahead.objective, 2, 20, 0), ValueOf(*never.objective, 2, 20, 0));
}

TEST(PreferLastDecision, LeavesTheShareOfTheDistanceAsItWas) {
  const TestMeeting meeting = HeadOn();
  const BehaviorAnswer steady = Answer(meeting, 60);
  const BehaviorAnswer never = Answer(meeting, 60, false);
  // Far from the last decision in course and in speed.
  EXPECT_NEAR(steady.urgency * ValueOf(*steady.objective, 150, 40, 0),
              ValueOf(*never.objective, 150, 40, 0), 1e-9);
}

TEST(PreferLastDecision, IsOverWhenTheContactIsPast) {
  TestMeeting meeting = HeadOn();
  meeting.contact().now.position_m = {15, -30};
  EXPECT_EQ(Answer(meeting, 60).urgency, 1);
}

}  // namespace shoal::steadiness_test
