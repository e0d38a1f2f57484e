// An interval that covers an unknown number with a stated confidence.
#pragma once

#include <limits>

namespace shoal {

/// From `low` to `high`, both included. Without enough data one or both ends are infinite.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  [[nodiscard]] double half_width() const { return (high - low) / 2; }
  [[nodiscard]] bool Contains(double value) const { return low <= value && value <= high; }
  bool operator==(const Interval&) const = default;
};

}  // namespace shoal
