// What a Remus 100 is made of: parameters, three sets of them, and what follows from them.
//
//   const Remus100 auv = BuildRemus100({});                // the default: as physics asks
//   const Remus100 original = BuildRemus100(MunetRemus100());
//
// After Fossen's Remus 100 (Python Vehicle Simulator; Fossen 2021, section 8.4.2; propulsion from
// Allen, Vorus and Prestero, OCEANS 2000). docs/vehicles/vehicles.md explains how the sets differ.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "lib/vehicle/vehicle/hydrodynamics.h"

namespace shoal {

/// A pair of fins at the stern that moves as one.
struct TailFin {
  double lift_coefficient = 0;  ///< Per radian of deflection.
  double area_m2 = 0.0133;      ///< Of the pair.
  double x_m = -0.8;            ///< From midships; the stern is negative.

  bool operator==(const TailFin&) const = default;
};

/// A propeller of the Wageningen B series with 3 blades and a blade-area ratio of 0.718, its
/// coefficients linear in the advance ratio.
struct Propeller {
  double diameter_m = 0.14;
  double thrust_deduction = 0.1;      ///< t: the share of the thrust that its suction costs.
  double inflow_share = 0.944;        ///< 1 - w: speed at the propeller by speed through water.
  double max_advance_ratio = 0.6632;  ///< Where `thrust_at_max` and `torque_at_max` hold.
  double thrust_at_rest = 0.4566;     ///< KT_0.
  double thrust_at_max = 0.1798;
  double torque_at_rest = 0.0700;  ///< KQ_0.
  double torque_at_max = 0.0312;
  double torque_on_hull = 0.1;  ///< Share of the torque that rolls the hull; Fossen, by trials.
  double time_s = 1.0;          ///< First-order lag.
  double max_rpm = 1525;

  bool operator==(const Propeller&) const = default;
};

/// What the published programs compute in another way. The defaults are the right ones.
struct Remus100Variants {
  StripRule strips = StripRule::kMidpoint;
  LiftLaw lift = LiftLaw::kSlender;

  /// Which terms of the added mass's C are left out.
  enum class Coriolis {
    kInPairs,   ///< Pitch and yaw, with their counterparts: C does no work.
    kOneSided,  ///< Without their counterparts: C does work, u w q times the added mass.
  } coriolis = Coriolis::kInPairs;

  enum class Surface {
    kShare,    ///< Buoyancy in proportion to what is under water.
    kNone,     ///< No buoyancy at all once the axis is above the surface.
    kIgnored,  ///< Full buoyancy at any height.
  } surface = Surface::kShare;

  /// The current is turned into the body's frame by yaw alone, and the speed over ground is
  /// integrated instead of that through water: a rolled, pitched or turning vehicle feels a
  /// current that is not there.
  bool current_by_yaw_only = false;

  bool stern_moment_reversed = false;   ///< The stern plane's moment contradicts its force.
  bool advance_over_ground = false;     ///< The propeller feels the speed over ground.
  bool euler_actuators = false;         ///< Explicit Euler; commands are not limited.
  bool limits_follow_actuators = true;  ///< Deflections are limited after a step, too.

  bool operator==(const Remus100Variants&) const = default;
};

struct Remus100Params {
  double length_m = 1.6;
  double diameter_m = 0.19;
  double water_density_kgpm3 = 1026;
  double gravity_mps2 = 9.81;
  double cg_below_axis_m = 0.02;   ///< The centre of buoyancy lies on the axis.
  double buoyancy_by_weight = 1;   ///< When submerged; 1 is neutral, above 1 floats up.
  double drag_coefficient = 0.42;  ///< Of the frontal area; Allen et al. (2000).
  double wing_area_share = 0.7;    ///< Of length times diameter.
  double oswald = 0.7;             ///< Efficiency of the hull as a wing.
  double cross_flow_drag =
      1.1977288343558283;         ///< Hoerner's curve at B / 2T = 0.5, a round section.
  double added_roll_share = 0.3;  ///< Added moment of inertia in roll by that of the hull.

  double surge_time_s = 20;  ///< Linear damping at low speed: the time to lose 1 - 1/e.
  double sway_time_s = 20;
  double heave_time_s = 20;
  double yaw_time_s = 1;
  double roll_damping_ratio = 0.3;
  double pitch_damping_ratio = 0.8;
  double damping_fade_spm = 3;     ///< Surge and sway damping fade with exp(-3 speed).
  bool yaw_damping_fades = false;  ///< So does that of yaw.

  TailFin rudder = {.lift_coefficient = 0.5};
  TailFin stern_plane = {.lift_coefficient = 0.7};
  double max_fin_rad = 0.2617993877991494;  ///< 15 degrees.
  double fin_time_s = 0.1;                  ///< First-order lag.
  Propeller propeller;

  Remus100Variants variants;

  bool operator==(const Remus100Params&) const = default;
};

/// Returns the set that muNet-AUVsim 0.3.0 has, with its faults.
[[nodiscard]] Remus100Params MunetRemus100();

/// Returns the set of Fossen's Python Vehicle Simulator as of early 2026, with its faults.
[[nodiscard]] Remus100Params FossenRemus100();

/// Returns the set of that name: "default", "munet" or "fossen".
[[nodiscard]] std::optional<Remus100Params> Remus100ParamsByName(std::string_view name);

/// A vehicle with all that follows from its parameters. Made by BuildRemus100, never changed.
struct Remus100 {
  Remus100Params params;
  Hydrostatics submerged;
  CrossFlowHull cross_flow;
  WingHull wing;
  Matrix6d rigid_body_mass = Matrix6d::Identity();
  Matrix6d added_mass = Matrix6d::Zero();
  Matrix6d mass = Matrix6d::Identity();  ///< M: the sum of both.
  Matrix6d mass_inverse = Matrix6d::Identity();
  Vector6d damping = Vector6d::Zero();  ///< Diagonal of D at rest.
  double roll_frequency_radps = 0;      ///< Of free oscillation.
  double pitch_frequency_radps = 0;
};

/// @pre lengths, areas, times > 0; length_m > diameter_m; cg_below_axis_m >= 0
[[nodiscard]] Remus100 BuildRemus100(const Remus100Params& params);

}  // namespace shoal
