// The polygon of a loiter behavior: its corners, and where its middle is put.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

class BhvLoiter {
 public:
  /// A loiter's polygon is to a tenth of a metre, and clockwise.
  void SetPolygon(const std::vector<Eigen::Vector2d>& corners_m);

  /// Takes center_assign, xcenter_assign or ycenter_assign. Returns what is wrong with the value.
  [[nodiscard]] std::string TakeCenter(std::string_view key, std::string_view value);

  /// Moves the polygon to where its center is assigned: the middle of the box around it. Returns
  /// false where there is nothing to move.
  bool MoveToCenter();

  const std::vector<Eigen::Vector2d>& polygon_m() const { return polygon_m_; }

 private:
  std::vector<Eigen::Vector2d> polygon_m_;
  std::optional<double> center_x_m_;
  std::optional<double> center_y_m_;
};

}  // namespace shoal
