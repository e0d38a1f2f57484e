// A Remus 100 on paths of every shape, as a helm flies them: guidance, autopilot and vehicle.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/guidance/task_runner.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::shaped_paths_test {

constexpr double kTick_s = 0.1;
constexpr int kStepsPerTick = 5;

/// What is seen of one tick.
struct Moment {
  double time_s = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Guidance guidance;
};

/// A vehicle under way at 2 m/s that follows a path until it is done, or for a time.
class Flight {
 public:
  Flight(const PathFollowTask& task, const Eigen::Vector3d& position_m, double heading_deg,
         const Eigen::Vector3d& current_mps = Eigen::Vector3d::Zero())
      : psi_rad_(PsiFromHeading(DegToRad(heading_deg))), current_mps_(current_mps) {
    state_.eta << position_m, 0, 0, psi_rad_;
    state_.nu[0] = task.speed_mps;
    rpm_ = RpmForSpeed(auv_, task.speed_mps);
    state_.actuators.propeller_rpm = rpm_;
    pilot_.Start(psi_rad_, position_m.z());
    runner_.emplace(task, FixAt(0));
  }

  std::vector<Moment> Fly(double most_s) {
    std::vector<Moment> moments;
    for (double time_s = 0; time_s < most_s; time_s += kTick_s) {
      const Guidance guidance = runner_->Update(FixAt(time_s));
      moments.push_back({time_s, state_.eta.head<3>(), guidance});
      if (guidance.done) break;
      Steer(guidance);
    }
    return moments;
  }

 private:
  Fix FixAt(double time_s) const {
    return {.position_m = state_.eta.head<2>(),
            .heading_rad = HeadingFromPsi(state_.eta[5]),
            .time_s = time_s,
            .z_m = state_.eta[2],
            .velocity_mps = velocity_mps_.head<2>()};
  }

  void Steer(const Guidance& guidance) {
    const AuvMotion motion{.z_m = state_.eta[2],
                           .theta_rad = state_.eta[4],
                           .psi_rad = state_.eta[5],
                           .q_radps = state_.nu[4],
                           .r_radps = state_.nu[5],
                           .speed_mps = state_.nu[0]};
    std::optional<double> path_pitch_rad;
    if (guidance.z_rate_mps) {
      path_pitch_rad = PitchOfDescent(*guidance.z_rate_mps, state_.nu[0]);
    }
    const AuvDeflections fins =
        pilot_.KeepHeadingAndDepth(motion, PsiFromHeading(guidance.heading_rad),
                                   guidance.z_m.value_or(0), {}, kTick_s, path_pitch_rad);
    const Remus100Actuators command{fins.rudder_rad, fins.stern_plane_rad, rpm_};
    const Eigen::Vector3d before_m = state_.eta.head<3>();
    for (int i = 0; i < kStepsPerTick; ++i) {
      state_ = Step(auv_, state_, command, {.current_mps = current_mps_}, kTick_s / kStepsPerTick);
    }
    velocity_mps_ = (state_.eta.head<3>() - before_m) / kTick_s;
  }

  Remus100 auv_ = BuildRemus100({});
  AuvPilot pilot_{DefaultRemusPilot()};
  double psi_rad_;
  Eigen::Vector3d current_mps_;
  Remus100State state_;
  double rpm_ = 0;
  Eigen::Vector3d velocity_mps_ = Eigen::Vector3d::Zero();
  std::optional<PathFollowRunner> runner_;
};

/// Returns the depths at which a flight turned from down to up or back, after its first 20 s.
std::vector<double> TurningDepths(const std::vector<Moment>& moments) {
  std::vector<double> depths_m;
  for (size_t i = 1; i + 1 < moments.size(); ++i) {
    const double z_m = moments[i].position_m.z();
    const bool is_least =
        z_m < moments[i - 1].position_m.z() && z_m <= moments[i + 1].position_m.z();
    const bool is_most =
        z_m > moments[i - 1].position_m.z() && z_m >= moments[i + 1].position_m.z();
    if (moments[i].time_s > 20 && (is_least || is_most)) depths_m.push_back(z_m);
  }
  return depths_m;
}

PathFollowTask YoyoTask(DepthRule rule) {
  PathFollowTask task;
  task.parts = {{.what = YoyoPart{.start_m = {{0, 0, 5}}, .to_m = {1500, 0}}}};
  task.depth_rule = rule;
  task.end = PathTaskEnd::kGoOn;
  return task;
}

double WorstTurningPoint_m(const std::vector<double>& depths_m) {
  double worst_m = 0;
  for (const double z_m : depths_m) {
    worst_m = std::max(worst_m, std::abs(z_m - (z_m > 22.5 ? 40 : 5)));
  }
  return worst_m;
}

TEST(Yoyo, TurnsWithinHalfAMetreOfItsDepthsOnTheSlope) {
  for (const double current_mps : {0.0, 0.4}) {
    Flight flight(YoyoTask(DepthRule::kSlope), {0, 0, 5}, 90, {0, current_mps, 0});
    const std::vector<double> depths_m = TurningDepths(flight.Fly(600));
    EXPECT_GE(depths_m.size(), 8U);
    EXPECT_LT(WorstTurningPoint_m(depths_m), 0.5);
  }
}

TEST(Yoyo, TurnsEarlyWithTheDepthOfTheNextPointBehindAFilter) {
  Flight flight(YoyoTask(DepthRule::kNext), {0, 0, 5}, 90);
  const std::vector<double> depths_m = TurningDepths(flight.Fly(600));
  EXPECT_GE(depths_m.size(), 8U);
  EXPECT_GT(WorstTurningPoint_m(depths_m), 1) << "which the slope is better than";
}

TEST(Helix, KeepsItsRadiusAndItsDepth) {
  for (const double current_mps : {0.0, 0.3}) {
    PathFollowTask task;
    task.parts = {{.what = HelixPart{}}};
    task.depth_rule = DepthRule::kSlope;
    Flight flight(task, {0, 50, 5}, 95, {0, current_mps, 0});
    const std::vector<Moment> moments = flight.Fly(900);
    EXPECT_TRUE(moments.back().guidance.done);
    double worst_radius_m = 0;
    double worst_depth_m = 0;
    for (const Moment& moment : moments) {
      if (moment.time_s < 20) continue;
      worst_radius_m = std::max(worst_radius_m, std::abs(moment.position_m.head<2>().norm() - 50));
      worst_depth_m =
          std::max(worst_depth_m, std::abs(moment.position_m.z() - *moment.guidance.z_m));
    }
    EXPECT_LT(worst_radius_m, current_mps > 0 ? 2 : 1);
    EXPECT_LT(worst_depth_m, 0.25);
    EXPECT_NEAR(moments.back().position_m.z(), 40, 1);
  }
}

double Overshoot_m(double turn_radius_m) {
  PathFollowTask task;
  task.points_m = {{0, 0, 20}, {300, 0, 20}, {300, 300, 20}};
  task.turn_radius_m = turn_radius_m;
  double beyond_m = 0;
  for (const Moment& moment : Flight(task, {0, 0, 20}, 90).Fly(280)) {
    beyond_m = std::max(beyond_m, moment.position_m.x() - 300);
  }
  return beyond_m;
}

TEST(Corner, IsOvershotWhereItIsTurnedAtTenMetresAndNotWhereItIsRound) {
  EXPECT_GT(Overshoot_m(0), 8);
  EXPECT_LT(Overshoot_m(25), 1.5);
  EXPECT_LT(Overshoot_m(30), 0.5);
}

TEST(PathThatIsFarAway, IsFlownToAndThenAlong) {
  PathFollowTask task;
  task.points_m = {{0, 300, 20}, {300, 300, 20}};
  const std::vector<Moment> moments = Flight(task, {0, 0, 20}, 90).Fly(600);
  ASSERT_TRUE(moments.back().guidance.done);
  EXPECT_GT(moments.back().time_s, 600 / 2.1) << "300 m there and 300 m along it";
  EXPECT_LT((moments.back().position_m - Eigen::Vector3d(300, 300, 20)).norm(), 12);
  const auto joined = std::find_if(moments.begin(), moments.end(), [](const Moment& moment) {
    return moment.guidance.waypoint_index == 1;
  });
  ASSERT_NE(joined, moments.end());
  EXPECT_LT((joined->position_m - Eigen::Vector3d(0, 300, 20)).head<2>().norm(), 12);
}

TEST(PathThatIsFarAway, IsNotPassedAbeamOfItWithoutAnApproachEither) {
  PathFollowTask task;
  task.points_m = {{-300, 300, 20}, {-100, 300, 20}};
  task.approach = false;
  const std::vector<Moment> moments = Flight(task, {0, 0, 20}, 90).Fly(600);
  EXPECT_GT(moments.back().time_s, 60);
  EXPECT_LT(std::abs(moments.back().guidance.cross_track_error_m), 51);
}

}  // namespace shoal::shaped_paths_test
