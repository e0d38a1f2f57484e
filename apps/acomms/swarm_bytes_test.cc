#include "apps/acomms/swarm_bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lib/comms/swarm/broadcast_message.h"

namespace shoal::swarm_bytes_test {

nav_t NavAt(double x_m, double y_m, double z_m) {
  nav_t nav{};
  nav.x_m = x_m;
  nav.y_m = y_m;
  nav.z_m = z_m;
  nav.speed_over_ground_mps = 2;
  nav.course_over_ground_deg = 90;
  nav.descent_mps = 0.1;
  return nav;
}

GroupState Leader() {
  GroupState state{.own_id = 1, .group_id = 'B', .is_leader = true};
  state.members = {PlacedContact(7, 'B', {.position_m = {10, 20, 30}}),
                   PlacedContact(9, 'B', {.position_m = {-1, -2, 3}})};
  state.members[1].has_reported = true;
  state.members[1].reported_us = 2'500'000;
  return state;
}

TEST(MotionOfNav, IsOverGroundAndDownward) {
  const std::optional<Motion> motion = MotionOf(NavAt(1, 2, 3), {});
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->position_m, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR((motion->velocity_mps - Eigen::Vector3d(2, 0, 0.1)).norm(), 0, 1e-12);
}

TEST(MotionOfNav, IsNothingOutsideTheEncodableRange) {
  EXPECT_FALSE(MotionOf(NavAt(100'001, 0, 0), {}));
  EXPECT_FALSE(MotionOf(NavAt(0, std::numeric_limits<double>::quiet_NaN(), 0), {}));
}

TEST(NextOfALeader, IsItsWaypointAtTheSpeedOfItsPlan) {
  helm_state_t helm{};
  helm.waypoint_index = 0;
  helm.waypoint_x_m = 100;
  helm.waypoint_z_m = 40;
  const Motion own = {.position_m = {0, 0, 40}, .velocity_mps = {0, 2, 0}};
  const Motion next = NextOf(own, helm, {.speed_mps = 2}, {});
  EXPECT_EQ(next.position_m, Eigen::Vector3d(100, 0, 40));
  EXPECT_NEAR((next.velocity_mps - Eigen::Vector3d(2, 0, 0)).norm(), 0, 1e-12);
  const Motion faster = NextOf(own, helm, {.speed_mps = 2, .acceleration_mps2 = 0.01}, {});
  EXPECT_NEAR(faster.velocity_mps.x(), std::sqrt(4 + 2 * 0.01 * 100), 1e-12);
}

TEST(NextOfALeader, IsItselfWithoutAWaypoint) {
  helm_state_t helm{};
  helm.waypoint_index = -1;
  helm.waypoint_x_m = 100;
  const Motion own = {.position_m = {1, 2, 3}, .velocity_mps = {0, 2, 0}};
  EXPECT_EQ(NextOf(own, helm, {.speed_mps = 2}, {}).position_m, own.position_m);
  helm.waypoint_index = 0;
  helm.waypoint_x_m = std::numeric_limits<double>::infinity();
  EXPECT_EQ(NextOf(own, helm, {.speed_mps = 2}, {}).position_m, own.position_m);
}

TEST(SwarmBytesOfAReport, HoldIdPositionAndTime) {
  GroupState state{.own_id = 5, .group_id = 'C'};
  const SwarmMessageInputs inputs = {.own = {.position_m = {1, 2, 3}, .velocity_mps = {4, 5, 6}},
                                     .now_us = 1'500'000,
                                     .state = state};
  for (const auto& [due, flag] : {std::pair(SwarmMessage::kReport, kReportFlag),
                                  std::pair(SwarmMessage::kResponse, kResponseFlag)}) {
    const auto report = DecodeReport(SwarmBytes({.message = due}, inputs));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->flag, flag);
    EXPECT_EQ(report->group_id, 'C');
    EXPECT_EQ(report->reporter_id, 5U);
    EXPECT_EQ(report->position_m, Eigen::Vector3f(1, 2, 3));
    EXPECT_EQ(report->velocity_mps, Eigen::Vector3f(4, 5, 6));
    EXPECT_EQ(report->time_stamp_s, 1.5F);
  }
}

TEST(SwarmBytesOfALeader, HoldItsNextWaypoint) {
  const GroupState state = Leader();
  const SwarmMessageInputs inputs = {.own = {.position_m = {1, 2, 3}},
                                     .next = {.position_m = {9, 8, 7}, .velocity_mps = {1, 0, 0}},
                                     .now_us = 0,
                                     .state = state};
  const auto report =
      DecodeLeaderReport(SwarmBytes({.message = SwarmMessage::kLeaderReport}, inputs));
  ASSERT_TRUE(report);
  EXPECT_EQ(report->leader.next_position_m, Eigen::Vector3f(9, 8, 7));
  EXPECT_EQ(report->leader.next_velocity_mps, Eigen::Vector3f(1, 0, 0));
}

TEST(SwarmBytesOfARequest, HoldAllMembersAndWhenTheFirstAnswers) {
  const GroupState state = Leader();
  const SwarmMessageInputs inputs = {
      .own = {.position_m = {1, 2, 3}}, .now_us = 5'000'000, .state = state};
  const auto request = DecodeBroadcast(SwarmBytes(
      {.message = SwarmMessage::kBroadcastRequest, .response_start_us = 8'200'000}, inputs));
  ASSERT_TRUE(request);
  ASSERT_EQ(request->followers.size(), 2U);
  EXPECT_EQ(request->followers[0].id, 7U);
  EXPECT_EQ(request->followers[0].position_m, Eigen::Vector3f(10, 20, 30));
  EXPECT_EQ(request->followers[0].reported_s, 0) << "it never reported";
  EXPECT_EQ(request->followers[1].id, 9U);
  EXPECT_EQ(request->followers[1].reported_s, 2.5F);
  EXPECT_EQ(request->response_start_s, 8.2F);
}

}  // namespace shoal::swarm_bytes_test
