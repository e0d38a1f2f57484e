// The tasks of underwater vehicles, between the frame of headings and that of the laws.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/task_runner.h"

namespace shoal::auv_task_runners_test {

/// Two legs: North and down, then East on the level.
PathFollowTask TwoLegs(PathTaskEnd end = PathTaskEnd::kDone) {
  PathFollowTask task;
  task.points_m = {{0, 0, 10}, {0, 100, 20}, {100, 100, 20}};
  task.end = end;
  return task;
}

Fix At(const Eigen::Vector3d& position_m, double time_s, double heading_deg = 0) {
  return {.position_m = position_m.head<2>(),
          .heading_rad = DegToRad(heading_deg),
          .time_s = time_s,
          .z_m = position_m.z()};
}

/// A point that follows its guidance exactly, in steps of a second.
class Follower {
 public:
  Follower(const TaskRunner::What& what, const Eigen::Vector3d& start_m)
      : position_m(start_m), runner_(what, At(start_m, 0)) {}

  void Step() {
    guidance = runner_.Update(At(position_m, ++time_s_));
    position_m.head<2>() += guidance.speed_mps * UnitVector(guidance.heading_rad);
    if (guidance.z_m) position_m.z() += std::clamp(*guidance.z_m - position_m.z(), -1.0, 1.0);
  }
  void Run(int num_steps) {
    for (int i = 0; i < num_steps; ++i) Step();
  }

  Eigen::Vector3d position_m;
  Guidance guidance;

 private:
  TaskRunner runner_;
  double time_s_ = 0;
};

TEST(PathFollowRunner, SteersAlongTheLegInTheFrameOfHeadings) {
  Follower follower(TwoLegs(), {0, 5, 10});
  follower.Step();
  EXPECT_NEAR(RadToDeg(WrapPi(follower.guidance.heading_rad)), 0, 1);
  EXPECT_EQ(follower.guidance.speed_mps, 2);
  EXPECT_EQ(follower.guidance.waypoint_m, Eigen::Vector2d(0, 100));
  EXPECT_NEAR(follower.guidance.distance_m, std::hypot(95, 10), 1e-9);
  EXPECT_EQ(follower.guidance.z_m, 20);
  EXPECT_FALSE(follower.guidance.pitch_rad.has_value());
  EXPECT_FALSE(follower.guidance.propeller_rpm.has_value());
}

TEST(PathFollowRunner, CountsTheCrossTrackErrorToStarboard) {
  TaskRunner east(TwoLegs(), At({0, 0, 10}, 0));
  const Guidance to_starboard = east.Update(At({7, 50, 15}, 1));
  EXPECT_NEAR(to_starboard.cross_track_error_m, 7, 1e-9) << "East of a leg to the North";
  EXPECT_GT(to_starboard.heading_rad, kPi) << "back to port";
  TaskRunner west(TwoLegs(), At({0, 0, 10}, 0));
  const Guidance to_port = west.Update(At({-7, 50, 15}, 1));
  EXPECT_NEAR(to_port.cross_track_error_m, -7, 1e-9);
  EXPECT_LT(to_port.heading_rad, kPi / 2);
}

TEST(PathFollowRunner, PassesItsPointsAndIsDone) {
  Follower follower(TwoLegs(), {0, 0, 10});
  follower.Run(40);
  EXPECT_EQ(follower.guidance.waypoint_index, 1);
  follower.Run(40);
  EXPECT_EQ(follower.guidance.waypoint_index, 2);
  EXPECT_NEAR(RadToDeg(follower.guidance.heading_rad), 90, 10);
  EXPECT_FALSE(follower.guidance.done);
  follower.Run(60);
  EXPECT_TRUE(follower.guidance.done);
  EXPECT_EQ(follower.guidance.laps_done, 1);
}

TEST(PathFollowRunner, GoesOnForEverIfAsked) {
  Follower follower(TwoLegs(PathTaskEnd::kGoOn), {0, 0, 10});
  follower.Run(200);
  EXPECT_FALSE(follower.guidance.done);
  EXPECT_EQ(follower.guidance.speed_mps, 2);
  EXPECT_NEAR(RadToDeg(follower.guidance.heading_rad), 90, 1);
  EXPECT_EQ(follower.guidance.laps_done, 1);
  EXPECT_GT(follower.position_m.x(), 150);
}

TEST(PathFollowRunner, HoldsTheLastPointWithoutBeingDone) {
  PathFollowTask task = TwoLegs(PathTaskEnd::kHold);
  task.propeller_rpm = 900;
  Follower follower(task, {0, 0, 10});
  follower.Run(150);
  EXPECT_FALSE(follower.guidance.done);
  EXPECT_EQ(follower.guidance.speed_mps, 0);
  EXPECT_FALSE(follower.guidance.propeller_rpm.has_value()) << "it stands still";
  follower.position_m.x() += 60;  // It has drifted away.
  follower.Step();
  EXPECT_GT(follower.guidance.speed_mps, 0);
  EXPECT_EQ(follower.guidance.propeller_rpm, 900);
  EXPECT_NEAR(RadToDeg(follower.guidance.heading_rad), 270, 20);
}

TEST(PathFollowRunner, BeginsAgainFromItsFirstPoint) {
  Follower follower(TwoLegs(PathTaskEnd::kReturnToFirst), {0, 0, 10});
  follower.Run(600);
  EXPECT_FALSE(follower.guidance.done);
  EXPECT_GE(follower.guidance.laps_done, 2);
}

TEST(PathFollowRunner, ComesUpOnTheLastCourseAndIsDoneAtTheSurface) {
  Follower follower(TwoLegs(PathTaskEnd::kSurface), {0, 0, 10});
  double deepest_done_m = -1;
  for (int i = 0; i < 300 && !follower.guidance.done; ++i) {
    follower.Step();
    deepest_done_m = follower.position_m.z();
  }
  EXPECT_TRUE(follower.guidance.done);
  EXPECT_LT(deepest_done_m, 0.5);
}

TEST(PathFollowRunner, TakesRevolutionsInsteadOfASpeed) {
  PathFollowTask task = TwoLegs();
  task.propeller_rpm = 1100;
  Follower follower(task, {0, 0, 10});
  follower.Step();
  EXPECT_EQ(follower.guidance.propeller_rpm, 1100);
}

TEST(PathFollowRunner, DoesNotCountTheTimeOfAPause) {
  PathFollowTask task = TwoLegs();
  task.crab_gain = 0.01;
  TaskRunner paused(task, At({5, 20, 10}, 0));
  TaskRunner steady(task, At({5, 20, 10}, 0));
  (void)paused.Update(At({5, 20, 10}, 1));
  (void)steady.Update(At({5, 20, 10}, 1));
  paused.Rejoin(At({5, 20, 10}, 1001));
  EXPECT_EQ(paused.Update(At({5, 21, 10}, 1002)).heading_rad,
            steady.Update(At({5, 21, 10}, 2)).heading_rad);
}

TargetTrackTask Following() {
  TargetTrackTask task;
  task.target = "alpha";
  return task;
}

TEST(TargetTrackRunner, StandsStillOnItsHeadingWhileNothingIsKnown) {
  TaskRunner runner(Following(), At({0, 0, 20}, 0, 70));
  Guidance guidance = runner.Update(At({0, 0, 20}, 1, 70));
  EXPECT_EQ(guidance.speed_mps, 0);
  EXPECT_NEAR(RadToDeg(guidance.heading_rad), 70, 1e-9);
  EXPECT_FALSE(guidance.done);
  EXPECT_EQ(guidance.waypoint_index, -1);
  const Surroundings empty;
  Fix fix = At({0, 0, 20}, 2, 70);
  fix.surroundings = &empty;
  guidance = runner.Update(fix);
  EXPECT_EQ(guidance.speed_mps, 0);
  EXPECT_NEAR(RadToDeg(guidance.heading_rad), 70, 1e-9);
}

TEST(TargetTrackRunner, HeadsForATargetThatIsFarAwayBowDownWhereItIsDeeper) {
  Surroundings seen;
  seen.own.position_m = {0, 0, 20};
  seen.target = Neighbour{.id = 1, .position_m = {-400, 0, 60}};
  TaskRunner runner(Following(), At({0, 0, 20}, 0));
  Fix fix = At({0, 0, 20}, 1);
  fix.surroundings = &seen;
  const Guidance guidance = runner.Update(fix);
  EXPECT_NEAR(RadToDeg(guidance.heading_rad), 270, 1) << "it lies to the West";
  EXPECT_GT(guidance.speed_mps, 0.5);
  ASSERT_TRUE(guidance.pitch_rad.has_value());
  EXPECT_LT(*guidance.pitch_rad, -0.01);
  EXPECT_FALSE(guidance.z_m.has_value());
  EXPECT_EQ(guidance.waypoint_m, Eigen::Vector2d(-400, 0));
  EXPECT_NEAR(guidance.distance_m, std::hypot(400, 40), 1e-9);
  EXPECT_EQ(guidance.cross_track_error_m, 0);
}

TEST(TargetTrackRunner, BeginsOnTheCourseThatItHas) {
  Surroundings seen;  // On the spot, at rest: there is no course to go.
  seen.own.position_m = {0, 0, 20};
  seen.target = Neighbour{.id = 1, .position_m = {0, 100, 20}};
  TargetTrackTask task = Following();
  task.track.law = VelocityCascade{{FeedForwardLayer{}}};
  TaskRunner runner(task, At({0, 0, 20}, 0, 130));
  Fix fix = At({0, 0, 20}, 1, 130);
  fix.surroundings = &seen;
  EXPECT_NEAR(RadToDeg(runner.Update(fix).heading_rad), 130, 1e-9);
}

TEST(TargetTrackRunner, TakesTheCurrentOffWhatItWantsOverGroundUnlessTurnedOff) {
  Surroundings seen;
  seen.own.position_m = {0, 0, 20};
  seen.target = Neighbour{.id = 1, .position_m = {0, 100, 20}, .velocity_mps = {0, 1.2, 0}};
  seen.current_mps = {0.5, 0, 0};
  Fix fix = At({0, 0, 20}, 1);
  fix.surroundings = &seen;
  TargetTrackTask task = Following();
  TaskRunner runner(task, At({0, 0, 20}, 0));
  const Guidance guidance = runner.Update(fix);
  EXPECT_NEAR(guidance.speed_mps, 1.3, 1e-9);
  EXPECT_NEAR(RadToDeg(guidance.heading_rad), 360 - RadToDeg(std::atan2(0.5, 1.2)), 1e-9);
  task.compensate_current = false;
  TaskRunner munet(task, At({0, 0, 20}, 0));
  EXPECT_NEAR(munet.Update(fix).speed_mps, 1.2, 1e-9);
  EXPECT_NEAR(RadToDeg(WrapPi(munet.Update(fix).heading_rad)), 0, 1e-9);
}

TEST(TargetTrackRunner, TurnsBeforeAWallWithNoMoreThanTheSpeedAlongTheBowUnlessTurnedOff) {
  Surroundings seen;
  seen.own.position_m = {0, 0, 20};
  seen.target = Neighbour{.id = 1, .position_m = {-100, 0, 20}, .velocity_mps = {-1.5, 0, 0}};
  const std::vector<SonarEcho> wall = {{.direction = {1, 0, 0}, .range_m = 9}};
  Fix fix = At({0, 0, 20}, 1, 90);
  fix.surroundings = &seen;
  TargetTrackTask task = Following();
  EXPECT_GT(TaskRunner(task, fix).Update(fix).speed_mps, 1) << "in open water it turns";
  seen.sonar = wall;
  EXPECT_EQ(TaskRunner(task, fix).Update(fix).speed_mps, 0);
  task.speed_along_bow = false;
  EXPECT_GT(TaskRunner(task, fix).Update(fix).speed_mps, 1);
}

/// A follower at (0, 0, 20) that heads 70 degrees, whose target, 400 m West of it, may be silent.
class SilentLeader {
 public:
  Surroundings seen;

  explicit SilentLeader(SilenceRule rule) : runner_(WithRule(rule), At({0, 0, 20}, 0, 70)) {
    seen.own.position_m = {0, 0, 20};
    seen.target = Neighbour{.id = 1, .position_m = {-400, 0, 20}};
  }

  Guidance Update(bool is_silent, const Eigen::Vector3d& position_m = {0, 0, 20}) {
    seen.target_is_silent = is_silent;
    Fix fix = At(position_m, ++time_s_, 70);
    fix.surroundings = &seen;
    return runner_.Update(fix);
  }

 private:
  static TargetTrackTask WithRule(SilenceRule rule) {
    TargetTrackTask task = Following();
    task.swarm = SwarmKnowledge::kAcoustic;
    task.on_silence = rule;
    return task;
  }

  TaskRunner runner_;
  double time_s_ = 0;
};

TEST(TargetTrackRunner, GoesOnWithThePredictionOfASilentTargetByDefault) {
  SilentLeader follower(SilenceRule::kPredict);
  EXPECT_EQ(follower.Update(true).heading_rad, follower.Update(false).heading_rad);
  EXPECT_GT(follower.Update(true).speed_mps, 0.5);
}

TEST(TargetTrackRunner, StaysAtItsPlaceAndDepthWhileTheTargetIsSilentIfSetSo) {
  SilentLeader follower(SilenceRule::kStationKeep);
  EXPECT_GT(follower.Update(false).speed_mps, 0.5);
  const Guidance there = follower.Update(true);
  EXPECT_EQ(there.speed_mps, 0);
  EXPECT_EQ(there.z_m, 20);
  EXPECT_FALSE(there.pitch_rad.has_value());
  const Guidance drifted = follower.Update(true, {50, 0, 25});
  EXPECT_GT(drifted.speed_mps, 0);
  EXPECT_NEAR(RadToDeg(drifted.heading_rad), 270, 1) << "back to where it was";
  EXPECT_EQ(drifted.z_m, 20);
  EXPECT_GT(follower.Update(false).speed_mps, 0.5) << "the target reports again: it follows";
  EXPECT_EQ(follower.Update(true, {7, 7, 30}).z_m, 30) << "the next silence is another";
}

TEST(TargetTrackRunner, KeepsClearOfThoseItReceivesWhileItStays) {
  SilentLeader follower(SilenceRule::kStationKeep);
  std::vector<Neighbour> group = {{.id = 2, .position_m = {0, 12, 20}}};
  follower.seen.group = group;
  const Guidance away = follower.Update(true);
  EXPECT_GT(away.speed_mps, 1);
  EXPECT_NEAR(RadToDeg(away.heading_rad), 180, 1) << "it is North of here";
  group[0].is_silent = true;
  EXPECT_EQ(follower.Update(true).speed_mps, 0) << "its position is unknown";
}

TEST(TargetTrackRunner, ComesUpOnItsHeadingWhileTheTargetIsSilentIfSetSo) {
  SilentLeader follower(SilenceRule::kSurface);
  const Guidance rising = follower.Update(true);
  EXPECT_EQ(rising.z_m, 0);
  EXPECT_GT(rising.speed_mps, 1);
  EXPECT_NEAR(RadToDeg(rising.heading_rad), 70, 1e-9);
  EXPECT_EQ(follower.Update(true, {60, 20, 0.3}).speed_mps, 0) << "it is up";
}

/// A follower whose target comes up and leaves again; the water moves East at 0.4 m/s.
class TargetThatComesUp {
 public:
  explicit TargetThatComesUp(TargetEndRule rule) : runner_(WithRule(rule), At({0, 0, 20}, 0, 70)) {
    seen.own.position_m = {0, 0, 20};
    seen.current_mps = {0.4, 0, 0};
  }

  Guidance Update(double target_z_m, double target_mps, double for_s = 11) {
    seen.target = Neighbour{
        .id = 1, .position_m = {-400, 0, target_z_m}, .velocity_mps = {0.4 + target_mps, 0, 0}};
    Guidance guidance;
    for (int i = 0; i < static_cast<int>(for_s); ++i) {
      Fix fix = At(seen.own.position_m, ++time_s_, 70);
      fix.surroundings = &seen;
      guidance = runner_.Update(fix);
    }
    return guidance;
  }

  Surroundings seen;

 private:
  static TargetTrackTask WithRule(TargetEndRule rule) {
    TargetTrackTask task = Following();
    task.on_target_end = rule;
    return task;
  }

  TaskRunner runner_;
  double time_s_ = 0;
};

TEST(TargetTrackRunner, ComesUpAndDriftsWhenItsTargetRestsAtTheSurface) {
  TargetThatComesUp follower(TargetEndRule::kSurface);
  EXPECT_TRUE(follower.Update(20, 1.5).pitch_rad.has_value());
  EXPECT_TRUE(follower.Update(0.2, 1.5).pitch_rad.has_value()) << "it is up, but under way";
  EXPECT_TRUE(follower.Update(0.2, 0.1, 5).pitch_rad.has_value()) << "for no more than 5 s";
  const Guidance rising = follower.Update(0.2, 0.1);
  EXPECT_EQ(rising.z_m, 0);
  EXPECT_GT(rising.speed_mps, 1);
  EXPECT_FALSE(rising.done);
  follower.seen.own.position_m.z() = 0.3;
  EXPECT_EQ(follower.Update(0.2, 0.1).speed_mps, 0);
  EXPECT_EQ(follower.Update(0.2, 0.4).speed_mps, 0) << "still slow";
  EXPECT_TRUE(follower.Update(0.2, 1.5).pitch_rad.has_value()) << "it has left";
}

TEST(TargetTrackRunner, FollowsATargetThatWasNeverUnderWater) {
  TargetThatComesUp follower(TargetEndRule::kSurface);
  EXPECT_TRUE(follower.Update(0, 0, 60).pitch_rad.has_value());
}

TEST(TargetTrackRunner, KeepsClearOfTargetAndGroupWhileItIsAtTheSurface) {
  TargetThatComesUp follower(TargetEndRule::kSurface);
  follower.Update(20, 1.5);
  follower.seen.own.position_m = {-400, 15, 0.3};
  const Guidance from_target = follower.Update(0.2, 0.1);
  EXPECT_GT(from_target.speed_mps, 0.5);
  EXPECT_NEAR(RadToDeg(from_target.heading_rad), 0, 1) << "the target is South of it";
  follower.seen.own.position_m = {-400, 100, 0.3};
  EXPECT_EQ(follower.Update(0.2, 0.1).speed_mps, 0);
}

TEST(TargetTrackRunner, DoesOtherwiseWhenItsTargetRestsIfSetSo) {
  TargetThatComesUp holds(TargetEndRule::kHold);
  holds.Update(20, 1.5);
  const Guidance there = holds.Update(0.2, 0.1);
  EXPECT_EQ(there.z_m, 20);
  EXPECT_EQ(there.speed_mps, 0);
  TargetThatComesUp goes_on(TargetEndRule::kGoOn);
  goes_on.Update(20, 1.5);
  EXPECT_TRUE(goes_on.Update(0.2, 0.1).pitch_rad.has_value());
  TargetThatComesUp is_done(TargetEndRule::kDone);
  EXPECT_FALSE(is_done.Update(20, 1.5).done);
  EXPECT_TRUE(is_done.Update(0.2, 0.1).done);
}

TEST(PathFollowRunner, CirclesItsLastPointAtItsDepthIfAsked) {
  PathFollowTask task = TwoLegs(PathTaskEnd::kLoiter);
  task.loiter_radius_m = 30;
  task.propeller_rpm = 900;
  Follower follower(task, {0, 0, 10});
  follower.Run(300);
  EXPECT_FALSE(follower.guidance.done);
  EXPECT_EQ(follower.guidance.laps_done, 1);
  EXPECT_EQ(follower.guidance.z_m, task.points_m.back().z());
  EXPECT_EQ(follower.guidance.propeller_rpm, 900);
  for (int i = 0; i < 100; ++i) {
    follower.Step();
    EXPECT_NEAR((follower.position_m - task.points_m.back()).head<2>().norm(), 30, 8);
  }
}

RC_GTEST_PROP(AuvTaskRunners, ReturnFiniteNumbersWhereverTheyAre, ()) {
  const auto coordinate = [] {
    return *rc::gen::element(0.0, 1.0, -50.0, 1e6, -1e6, 1e-300, 333.3);
  };
  const auto place = [&] {
    return Eigen::Vector3d(coordinate(), coordinate(), std::abs(coordinate()));
  };
  const bool follows_path = *rc::gen::arbitrary<bool>();
  TaskRunner::What what = Following();
  if (follows_path) {
    PathFollowTask task;
    task.end = *rc::gen::element(PathTaskEnd::kDone, PathTaskEnd::kGoOn, PathTaskEnd::kHold,
                                 PathTaskEnd::kReturnToFirst, PathTaskEnd::kSurface);
    for (int i = *rc::gen::inRange(1, 5); i > 0; --i) task.points_m.push_back(place());
    what = task;
  }
  TaskRunner runner(what, At(place(), 0));
  for (int i = 1; i < 20; ++i) {
    Surroundings seen;
    seen.own.position_m = place();
    seen.own.velocity_mps = {*rc::gen::element(0.0, 1000.0, -1.0), 0, 0};
    if (*rc::gen::arbitrary<bool>()) seen.target = Neighbour{.id = 1, .position_m = place()};
    const std::vector<Neighbour> group = {{.id = 2, .position_m = place()}};
    seen.group = group;
    seen.current_mps = {*rc::gen::element(0.0, 1000.0, -0.3), 0.1, 0};
    Fix fix = At(seen.own.position_m, i);
    fix.surroundings = &seen;
    const Guidance guidance = runner.Update(fix);
    RC_ASSERT(guidance.heading_rad >= 0 && guidance.heading_rad < 2 * kPi);
    RC_ASSERT(std::isfinite(guidance.speed_mps) && guidance.speed_mps >= 0);
    RC_ASSERT(std::isfinite(guidance.z_m.value_or(0)));
    RC_ASSERT(std::abs(guidance.pitch_rad.value_or(0)) <= kPi / 2);
    RC_ASSERT(std::isfinite(guidance.distance_m));
    RC_ASSERT(std::isfinite(guidance.cross_track_error_m));
    RC_ASSERT(guidance.waypoint_m.allFinite());
  }
}

}  // namespace shoal::auv_task_runners_test
