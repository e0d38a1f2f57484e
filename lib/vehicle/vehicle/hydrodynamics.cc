#include "lib/vehicle/vehicle/hydrodynamics.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

// Far beyond any vehicle: keeps squares of what is clamped to it finite.
constexpr double kMaxMotion = 1e9;

double Moderate(double motion) { return std::clamp(motion, -kMaxMotion, kMaxMotion); }

}  // namespace

Eigen::Matrix3d Skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d skew;
  skew << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return skew;
}

Matrix6d InertiaAboutOrigin(const Matrix6d& inertia_cg, const Eigen::Vector3d& cg_m) {
  Matrix6d shift = Matrix6d::Identity();
  shift.topRightCorner<3, 3>() = Skew(cg_m).transpose();
  return shift.transpose() * inertia_cg * shift;
}

Matrix6d CoriolisMatrix(const Matrix6d& inertia, const Vector6d& nu) {
  const Vector6d momentum = inertia * nu.cwiseMin(kMaxMotion).cwiseMax(-kMaxMotion);
  Matrix6d coriolis = Matrix6d::Zero();
  coriolis.topRightCorner<3, 3>() = -Skew(momentum.head<3>());
  coriolis.bottomLeftCorner<3, 3>() = -Skew(momentum.head<3>());
  coriolis.bottomRightCorner<3, 3>() = -Skew(momentum.tail<3>());
  return coriolis;
}

LambFactors LambFactorsOfSpheroid(double length_m, double diameter_m) {
  const double ratio = diameter_m / length_m;
  const double e2 = 1 - ratio * ratio;
  const double e = std::sqrt(e2);
  const double e3 = e2 * e;
  const double log_term = Log((1 + e) / (1 - e));
  const double alpha_0 = 2 * (1 - e2) / e3 * (0.5 * log_term - e);
  const double beta_0 = 1 / e2 - (1 - e2) / (2 * e3) * log_term;
  const double difference = beta_0 - alpha_0;
  return {.surge = alpha_0 / (2 - alpha_0),
          .sway = beta_0 / (2 - beta_0),
          .yaw = e2 * e2 * difference / ((2 - e2) * (2 * e2 - (2 - e2) * difference))};
}

CrossFlowForce CrossFlowDrag(const CrossFlowHull& hull, double sway_mps, double yaw_rate_radps) {
  constexpr int kNumStrips = 20;
  const bool takes_both_ends = hull.rule == StripRule::kBothEnds;
  const int num_stations = takes_both_ends ? kNumStrips + 1 : kNumStrips;
  const double dx = hull.length_m / kNumStrips;
  const double sway = Moderate(sway_mps);
  const double yaw_rate = Moderate(yaw_rate_radps);
  const double first_x = -hull.length_m / 2 + (takes_both_ends ? 0 : dx / 2);
  double sum = 0;
  double moment = 0;
  for (int i = 0; i < num_stations; ++i) {
    const double x = first_x + i * dx;
    const double flow_mps = sway + x * yaw_rate;
    const double square = std::abs(flow_mps) * flow_mps;
    sum += square;
    moment += x * square;
  }
  const double factor = -0.5 * hull.density_kgpm3 * hull.draught_m * hull.drag_coefficient * dx;
  return {.sway_n = factor * sum, .yaw_nm = factor * moment};
}

LiftDragForce LiftDrag(const WingHull& hull, double alpha_rad, double speed_mps) {
  const double aspect_ratio = hull.span_m * hull.span_m / hull.area_m2;
  const double slope = kPi * aspect_ratio / (1 + std::sqrt(1 + 0.25 * aspect_ratio * aspect_ratio));
  const double angle_rad = Moderate(alpha_rad);
  const double flow_mps = Moderate(speed_mps);
  const auto [sin_a, cos_a] = SinCos(angle_rad);
  const bool is_linear = hull.law == LiftLaw::kLinear;
  const double lift_coefficient = slope * (is_linear ? angle_rad : sin_a * cos_a);
  const double inducing = slope * (is_linear ? angle_rad : sin_a);
  const double drag_coefficient =
      hull.parasitic_drag + inducing * inducing / (kPi * hull.oswald * aspect_ratio);
  const double pressure_n = 0.5 * hull.density_kgpm3 * flow_mps * flow_mps * hull.area_m2;
  const double lift_n = pressure_n * lift_coefficient;
  const double drag_n = pressure_n * drag_coefficient;
  return {.surge_n = -cos_a * drag_n + sin_a * lift_n, .heave_n = -sin_a * drag_n - cos_a * lift_n};
}

Vector6d Restoring(const Hydrostatics& body, double phi_rad, double theta_rad) {
  const auto [sth, cth] = SinCos(theta_rad);
  const auto [sphi, cphi] = SinCos(phi_rad);
  const double sinking_n = body.weight_n - body.buoyancy_n;
  const Eigen::Vector3d moment = body.weight_n * body.cg_m - body.buoyancy_n * body.cb_m;
  Vector6d g;
  g << sinking_n * sth, -sinking_n * cth * sphi, -sinking_n * cth * cphi,
      -moment.y() * cth * cphi + moment.z() * cth * sphi,
      moment.z() * sth + moment.x() * cth * cphi, -moment.x() * cth * sphi - moment.y() * sth;
  return g;
}

double SubmergedShare(double depth_m, double diameter_m) {
  const double share = std::clamp(depth_m / diameter_m + 0.5, 0.0, 1.0);
  return share * share * (3 - 2 * share);
}

}  // namespace shoal
