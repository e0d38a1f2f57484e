#include "lib/helm/behaviors/periodic_speed.h"

#include <cmath>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

BehaviorAnswer PeriodicSpeedBehavior::Run(const BehaviorInputs& inputs) {
  if (!since_s_) {
    since_s_ = inputs.time_s;
    is_busy_ = options_.initially_busy;
    num_busy_ += is_busy_ ? 1 : 0;
  }
  const auto period_s = [&] { return is_busy_ ? options_.period_busy : options_.period_lazy; };
  while (period_s() > 0 && inputs.time_s - *since_s_ >= period_s()) {
    *since_s_ += period_s();
    is_busy_ = !is_busy_;
    num_busy_ += is_busy_ ? 1 : 0;
  }
  BehaviorAnswer answer;
  if (is_busy_) {
    answer = PreferSpeed(
        {options_.period_speed, options_.peakwidth, options_.basewidth, options_.summitdelta},
        inputs);
  }
  const double left_s = std::ceil(period_s() - (inputs.time_s - *since_s_));
  Post(answer, "PERIODIC_SPEED_COUNT", num_busy_);
  Post(answer, "PERIODIC_SPEED_PENDING_BUSY", is_busy_ ? 0 : left_s);
  Post(answer, "PERIODIC_SPEED_PENDING_LAZY", is_busy_ ? left_s : 0);
  answer.state = is_busy_ ? "busy" : "lazy";
  return answer;
}

BehaviorAnswer PeriodicSpeedBehavior::Idle(const BehaviorInputs&) {
  if (options_.reset_upon_running) since_s_.reset();
  return {};
}

}  // namespace shoal
