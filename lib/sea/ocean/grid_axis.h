// One axis of a grid: the coordinates of its points, and where others lie among them.
#pragma once

#include <vector>

namespace shoal {

/// A coordinate as the point before it and the share of the way to the next. Beyond the ends it is
/// the last point.
struct GridPlace {
  int before = 0;
  int after = 0;
  double share = 0;  ///< [0, 1].
  bool is_inside =
      true;  ///< At most half a step beyond the ends; of one point without a step: at it.
};

class GridAxis {
 public:
  /// Points at these coordinates. @pre at least one, finite, each greater than the one before
  explicit GridAxis(std::vector<double> points);
  /// `count` points, `step` apart. @pre count >= 1, step > 0, both ends finite
  static GridAxis Even(double first, double step, int count);

  /// NaN counts as a coordinate before the first point, and outside.
  [[nodiscard]] GridPlace Locate(double coordinate) const;

  int count() const { return count_; }
  double first() const { return first_; }
  double last() const { return last_; }

  bool operator==(const GridAxis&) const = default;

 private:
  GridAxis() = default;

  int count_ = 1;
  double first_ = 0;
  double last_ = 0;
  double step_ = 0;             ///< 0: the points have coordinates of their own.
  std::vector<double> points_;  ///< Empty: they are a step apart.
};

}  // namespace shoal
