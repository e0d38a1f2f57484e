// The table [vehicle.surface_craft].
#include <string>
#include <vector>

#include "lib/mission/file/describe.h"

namespace shoal {
namespace {

constexpr size_t kMaxThrustPoints = 100;

/// Returns what is wrong with a thrust map, empty where nothing is.
std::string ThrustMapProblem(const std::vector<ThrustPoint>& map) {
  if (map.empty() || map.back().thrust_pct <= 0 || map.back().speed_mps <= 0) {
    return "thrust_map must end with a point of positive thrust and speed, like [[100, 5]]";
  }
  for (size_t i = 0; i < map.size(); ++i) {
    const auto& [thrust_pct, speed_mps] = map[i];
    if (thrust_pct * speed_mps < 0 || (thrust_pct == 0 && speed_mps != 0)) {
      return "thrust_map must give speed ahead for positive thrust, astern for negative, 0 for 0";
    }
    if (i == 0) continue;
    if (thrust_pct <= map[i - 1].thrust_pct || speed_mps < map[i - 1].speed_mps) {
      return "thrust_map must rise: thrust from point to point, and speed must not fall";
    }
  }
  return "";
}

void DescribeThrustMap(Fields& fields, std::vector<ThrustPoint>& map) {
  std::vector<Eigen::Vector2d> pairs;
  pairs.reserve(map.size());
  for (const ThrustPoint& point : map) pairs.emplace_back(point.thrust_pct, point.speed_mps);
  fields.Pairs("thrust_map", pairs, Between(-100, 100), kMaxThrustPoints);
  map.clear();
  for (const Eigen::Vector2d& pair : pairs) map.push_back({pair.x(), pair.y()});
  const std::string problem = ThrustMapProblem(map);
  if (!problem.empty()) fields.Refuse("thrust_map", problem);
}

}  // namespace

void Describe(Fields& fields, SurfaceCraftParams& params) {
  DescribeThrustMap(fields, params.thrust_map);
  fields.Number("reverse_ratio", params.reverse_ratio, Between(0, 1));
  fields.Number("max_acceleration_mps2", params.max_acceleration_mps2, Above(0, 100));
  fields.Number("max_deceleration_mps2", params.max_deceleration_mps2, Above(0, 100));
  fields.Number("max_rudder_deg", params.max_rudder_deg, Above(0, 180));
  fields.Number("max_rudder_rate_degps", params.max_rudder_rate_degps, Above(0, 100'000));
  fields.Number("turn_rate_degps", params.turn_rate_degps, Above(0, 360));
  fields.Number("full_turn_speed_mps", params.full_turn_speed_mps, Above(0, kFastest_mps));
  fields.Number("full_turn_thrust_pct", params.full_turn_thrust_pct, Between(0, 100));
  fields.Number("turn_speed_loss", params.turn_speed_loss, Between(0, 0.99));
}

}  // namespace shoal
