// Forces on a slender body under water, each a pure function: what a model of such a vehicle adds
// up.
//
//   M nu_r_dot + C(nu_r) nu_r + D nu_r + g(eta) = tau + LiftDrag(...) + CrossFlowDrag(...)
//
// Vectors of six: surge, sway, heave, then roll, pitch, yaw, in the body's frame; SI units. Speeds
// and rates count as 1e9 at most, so that finite arguments give finite forces.
// References are to Fossen (2021), Handbook of Marine Craft Hydrodynamics and Motion Control.
#pragma once

#include <Eigen/Core>

namespace shoal {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Returns S(a): S(a) b is the cross product of a and b.
[[nodiscard]] Eigen::Matrix3d Skew(const Eigen::Vector3d& a);

/// Returns the inertia matrix about the body's origin of a body with `inertia_cg` about its centre
/// of gravity, which lies at `cg_m`. Fossen (2021), section 3.3.
[[nodiscard]] Matrix6d InertiaAboutOrigin(const Matrix6d& inertia_cg, const Eigen::Vector3d& cg_m);

/// Returns C(nu) of a symmetric inertia matrix; skew-symmetric, so it does no work. Fossen (2021),
/// Theorem 3.2.
[[nodiscard]] Matrix6d CoriolisMatrix(const Matrix6d& inertia, const Vector6d& nu);

/// Shares of a spheroid's own mass and moment of inertia that the water adds to it.
struct LambFactors {
  double surge = 0;  ///< k1, of the mass.
  double sway = 0;   ///< k2, of the mass; heave as well.
  double yaw = 0;    ///< k', of the moment of inertia; pitch as well.
};

/// Lamb (1932), Hydrodynamics; Fossen (2021), section 8.4.2. @pre length_m > diameter_m > 0
[[nodiscard]] LambFactors LambFactorsOfSpheroid(double length_m, double diameter_m);

/// How the strips of a hull are added up.
enum class StripRule {
  kMidpoint,  ///< Twenty strips, each by the flow at its middle.
  kBothEnds,  ///< The sum over 21 stations, 1/20 of the length each: 5 % too much sway force and 21
              ///< % too much yaw moment, as Fossen's Python simulator had it until 2026.
};

/// What a hull of round section is to the water that flows across it.
struct CrossFlowHull {
  double length_m = 0;
  double draught_m = 0;
  double drag_coefficient = 0;  ///< Of the section, Hoerner's curve.
  double density_kgpm3 = 0;
  StripRule rule = StripRule::kMidpoint;
};

struct CrossFlowForce {
  double sway_n = 0;
  double yaw_nm = 0;
};

/// Integrates the drag of sway and yaw along the hull by strip theory. Fossen (2021), section 6.7.
/// For comparison: pure sway gives -rho T Cd |v| v L / 2, pure yaw -rho T Cd |r| r L^4 / 64.
[[nodiscard]] CrossFlowForce CrossFlowDrag(const CrossFlowHull& hull, double sway_mps,
                                           double yaw_rate_radps);

/// Lift at large angles of attack.
enum class LiftLaw {
  kSlender,  ///< CL = slope sin(a) cos(a): none at right angles, the same astern as ahead.
  kLinear,   ///< CL = slope a, at any angle: astern 35 times the drag and a lift that jumps.
};

/// A hull as a wing of small span.
struct WingHull {
  double span_m = 0;
  double area_m2 = 0;
  double parasitic_drag = 0;  ///< CD_0, of `area_m2`.
  double oswald = 0.7;        ///< Efficiency of the span.
  double density_kgpm3 = 0;
  LiftLaw law = LiftLaw::kSlender;
};

struct LiftDragForce {
  double surge_n = 0;
  double heave_n = 0;
};

/// Returns lift and drag in body axes for a flow of `speed_mps` at the angle of attack `alpha_rad`
/// = atan2(w, u). Beard and McLain (2012), Small Unmanned Aircraft, chapter 4; with
/// LiftLaw::kSlender the induced drag grows with sin(a)^2. Never does positive work.
[[nodiscard]] LiftDragForce LiftDrag(const WingHull& hull, double alpha_rad, double speed_mps);

/// Where gravity and buoyancy pull.
struct Hydrostatics {
  double weight_n = 0;
  double buoyancy_n = 0;
  Eigen::Vector3d cg_m = Eigen::Vector3d::Zero();  ///< Centre of gravity.
  Eigen::Vector3d cb_m = Eigen::Vector3d::Zero();  ///< Centre of buoyancy.
};

/// Returns g(eta), the left-hand side's restoring forces. Fossen (2021), section 4.1.
[[nodiscard]] Vector6d Restoring(const Hydrostatics& body, double phi_rad, double theta_rad);

/// Returns which share of a level spheroid is under water when its axis is `depth_m` deep: 0 above
/// the surface, 1 below it, half when the axis is in it.
[[nodiscard]] double SubmergedShare(double depth_m, double diameter_m);

}  // namespace shoal
