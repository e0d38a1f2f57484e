#include "lib/tools/moos/bhv_leg.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/text/blanks.h"
#include "lib/base/text/numbers.h"
#include "lib/run/moos_text/numbers.h"
#include "lib/tools/moos/bhv_points.h"
#include "lib/tools/moos/bhv_text.h"

namespace shoal {
namespace {

/// Returns x, y, ang and len.
std::optional<std::array<double, 4>> LegOf(std::string_view text) {
  constexpr std::array<std::string_view, 4> kKeys = {"x", "y", "ang", "len"};
  std::array<double, 4> leg{};
  const bool is_named = text.find('=') != text.npos;
  const std::vector<std::string> parts = PartsOf(text, is_named ? "," : ":");
  if (parts.size() != leg.size()) return std::nullopt;
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string_view part = parts[i];
    const size_t equals = part.find('=');
    const auto at = std::find(kKeys.begin(), kKeys.end(), Trimmed(part.substr(0, equals)));
    if (is_named && (equals == part.npos || at == kKeys.end())) return std::nullopt;
    const auto number = NumberIn(is_named ? part.substr(equals + 1) : part);
    if (!number) return std::nullopt;
    leg[is_named ? static_cast<size_t>(at - kKeys.begin()) : i] = *number;
  }
  return leg;
}

}  // namespace

bool BhvLeg::IsKey(std::string_view key) {
  return key == "leg" || key == "leg_len" || key == "leg_len_mod" || key == "leg_ang" ||
         key == "leg_ang_mod" || key == "shift_pt";
}

std::string BhvLeg::Take(std::string_view key, std::string_view value) {
  constexpr double kRadPerDegree = std::numbers::pi / 180;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double length_m = 0;
  double angle_rad = 0;  // Clockwise from North.
  if (ends_m_[0] && ends_m_[1]) {
    const Eigen::Vector2d vector_m = *ends_m_[1] - *ends_m_[0];
    center_m = (*ends_m_[0] + *ends_m_[1]) / 2;
    length_m = vector_m.norm();
    angle_rad = Atan2(vector_m.x(), vector_m.y());
  } else if (key != "leg") {
    return "is before p1 and p2";
  }
  if (key == "leg") {
    const auto leg = LegOf(value);
    if (!leg) return "not x=1,y=2,ang=90,len=80";
    center_m = {(*leg)[0], (*leg)[1]};
    angle_rad = (*leg)[2] * kRadPerDegree;
    length_m = (*leg)[3];
  } else if (key == "shift_pt") {
    const auto point = ParseBhvPoint(value);
    if (!point.ok()) return point.error();
    center_m = point->points_m.front();
  } else {
    const auto number = NumberIn(value);
    if (!number) return "not a number";
    if (key == "leg_len") length_m = *number;
    if (key == "leg_len_mod") length_m += *number;
    if (key == "leg_ang") angle_rad = *number * kRadPerDegree;
    if (key == "leg_ang_mod") angle_rad += *number * kRadPerDegree;
  }
  if (!(length_m > 0)) return "a leg must be longer than 0 m";
  const Eigen::Vector2d half_m = Eigen::Vector2d(Sin(angle_rad), Cos(angle_rad)) * (length_m / 2);
  const auto rounded = [](const Eigen::Vector2d& end_m) -> Eigen::Vector2d {
    return (end_m * 1e6).array().round() / 1e6 + 0.0;
  };
  ends_m_ = {rounded(center_m - half_m), rounded(center_m + half_m)};
  return {};
}

}  // namespace shoal
