// Adaptive line of sight on a vehicle with inertia, fins and a current that it cannot see.
#include <gtest/gtest.h>

#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/guidance/path_follower.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"

namespace shoal::track_in_current_test {

constexpr double kStep_s = 0.02;
constexpr double kCross_mps = 0.5;
constexpr double kSettled_s = 700;
constexpr double kEnd_s = 800;

struct CrossCurrent {
  double path_rad = 0;  ///< Where the path goes to; the current sets 90 degrees to port of it.
  double set = 1;       ///< -1: to starboard.
  double speed_mps = 2;
  bool guard_crab = true;
};

/// What is left once the crab angle has been learnt.
struct Steady {
  double worst_y_e_m = 0;
  double worst_crab_error_rad = 0;
};

Steady Follow(const Remus100Params& params, const CrossCurrent& sea) {
  const Remus100 auv = BuildRemus100(params);
  const Eigen::Vector3d along(std::cos(sea.path_rad), std::sin(sea.path_rad), 0);
  const Eigen::Vector3d port(-along.y(), along.x(), 0);
  const Remus100Environment water = {.current_mps = sea.set * kCross_mps * port};
  const double rpm = RpmForSpeed(auv, sea.speed_mps);
  Remus100State state;
  state.eta << 0, 0, 20, 0, 0, sea.path_rad;
  AuvPilot pilot(DefaultRemusPilot());
  pilot.Start(sea.path_rad, 20);
  const Eigen::Vector3d start_m(0, 0, 20);
  PathFollower follower({.path = {{start_m, start_m + 5000 * along}}, .guard_crab = sea.guard_crab},
                        start_m);
  Steady steady;
  for (double time_s = 0; time_s < kEnd_s; time_s += kStep_s) {
    const PathGuidance guidance = follower.Update(state.eta.head<3>(), kStep_s);
    if (time_s > kSettled_s) {
      // By which angle the track is turned from the bow: what ALOS is to find out.
      const double course_rad = std::atan2(state.velocity_mps.y(), state.velocity_mps.x());
      const double crab_rad = WrapPi(course_rad - state.eta[5]);
      steady.worst_y_e_m = std::max(steady.worst_y_e_m, std::abs(guidance.y_e_m));
      steady.worst_crab_error_rad =
          std::max(steady.worst_crab_error_rad, std::abs(guidance.crab_rad - crab_rad));
    }
    const AuvMotion motion = {.z_m = state.eta[2],
                              .theta_rad = state.eta[4],
                              .psi_rad = state.eta[5],
                              .q_radps = state.nu[4],
                              .r_radps = state.nu[5],
                              .speed_mps = sea.speed_mps};
    const AuvDeflections fins =
        pilot.KeepHeadingAndDepth(motion, guidance.psi_ref_rad, guidance.z_m, {}, kStep_s);
    state = Step(auv, state, {fins.rudder_rad, fins.stern_plane_rad, rpm}, water, kStep_s);
  }
  return steady;
}

void ExpectOnTrack(const Remus100Params& params, const CrossCurrent& sea) {
  const Steady steady = Follow(params, sea);
  EXPECT_LT(steady.worst_y_e_m, 1);
  EXPECT_LT(RadToDeg(steady.worst_crab_error_rad), 1);
}

TEST(TrackInACrossCurrent, IsKeptWithinAMetreAndTheCrabAngleKnownWithinADegree) {
  ExpectOnTrack({}, {.path_rad = 0});
}

TEST(TrackInACrossCurrent, IsKeptOnAnyCourseWithTheCurrentFromEitherSide) {
  ExpectOnTrack({}, {.path_rad = 2.5, .set = -1});
}

TEST(TrackInACrossCurrent, IsKeptBySlowVehicles) { ExpectOnTrack({}, {.speed_mps = 1.4}); }

TEST(TrackInACrossCurrent, IsKeptByTheBareLawToo) { ExpectOnTrack({}, {.guard_crab = false}); }

TEST(TrackInACrossCurrent, IsKeptByTheRemusOfFossen) { ExpectOnTrack(FossenRemus100(), {}); }

}  // namespace shoal::track_in_current_test
