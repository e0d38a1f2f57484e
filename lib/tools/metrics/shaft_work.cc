#include "lib/tools/metrics/shaft_work.h"

#include <algorithm>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {

void ShaftWork::Step(double commanded_rpm, double surge_mps, double dt_s) {
  const Propeller& propeller = params_.propeller;
  const PropellerForce force =
      ForceOf(propeller, params_.water_density_kgpm3, rpm_, FiniteOrZero(surge_mps));
  constexpr double kSecondsPerMinute = 60;
  const double power_w = 2 * kPi * rpm_ / kSecondsPerMinute * force.torque_nm;
  work_j_ += std::max(0.0, power_w) * dt_s;
  const double goal_rpm =
      std::clamp(FiniteOrZero(commanded_rpm), -propeller.max_rpm, propeller.max_rpm);
  rpm_ += -Expm1(-dt_s / propeller.time_s) * (goal_rpm - rpm_);
}

}  // namespace shoal
