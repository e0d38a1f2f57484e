// No NaN and no infinity leaves lib/vehicle/control for any finite input.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "lib/vehicle/control/auv_pilot.h"
#include "lib/vehicle/control/heading_pid.h"
#include "lib/vehicle/control/speed_controller.h"
#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::finite_control_test {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

AuvMotion AnyMotion() {
  return {.z_m = AnyFinite(),
          .theta_rad = AnyFinite(),
          .psi_rad = AnyFinite(),
          .q_radps = AnyFinite(),
          .r_radps = AnyFinite(),
          .speed_mps = AnyFinite(),
          .is_driven = *rc::gen::arbitrary<bool>()};
}

RC_GTEST_PROP(FiniteControl, AuvPilotsStayWithinTheirFinsInAnyMotion, ()) {
  const AuvPilotParams params = *rc::gen::element(DefaultRemusPilot(), MunetRemusPilot());
  AuvPilot pilot(params);
  pilot.Start(AnyFinite(), AnyFinite());
  for (int i = 0; i < 10; ++i) {
    const double dt_s = DrawBetween(1e-6, 1);
    const DepthBound bound = {.now_m = *rc::gen::element(AnyFinite(), kInfinity),
                              .soon_m = *rc::gen::element(AnyFinite(), kInfinity),
                              .later_m = *rc::gen::element(AnyFinite(), kInfinity)};
    const AuvDeflections fins =
        *rc::gen::arbitrary<bool>()
            ? pilot.KeepHeadingAndDepth(AnyMotion(), AnyFinite(), AnyFinite(), bound, dt_s)
            : pilot.KeepHeadingAndPitch(AnyMotion(), AnyFinite(), AnyFinite(), bound, dt_s);
    RC_ASSERT(std::abs(fins.rudder_rad) <= params.heading.max_output_rad);
    RC_ASSERT(std::abs(fins.stern_plane_rad) <= params.pitch.max_output_rad);
    RC_ASSERT(std::isfinite(pilot.desired_psi_rad()));
    RC_ASSERT(std::isfinite(pilot.desired_yaw_rate_radps()));
    RC_ASSERT(std::isfinite(pilot.desired_z_m()));
    RC_ASSERT(std::isfinite(pilot.desired_theta_rad()));
  }
}

RC_GTEST_PROP(FiniteControl, FiltersAndRampsAreFiniteForAnyCommand, ()) {
  DepthFilter filter{.z_d_m = AnyFinite()};
  for (int i = 0; i < 5; ++i) {
    const DepthFilterParams params{.time_s = DrawBetween(1e-3, 100),
                                   .settles_per_step = *rc::gen::arbitrary<bool>()};
    RC_ASSERT(std::isfinite(filter.Update(params, AnyFinite(), std::abs(AnyFinite()))));
  }
  const double limited_m = LimitDepth(AnyFinite(), {}, *rc::gen::element(AnyFinite(), kInfinity));
  RC_ASSERT(limited_m >= 0 && limited_m <= DepthLimits().max_z_m);
  const double rate_rpmps = *rc::gen::element(std::abs(AnyFinite()), kInfinity);
  RC_ASSERT(std::isfinite(RampRpm(AnyFinite(), AnyFinite(), rate_rpmps, DrawBetween(1e-6, 1e6))));
}

RC_GTEST_PROP(FiniteControl, SurfaceAutopilotsStayWithinTheirActuatorsForAnyMotion, ()) {
  HeadingPid heading({.kp = 1.2, .ki = 0.02, .kd = 0.6});
  SpeedController speed({.kp = 5, .ki = 2, .integral_limit_pct = 20, .acceleration_mps2 = 0.5});
  for (int i = 0; i < 10; ++i) {
    const double dt_s = std::abs(AnyFinite());
    RC_ASSERT(std::abs(heading.Update(AnyFinite(), AnyFinite(), AnyFinite(), dt_s)) <= 100);
    const double thrust_pct = speed.Update(AnyFinite(), AnyFinite(), AnyFinite(), dt_s);
    RC_ASSERT(thrust_pct >= 0 && thrust_pct <= 100);
  }
}

}  // namespace shoal::finite_control_test
