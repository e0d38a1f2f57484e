// No NaN and no infinity leaves lib/vehicle/vehicle for any finite input; Step of the Remus has its
// own test beside it.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "lib/vehicle/guidance/vectors_testing.h"
#include "lib/vehicle/vehicle/attitude.h"
#include "lib/vehicle/vehicle/propulsion.h"
#include "lib/vehicle/vehicle/remus100.h"
#include "lib/vehicle/vehicle/surface_craft.h"

namespace shoal::finite_vehicle_test {

Vector6d AnyFiniteSix() {
  Vector6d six;
  six << AnyFiniteVector(), AnyFiniteVector();
  return six;
}

const Remus100& AnyRemus() {
  static const std::vector<Remus100> auvs = {BuildRemus100({}), BuildRemus100(MunetRemus100()),
                                             BuildRemus100(FossenRemus100())};
  return auvs[*rc::gen::inRange<size_t>(0, auvs.size())];
}

RC_GTEST_PROP(FiniteVehicle, ForcesAreFiniteInAnyMotion, ()) {
  const Remus100& auv = AnyRemus();
  const CrossFlowForce cross_flow = CrossFlowDrag(auv.cross_flow, AnyFinite(), AnyFinite());
  RC_ASSERT(std::isfinite(cross_flow.sway_n) && std::isfinite(cross_flow.yaw_nm));
  const LiftDragForce wing = LiftDrag(auv.wing, AnyFinite(), AnyFinite());
  RC_ASSERT(std::isfinite(wing.surge_n) && std::isfinite(wing.heave_n));
  RC_ASSERT(CoriolisMatrix(auv.mass, AnyFiniteSix()).allFinite());
  RC_ASSERT(Restoring(auv.submerged, AnyFinite(), AnyFinite()).allFinite());
  const double share = SubmergedShare(AnyFinite(), auv.params.diameter_m);
  RC_ASSERT(share >= 0 && share <= 1);
}

RC_GTEST_PROP(FiniteVehicle, AttitudesAreFiniteAtAnyAngles, ()) {
  RC_ASSERT(BodyToWorld(AnyFinite(), AnyFinite(), AnyFinite()).allFinite());
  RC_ASSERT(BodyRatesToEulerRates(AnyFinite(), AnyFinite()).allFinite());
  RC_ASSERT(NormalizeEuler(AnyFiniteVector()).allFinite());
}

RC_GTEST_PROP(FiniteVehicle, PropellersAndSpeedMapsAreFiniteAtAnySpeed, ()) {
  const Remus100& auv = AnyRemus();
  const PropellerForce force = ForceOf(auv.params.propeller, 1026, AnyFinite(), AnyFinite());
  RC_ASSERT(std::isfinite(force.thrust_n) && std::isfinite(force.torque_nm));
  RC_ASSERT(std::isfinite(RpmForSpeed(auv, AnyFinite())));
  RC_ASSERT(std::isfinite(SteadySpeed(auv, AnyFinite())));
  RC_ASSERT(std::isfinite(MunetSpeedFromRpm(AnyFinite())));
  RC_ASSERT(std::isfinite(MunetRpmFromSpeed(AnyFinite())));
}

RC_GTEST_PROP(FiniteVehicle, CurrentAndEnergyAreFiniteInAnyState, ()) {
  const Remus100& auv = AnyRemus();
  Remus100State state;
  state.eta = AnyFiniteSix();
  state.nu = AnyFiniteSix();
  const Remus100Environment environment = {.current_mps = AnyFiniteVector()};
  RC_ASSERT(CurrentInBody(auv, state.eta, environment.current_mps).allFinite());
  RC_ASSERT(std::isfinite(Energy(auv, state, environment)));
}

RC_GTEST_PROP(FiniteVehicle, SurfaceCraftStayFiniteFromAnyState, ()) {
  const SurfaceCraftParams params;
  SurfaceCraftState state;
  state.position_m = AnyFiniteVector().head<2>();
  state.heading_rad = AnyFinite();
  state.speed_mps = AnyFinite();
  state.rudder_deg = AnyFinite();
  for (int i = 0; i < 5; ++i) {
    state = Step(params, state, {AnyFinite(), AnyFinite()}, AnyFiniteVector().head<2>(),
                 DrawBetween(1e-6, 100));
    RC_ASSERT(state.position_m.allFinite() && state.velocity_over_ground_mps.allFinite());
    RC_ASSERT(std::isfinite(state.heading_rad) && std::isfinite(state.speed_mps));
    RC_ASSERT(std::isfinite(state.rudder_deg) && std::isfinite(state.yaw_rate_radps));
  }
  RC_ASSERT(std::isfinite(SteadySpeed(params, AnyFinite())));
  RC_ASSERT(std::isfinite(ThrustForSpeed(params, AnyFinite())));
}

}  // namespace shoal::finite_vehicle_test
