#include "lib/mission/track/replay_track.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"

namespace shoal::replay_track_test {

constexpr int64_t kSecond_us = 1'000'000;

ReplayFix Fix(double time_s, double x_m, double y_m, double z_m = 0) {
  return {.time_us = Microseconds(time_s), .position_m = {x_m, y_m, z_m}};
}

double HeadingDegAt(const ReplayTrack& track, double time_s) {
  return RadToDeg(track.At(Microseconds(time_s)).heading_rad);
}

TEST(ReplayTrack, GoesStraightAndSteadilyBetweenItsPoints) {
  const ReplayTrack track({Fix(10, 0, 0), Fix(20, 30, 40, 5)}, {});
  const ReplayState state = track.At(12 * kSecond_us);
  EXPECT_LT((state.position_m - Eigen::Vector3d(6, 8, 1)).norm(), 1e-12);
  EXPECT_NEAR(state.speed_mps, 5, 1e-12);
  EXPECT_NEAR(state.descent_mps, 0.5, 1e-12);
  EXPECT_NEAR(RadToDeg(state.course_rad), RadToDeg(std::atan2(30, 40)), 1e-9);
  EXPECT_NEAR(state.heading_rad, state.course_rad, 1e-12);
}

TEST(ReplayTrack, LiesStillBeforeItsFirstPointAndBehindItsLast) {
  const ReplayTrack track({Fix(10, 1, 2), Fix(20, 1, 12)}, {});
  EXPECT_EQ(track.At(0).position_m, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(track.At(0).speed_mps, 0);
  EXPECT_EQ(track.At(20 * kSecond_us).position_m, Eigen::Vector3d(1, 12, 0));
  EXPECT_EQ(track.At(20 * kSecond_us).speed_mps, 0);
  EXPECT_EQ(track.At(INT64_MAX).position_m, Eigen::Vector3d(1, 12, 0));
  EXPECT_EQ(track.At(INT64_MIN).position_m, Eigen::Vector3d(1, 2, 0));
}

TEST(ReplayTrack, TurnsSteadilyThroughTheMeanOfTheWaysThatMeet) {
  // East, then North: at the corner it heads North-East.
  const ReplayTrack track({Fix(0, 0, 0), Fix(10, 10, 0), Fix(20, 10, 10)}, {});
  EXPECT_NEAR(HeadingDegAt(track, 0), 90, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 5), 67.5, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 10), 45, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 20), 0, 1e-9);
  EXPECT_NEAR(RadToDeg(track.At(5 * kSecond_us).course_rad), 90, 1e-9) << "the way itself is East";
  EXPECT_NEAR(RadToDeg(track.At(5 * kSecond_us).turn_radps), -4.5, 1e-9);
}

TEST(ReplayTrack, TakesHeadingsTheShortWayAcrossNorth) {
  std::vector<ReplayFix> fixes = {Fix(0, 0, 0), Fix(10, 0, 10)};
  fixes[0].heading_rad = DegToRad(350);
  fixes[1].heading_rad = DegToRad(20);
  const ReplayTrack track(fixes, {.heading = true});
  EXPECT_NEAR(HeadingDegAt(track, 2), 356, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 5), 5, 1e-9);
  EXPECT_NEAR(RadToDeg(track.At(5 * kSecond_us).course_rad), 0, 1e-9);
}

TEST(ReplayTrack, TakesSpeedsAsRecorded) {
  std::vector<ReplayFix> fixes = {Fix(0, 0, 0), Fix(10, 0, 10)};
  fixes[0].speed_mps = 2;
  fixes[1].speed_mps = 4;
  EXPECT_NEAR(ReplayTrack(fixes, {.speed = true}).At(5 * kSecond_us).speed_mps, 3, 1e-12);
  EXPECT_NEAR(ReplayTrack(fixes, {}).At(5 * kSecond_us).speed_mps, 1, 1e-12);
}

TEST(ReplayTrack, TakesHeadingsAndSpeedsThatAreUnknownFromItsPoints) {
  std::vector<ReplayFix> fixes = {Fix(0, 0, 0), Fix(10, 10, 0), Fix(20, 10, 10), Fix(30, 10, 20)};
  const double unknown = std::nan("");
  fixes[0].heading_rad = unknown;
  fixes[1].heading_rad = DegToRad(180);
  fixes[2].heading_rad = unknown;
  fixes[3].heading_rad = unknown;
  fixes[0].speed_mps = 3;
  fixes[1].speed_mps = 5;
  fixes[2].speed_mps = unknown;
  fixes[3].speed_mps = 7;
  const ReplayTrack track(fixes, {.heading = true, .speed = true});
  EXPECT_NEAR(HeadingDegAt(track, 0), 90, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 10), 180, 1e-9) << "as recorded";
  EXPECT_NEAR(HeadingDegAt(track, 20), 0, 1e-9);
  EXPECT_NEAR(HeadingDegAt(track, 30), 0, 1e-9);
  EXPECT_NEAR(track.At(5 * kSecond_us).speed_mps, 4, 1e-12);
  EXPECT_NEAR(track.At(15 * kSecond_us).speed_mps, 1, 1e-12);
  EXPECT_NEAR(track.At(25 * kSecond_us).speed_mps, 1, 1e-12);
}

TEST(ReplayTrack, KeepsItsHeadingWhileItLiesStill) {
  const ReplayTrack track(
      {Fix(0, 0, 0), Fix(10, 0, 0), Fix(20, -10, 0), Fix(30, -10, 0), Fix(40, -10, 0)}, {});
  EXPECT_NEAR(HeadingDegAt(track, 3), 270, 1e-9) << "where it will go first";
  EXPECT_NEAR(HeadingDegAt(track, 35), 270, 1e-9);
  EXPECT_EQ(track.At(35 * kSecond_us).speed_mps, 0);
  EXPECT_NEAR(RadToDeg(track.At(35 * kSecond_us).course_rad), 270, 1e-9);
}

TEST(ReplayTrack, OfOnePointStaysThere) {
  const ReplayTrack track({Fix(5, 3, 4)}, {});
  for (const int64_t time_us : {int64_t{0}, 5 * kSecond_us, 9 * kSecond_us}) {
    EXPECT_EQ(track.At(time_us).position_m, Eigen::Vector3d(3, 4, 0));
    EXPECT_EQ(track.At(time_us).heading_rad, 0);
  }
}

TEST(ReplayTrack, ThatTurnsBackHasAHeadingAllTheSame) {
  const ReplayTrack track({Fix(0, 0, 0), Fix(10, 0, 10), Fix(20, 0, 0)}, {});
  EXPECT_NEAR(HeadingDegAt(track, 10), 180, 1e-9);
}

RC_GTEST_PROP(ReplayTrack, IsContinuousAndStaysBetweenItsPoints, ()) {
  std::vector<ReplayFix> fixes;
  int64_t time_us = 0;
  for (int i = *rc::gen::inRange(1, 12); i > 0; --i) {
    time_us += *rc::gen::inRange<int64_t>(1, 5'000'000);
    const double x_m = *rc::gen::inRange(-1000, 1000);
    const double y_m = *rc::gen::inRange(-1000, 1000);
    fixes.push_back({.time_us = time_us, .position_m = {x_m, y_m, 0}});
  }
  const ReplayTrack track(fixes, {});
  const int64_t at_us = *rc::gen::inRange<int64_t>(-1'000'000, time_us + 1'000'000);
  const ReplayState state = track.At(at_us);
  const ReplayState next = track.At(at_us + 1);
  // A microsecond at the speed of either side, and what rounding adds.
  const double reach_m = 1e-6 * std::max(state.speed_mps, next.speed_mps) + 1e-8;
  RC_ASSERT((next.position_m - state.position_m).norm() <= reach_m);
  RC_ASSERT(state.position_m.cwiseAbs().maxCoeff() <= 1000);
  RC_ASSERT(state.heading_rad >= 0 && state.heading_rad < 2 * kPi);
}

}  // namespace shoal::replay_track_test
