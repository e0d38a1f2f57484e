#include "lib/vehicle/vehicle/remus100_params.h"

#include <Eigen/LU>
#include <cmath>

#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

Remus100Params MunetRemus100() {
  Remus100Params params;
  params.yaw_time_s = 5;
  params.yaw_damping_fades = true;
  params.rudder.area_m2 = 0.01;
  params.stern_plane.area_m2 = 0.01;
  params.max_fin_rad = DegToRad(30);
  params.fin_time_s = 1;
  params.propeller.torque_on_hull = 1;
  params.variants = {.strips = StripRule::kBothEnds,
                     .lift = LiftLaw::kLinear,
                     .coriolis = Remus100Variants::Coriolis::kOneSided,
                     .surface = Remus100Variants::Surface::kNone,
                     .current_by_yaw_only = true,
                     .stern_moment_reversed = true,
                     .advance_over_ground = true,
                     .euler_actuators = true};
  return params;
}

Remus100Params FossenRemus100() {
  Remus100Params params;
  params.variants = {.strips = StripRule::kBothEnds,
                     .lift = LiftLaw::kLinear,
                     .surface = Remus100Variants::Surface::kIgnored,
                     .current_by_yaw_only = true,
                     .advance_over_ground = true,
                     .euler_actuators = true,
                     .limits_follow_actuators = false};
  return params;
}

std::optional<Remus100Params> Remus100ParamsByName(std::string_view name) {
  if (name == "default") return Remus100Params{};
  if (name == "munet") return MunetRemus100();
  if (name == "fossen") return FossenRemus100();
  return std::nullopt;
}

Remus100 BuildRemus100(const Remus100Params& params) {
  SHOAL_CHECK(params.length_m > params.diameter_m && params.diameter_m > 0,
              "length_m > diameter_m > 0");
  SHOAL_CHECK(params.fin_time_s > 0 && params.propeller.time_s > 0,
              "fin_time_s and propeller.time_s are more than 0");
  Remus100 auv;
  auv.params = params;
  const double a = params.length_m / 2;
  const double b = params.diameter_m / 2;
  const double rho = params.water_density_kgpm3;
  const Eigen::Vector3d cg_m(0, 0, params.cg_below_axis_m);

  const double mass_kg = 4.0 / 3.0 * kPi * rho * a * b * b;
  const double roll_inertia = 0.4 * mass_kg * b * b;
  const double yaw_inertia = 0.2 * mass_kg * (a * a + b * b);
  Vector6d inertia;
  inertia << mass_kg, mass_kg, mass_kg, roll_inertia, yaw_inertia, yaw_inertia;
  auv.rigid_body_mass = InertiaAboutOrigin(inertia.asDiagonal(), cg_m);

  const LambFactors lamb = LambFactorsOfSpheroid(params.length_m, params.diameter_m);
  Vector6d added;
  added << mass_kg * lamb.surge, mass_kg * lamb.sway, mass_kg * lamb.sway,
      params.added_roll_share * roll_inertia, lamb.yaw * yaw_inertia, lamb.yaw * yaw_inertia;
  auv.added_mass = added.asDiagonal();
  auv.mass = auv.rigid_body_mass + auv.added_mass;
  auv.mass_inverse = auv.mass.inverse();

  const double weight_n = mass_kg * params.gravity_mps2;
  auv.submerged = {
      .weight_n = weight_n, .buoyancy_n = weight_n * params.buoyancy_by_weight, .cg_m = cg_m};
  auv.roll_frequency_radps = std::sqrt(weight_n * params.cg_below_axis_m / auv.mass(3, 3));
  auv.pitch_frequency_radps = std::sqrt(weight_n * params.cg_below_axis_m / auv.mass(4, 4));
  auv.damping << auv.mass(0, 0) / params.surge_time_s, auv.mass(1, 1) / params.sway_time_s,
      auv.mass(2, 2) / params.heave_time_s,
      2 * params.roll_damping_ratio * auv.roll_frequency_radps * auv.mass(3, 3),
      2 * params.pitch_damping_ratio * auv.pitch_frequency_radps * auv.mass(4, 4),
      auv.mass(5, 5) / params.yaw_time_s;

  auv.cross_flow = {.length_m = params.length_m,
                    .draught_m = params.diameter_m,
                    .drag_coefficient = params.cross_flow_drag,
                    .density_kgpm3 = rho,
                    .rule = params.variants.strips};
  const double wing_area_m2 = params.wing_area_share * params.length_m * params.diameter_m;
  auv.wing = {.span_m = params.diameter_m,
              .area_m2 = wing_area_m2,
              .parasitic_drag = params.drag_coefficient * kPi * b * b / wing_area_m2,
              .oswald = params.oswald,
              .density_kgpm3 = rho,
              .law = params.variants.lift};
  return auv;
}

}  // namespace shoal
