#include "lib/sea/ocean/grid_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lib/base/check/check.h"

namespace shoal {

GridAxis::GridAxis(std::vector<double> points) : points_(std::move(points)) {
  SHOAL_CHECK(!points_.empty() &&
                  std::ranges::all_of(points_, [](double x) { return std::isfinite(x); }) &&
                  std::ranges::adjacent_find(points_, std::greater_equal<>()) == points_.end(),
              "an axis has at least one point, and finite coordinates in ascending order");
  count_ = static_cast<int>(points_.size());
  first_ = points_.front();
  last_ = points_.back();
}

GridAxis GridAxis::Even(double first, double step, int count) {
  SHOAL_CHECK(count >= 1 && step > 0 && std::isfinite(first) && std::isfinite(step * count),
              "an axis has at least one point, a positive step and finite ends");
  GridAxis axis;
  axis.count_ = count;
  axis.first_ = first;
  axis.last_ = first + step * (count - 1);
  axis.step_ = step;
  return axis;
}

GridPlace GridAxis::Locate(double coordinate) const {
  if (points_.empty()) {
    // In this order max() turns NaN into the edge.
    const double cells = std::min<double>(count_ - 1, std::max(0.0, (coordinate - first_) / step_));
    const int before = static_cast<int>(cells);
    return {.before = before,
            .after = std::min(before + 1, count_ - 1),
            .share = cells - before,
            .is_inside = coordinate >= first_ - step_ / 2 && coordinate <= last_ + step_ / 2};
  }
  if (count_ == 1) return {.is_inside = coordinate == first_};
  const auto last = static_cast<size_t>(count_ - 1);
  const double first_half = (points_[1] - first_) / 2;
  const double last_half = (last_ - points_[last - 1]) / 2;
  GridPlace place = {.is_inside =
                         coordinate >= first_ - first_half && coordinate <= last_ + last_half};
  if (coordinate >= last_) {
    place.before = place.after = count_ - 1;
  } else if (coordinate > first_) {
    const auto after = std::ranges::upper_bound(points_, coordinate);
    place.after = static_cast<int>(after - points_.begin());
    place.before = place.after - 1;
    place.share = (coordinate - *(after - 1)) / (*after - *(after - 1));
  } else {
    place.after = 1;
  }
  return place;
}

}  // namespace shoal
