#include "apps/acomms/propeller_watch.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lib/base/check/check.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/swarm/field_checks.h"
#include "lib/vehicle/vehicle/propulsion.h"

namespace shoal {

PropellerWatch::PropellerWatch(const AnyModel& model) {
  const auto* options = std::get_if<Remus100Options>(&model);
  if (options == nullptr || options->max_propeller_rate_rpmps == 0) return;
  const std::optional<Remus100Params> params = Remus100ParamsByName(options->parameters);
  SHOAL_CHECK(params.has_value(), "the mission file was checked");
  remus_ = {.auv = BuildRemus100(*params),
            .is_munet = options->parameters == "munet",
            .max_rate_rpmps = options->max_propeller_rate_rpmps};
}

void PropellerWatch::OnActuators(const actuators_t& actuators) {
  if (!remus_ || !std::isfinite(actuators.propeller_rpm)) return;
  rate_rpmps_ = 0;
  if (utime_ && actuators.utime > *utime_) {
    const double elapsed_s = Seconds(actuators.utime - *utime_);
    rate_rpmps_ = std::clamp((actuators.propeller_rpm - rpm_) / elapsed_s, -remus_->max_rate_rpmps,
                             remus_->max_rate_rpmps);
  }
  utime_ = actuators.utime;
  rpm_ = actuators.propeller_rpm;
}

SpeedPlan PropellerWatch::PlanOf(const Motion& own, int64_t utime) const {
  SpeedPlan plan = {.speed_mps = own.velocity_mps.norm(),
                    .acceleration_mps2 = 0,
                    .max_speed_mps = FieldLimits().max_speed_mps};
  if (rate_rpmps_ == 0 || utime - *utime_ > kTimeout_us) return plan;
  const Remus100& auv = remus_->auv;
  const double full_rpm = auv.params.propeller.max_rpm;
  const double slope = remus_->is_munet ? MunetSpeedSlope(rpm_) : SteadySpeedSlope(auv, rpm_);
  const double full_mps =
      remus_->is_munet ? MunetSpeedFromRpm(full_rpm) : SteadySpeed(auv, full_rpm);
  plan.acceleration_mps2 = slope * rate_rpmps_;
  plan.max_speed_mps = std::max(plan.speed_mps, full_mps);
  return plan;
}

}  // namespace shoal
