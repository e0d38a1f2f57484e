#include "lib/vehicle/vehicle/propulsion.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

// Far beyond any vehicle and any propeller: keeps squares finite.
constexpr double kMaxSpeed_mps = 1e3;
constexpr double kMaxRpm = 1e6;

double FourthPower(double x) { return x * x * x * x; }

/// Returns how fast a coefficient falls with the speed at the propeller, by rps.
double Slope(const Propeller& propeller, double at_rest, double at_max) {
  return (at_max - at_rest) / propeller.max_advance_ratio / propeller.diameter_m;
}

/// Returns the thrust that keeps up `speed_mps`, signed.
double ThrustNeeded(const Remus100& auv, double speed_mps) {
  const double alpha_rad = speed_mps < 0 ? kPi : 0;
  const double fade = Exp(-auv.params.damping_fade_spm * std::abs(speed_mps));
  const double drag_n = auv.damping[0] * fade * speed_mps -
                        LiftDrag(auv.wing, alpha_rad, std::abs(speed_mps)).surge_n;
  return drag_n / (1 - auv.params.propeller.thrust_deduction);
}

}  // namespace

PropellerForce ForceOf(const Propeller& propeller, double density_kgpm3, double rpm,
                       double speed_mps) {
  const double rps = std::clamp(rpm, -kMaxRpm, kMaxRpm) / 60;
  const double scale = density_kgpm3 * FourthPower(propeller.diameter_m) * std::abs(rps);
  const double inflow_mps =
      rps > 0 ? propeller.inflow_share * std::clamp(speed_mps, 0.0, kMaxSpeed_mps) : 0;
  const double thrust_slope = Slope(propeller, propeller.thrust_at_rest, propeller.thrust_at_max);
  const double torque_slope = Slope(propeller, propeller.torque_at_rest, propeller.torque_at_max);
  return {.thrust_n = scale * (propeller.thrust_at_rest * rps + thrust_slope * inflow_mps),
          .torque_nm = scale * propeller.diameter_m *
                       (propeller.torque_at_rest * rps + torque_slope * inflow_mps)};
}

double RpmForSpeed(const Remus100& auv, double speed_mps) {
  const double bounded_mps = std::clamp(speed_mps, -kMaxSpeed_mps, kMaxSpeed_mps);
  const Propeller& propeller = auv.params.propeller;
  // KT_0 n^2 + b n = c: the positive root ahead; astern there is no b.
  const double c = ThrustNeeded(auv, bounded_mps) /
                   (auv.params.water_density_kgpm3 * FourthPower(propeller.diameter_m));
  if (c <= 0) return -60 * std::sqrt(-c / propeller.thrust_at_rest);
  const double b = Slope(propeller, propeller.thrust_at_rest, propeller.thrust_at_max) *
                   propeller.inflow_share * bounded_mps;
  return 60 * (-b + std::sqrt(b * b + 4 * propeller.thrust_at_rest * c)) /
         (2 * propeller.thrust_at_rest);
}

double SteadySpeed(const Remus100& auv, double rpm) {
  const double max_rpm = auv.params.propeller.max_rpm;
  const double bounded_rpm = std::clamp(rpm, -max_rpm, max_rpm);
  if (bounded_rpm == 0) return 0;
  double low_mps = 0;
  double high_mps = std::copysign(1.0, bounded_rpm);
  const auto is_too_slow = [&](double mps) {
    return std::abs(RpmForSpeed(auv, mps)) < std::abs(bounded_rpm);
  };
  while (is_too_slow(high_mps) && std::abs(high_mps) < kMaxSpeed_mps) high_mps *= 2;
  constexpr int kNumHalvings = 60;
  for (int i = 0; i < kNumHalvings; ++i) {
    const double middle_mps = 0.5 * (low_mps + high_mps);
    (is_too_slow(middle_mps) ? low_mps : high_mps) = middle_mps;
  }
  return 0.5 * (low_mps + high_mps);
}

double SteadySpeedSlope(const Remus100& auv, double rpm) {
  const double max_rpm = auv.params.propeller.max_rpm;
  const double low_rpm = std::clamp(rpm - 1, -max_rpm, max_rpm - 1);
  const double high_rpm = std::clamp(rpm + 1, 1 - max_rpm, max_rpm);
  return (SteadySpeed(auv, high_rpm) - SteadySpeed(auv, low_rpm)) / (high_rpm - low_rpm);
}

double MunetSpeedFromRpm(double rpm) {
  const double n = std::clamp(rpm, -kMaxRpm, kMaxRpm);
  if (n <= 100) return MunetSpeedSlope(n) * n;
  if (n <= 400) return MunetSpeedSlope(n) * n - 0.135849;
  return MunetSpeedSlope(n) * n - 0.0273616;
}

double MunetSpeedSlope(double rpm) {
  if (rpm <= 100) return 0.000611108;
  return rpm <= 400 ? 0.00196552 : 0.0016922;
}

double MunetRpmFromSpeed(double speed_mps) {
  const double u = std::clamp(speed_mps, -kMaxSpeed_mps, kMaxSpeed_mps);
  if (u <= 0.0605) return 1636.37 * u;
  if (u <= 0.6383) return 508.411 * u + 69.2435;
  return 590.939 * u + 16.1836;
}

}  // namespace shoal
