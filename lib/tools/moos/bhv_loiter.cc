#include "lib/tools/moos/bhv_loiter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {

void BhvLoiter::SetPolygon(const std::vector<Eigen::Vector2d>& corners_m) {
  constexpr double kSteps = 10;  // Per metre.
  polygon_m_ = corners_m;
  for (Eigen::Vector2d& corner_m : polygon_m_) {
    corner_m = (corner_m * kSteps).array().round() / kSteps + 0.0;
  }
  double area_m2 = 0;
  for (size_t i = 0; i < polygon_m_.size(); ++i) {
    const Eigen::Vector2d& corner_m = polygon_m_[i];
    const Eigen::Vector2d& next_m = polygon_m_[(i + 1) % polygon_m_.size()];
    area_m2 += corner_m.x() * next_m.y() - corner_m.y() * next_m.x();
  }
  if (area_m2 > 0) std::reverse(polygon_m_.begin(), polygon_m_.end());
}

std::string BhvLoiter::TakeCenter(std::string_view key, std::string_view value) {
  std::vector<double> numbers;
  for (const std::string& part : PartsOf(value, ",")) {
    const size_t equals = part.find('=');
    numbers.push_back(NumberIn(std::string_view(part).substr(equals == part.npos ? 0 : equals + 1))
                          .value_or(std::nan("")));
  }
  const bool is_one = key != "center_assign";
  const bool is_sound = numbers.size() == (is_one ? 1U : 2U) &&
                        std::all_of(numbers.begin(), numbers.end(),
                                    [](double number) { return std::isfinite(number); });
  if (!is_sound) return is_one ? "not a number" : "not x,y";
  if (key != "ycenter_assign") center_x_m_ = numbers.front();
  if (key != "xcenter_assign") center_y_m_ = numbers.back();
  return "";
}

bool BhvLoiter::MoveToCenter() {
  if (polygon_m_.empty() || (!center_x_m_ && !center_y_m_)) return false;
  Eigen::Vector2d low_m = polygon_m_.front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& vertex_m : polygon_m_) {
    low_m = low_m.cwiseMin(vertex_m);
    high_m = high_m.cwiseMax(vertex_m);
  }
  const Eigen::Vector2d middle_m = (low_m + high_m) / 2;
  const Eigen::Vector2d offset_m(center_x_m_.value_or(middle_m.x()) - middle_m.x(),
                                 center_y_m_.value_or(middle_m.y()) - middle_m.y());
  for (Eigen::Vector2d& vertex_m : polygon_m_) vertex_m += offset_m;
  return true;
}

}  // namespace shoal
