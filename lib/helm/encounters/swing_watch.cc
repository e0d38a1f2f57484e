#include "lib/helm/encounters/swing_watch.h"

#include <algorithm>

#include "lib/base/geometry/angles.h"

namespace shoal {

void SwingWatch::Look(double heading_deg) {
  turned_deg_ += Wrap180(heading_deg - last_deg_.value_or(heading_deg));
  last_deg_ = heading_deg;
  lowest_deg_ = std::min(lowest_deg_, turned_deg_);
  highest_deg_ = std::max(highest_deg_, turned_deg_);
  if (side_ <= 0 && turned_deg_ - lowest_deg_ > least_deg_) {
    side_ = 1;
    highest_deg_ = turned_deg_;
    ++num_swings_;
  } else if (side_ >= 0 && highest_deg_ - turned_deg_ > least_deg_) {
    side_ = -1;
    lowest_deg_ = turned_deg_;
    ++num_swings_;
  }
}

}  // namespace shoal
