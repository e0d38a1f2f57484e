#include "lib/helm/behaviors/go_to_depth.h"

#include <cmath>
#include <utility>

#include "lib/helm/behaviors/preference.h"

namespace shoal {

bool GoToDepthBehavior::IsReached(double depth_m) const {
  const double target_m = options_.depths[index_].x();
  const bool is_crossed =
      last_depth_m_.has_value() && (*last_depth_m_ - target_m) * (depth_m - target_m) < 0;
  return is_crossed || std::abs(depth_m - target_m) <= options_.capture_delta;
}

BehaviorAnswer GoToDepthBehavior::Run(const BehaviorInputs& inputs) {
  BehaviorAnswer answer;
  if (options_.depths.empty() || is_done_) return answer;
  const double depth_m = inputs.own.depth_m;
  if (!reached_s_ && IsReached(depth_m)) {
    reached_s_ = inputs.time_s;
    answer.flags.emplace_back("capture_flag");
  }
  if (reached_s_ && inputs.time_s - *reached_s_ >= options_.depths[index_].y()) {
    reached_s_.reset();
    if (++index_ == options_.depths.size()) {
      index_ = 0;
      is_done_ = rounds_++ >= options_.repeat;
    }
  }
  last_depth_m_ = depth_m;
  if (is_done_) {
    answer.completes = true;
    return answer;
  }
  constexpr double kBase_m = 5;
  BehaviorAnswer preference =
      PreferDepth({.summit = options_.depths[index_].x(), .base = kBase_m}, inputs);
  preference.flags = std::move(answer.flags);
  preference.state = (reached_s_ ? "at " : "to ") + Whole(options_.depths[index_].x()) + " m";
  return preference;
}

BehaviorAnswer GoToDepthBehavior::Idle(const BehaviorInputs&) {
  last_depth_m_.reset();
  if (is_done_) *this = GoToDepthBehavior(options_);
  return {};
}

void GoToDepthBehavior::Reconfigure(const GoToDepthOptions& options) {
  if (options.depths == options_.depths) {
    options_ = options;
  } else {
    *this = GoToDepthBehavior(options);
  }
}

}  // namespace shoal
