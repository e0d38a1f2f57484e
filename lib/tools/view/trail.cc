#include "lib/tools/view/trail.h"

#include <cmath>

namespace shoal {

void Trail::Append(double t_s, double x_m, double y_m) {
  if (!std::isfinite(t_s) || !std::isfinite(x_m) || !std::isfinite(y_m)) return;
  if (!points_.empty() && t_s < points_.back().t_s) {
    points_.clear();
    step_s_ = kFirstStep_s;
  }
  if (points_.size() == kMaxPoints) {
    for (size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize(kMaxPoints / 2);
    step_s_ *= 2;
    next_s_ = points_.back().t_s + step_s_ - kSlack_s;
    if (t_s < next_s_) return;
  }
  points_.push_back({t_s, static_cast<float>(x_m), static_cast<float>(y_m)});
  next_s_ = t_s + step_s_ - kSlack_s;
}

}  // namespace shoal
