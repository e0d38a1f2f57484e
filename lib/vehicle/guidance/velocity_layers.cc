#include "lib/vehicle/guidance/velocity_layers.h"

#include <algorithm>
#include <cmath>

#include "lib/vehicle/guidance/line_of_sight.h"
#include "lib/vehicle/guidance/plausible.h"

namespace shoal {

namespace {

double Cube(double x) { return x * x * x; }

/// Slower than this there is no direction of travel to step aside from.
constexpr double kTravels_mps = 0.1;
/// Sides that differ by less than rounding are equally full.
constexpr double kTie_m = 1e-6;

/// Gathers what is in the way of a vehicle, and how it steps aside.
class Sidestep {
 public:
  Sidestep(double r_avoid_m, double r_pass_m, double height_m)
      : r_avoid_m_(r_avoid_m), r_pass_m_(r_pass_m), height_m_(height_m) {}

  /// `way_m`: to what it keeps clear of; `travel_mps`: own velocity relative to that.
  void Add(const Eigen::Vector3d& way_m, const Eigen::Vector3d& travel_mps) {
    const double range_m = way_m.norm();
    const double over_ground_mps = travel_mps.head<2>().norm();
    if (range_m >= r_avoid_m_ || over_ground_mps < kTravels_mps) return;
    const Eigen::Vector3d ahead = travel_mps.normalized();
    const Eigen::Vector3d starboard(travel_mps.y() / over_ground_mps,
                                    -travel_mps.x() / over_ground_mps, 0);
    const double along_m = way_m.dot(ahead);
    const double across_m = way_m.dot(starboard);
    const double below_m = (way_m - along_m * ahead).z();
    if (along_m <= 0 || std::abs(across_m) >= r_pass_m_ || std::abs(below_m) >= height_m_) return;
    const double near = range_m / r_avoid_m_;
    const double strength = (1 - near * near) * (1 - std::abs(across_m) / r_pass_m_);
    fuller_m_ += (1 - near) * across_m;
    if (strength <= strength_) return;
    strength_ = strength;
    starboard_ = starboard;
  }

  Eigen::Vector3d Velocity_mps(double u_max_mps) const {
    return (fuller_m_ > kTie_m ? -u_max_mps : u_max_mps) * strength_ * starboard_;
  }

 private:
  double r_avoid_m_;
  double r_pass_m_;
  double height_m_;
  double fuller_m_ = 0;
  double strength_ = 0;
  Eigen::Vector3d starboard_ = Eigen::Vector3d::Zero();  ///< Of the strongest.
};

}  // namespace

Eigen::Vector3d LayerVelocity(const FeedForwardLayer&, double, const Surroundings& surroundings) {
  if (!surroundings.target) return Eigen::Vector3d::Zero();
  return Plausible(surroundings.target->velocity_mps);
}

Eigen::Vector3d LayerVelocity(const FormationLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  if (!surroundings.target) return Eigen::Vector3d::Zero();
  const LineOfSight sight = SightFrom(*surroundings.target, surroundings.own);
  const double r_m = sight.range_m;
  if (r_m <= layer.r_safe_m) return u_max_mps * sight.away;
  if (r_m < layer.r_inner_m) {
    const double x = (layer.r_inner_m - r_m) / (layer.r_inner_m - layer.r_safe_m);
    return u_max_mps * Cube(x) * sight.away;
  }
  const double r_outer_m = layer.r_outer_m();
  if (r_m <= r_outer_m) return Eigen::Vector3d::Zero();
  if (r_m < layer.r_max_m()) {
    const double x = (r_m - r_outer_m) / (layer.r_max_m() - r_outer_m);
    return -u_max_mps * Cube(x) * sight.away;
  }
  return -u_max_mps * sight.away;
}

Eigen::Vector3d LayerVelocity(const SurvivalGroupLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  Eigen::Vector3d sum_mps = Eigen::Vector3d::Zero();
  for (const Neighbour& member : surroundings.group) {
    const LineOfSight sight = SightFrom(member, surroundings.own);
    if (sight.range_m <= layer.r_safe_m) {
      sum_mps += u_max_mps * sight.away;
    } else if (sight.range_m < layer.r_avoid_m) {
      const double x = (layer.r_avoid_m - sight.range_m) / (layer.r_avoid_m - layer.r_safe_m);
      sum_mps += u_max_mps * Cube(x) * sight.away;
    }
  }
  if (layer.r_pass_m > 0) {
    Sidestep aside(layer.r_avoid_m, layer.r_pass_m, layer.r_pass_m);
    for (const Neighbour& member : surroundings.group) {
      aside.Add(Plausible(member.position_m) - Plausible(surroundings.own.position_m),
                Plausible(surroundings.own.velocity_mps) - Plausible(member.velocity_mps));
    }
    sum_mps += aside.Velocity_mps(u_max_mps);
  }
  return ClampNorm(sum_mps, u_max_mps);
}

Eigen::Vector3d LayerVelocity(const SurvivalSonarLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
  double sum = 0;
  double strongest = 0;
  for (const SonarEcho& echo : surroundings.sonar) {
    const double range_m = std::max(Plausible(echo.range_m), 0.0);
    if (range_m >= layer.r_avoid_m) continue;
    const double weight = Cube((layer.r_avoid_m - range_m) / layer.r_avoid_m);
    weighted += weight * Plausible(echo.direction);
    sum += weight;
    strongest = std::max(strongest, weight);
  }
  if (sum <= 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d away_mps = -u_max_mps * (strongest / sum) * weighted;
  if (layer.r_pass_m <= 0) return ClampNorm(away_mps, u_max_mps);
  Sidestep aside(layer.r_avoid_m, layer.r_pass_m, kEchoHeight_m);
  for (const SonarEcho& echo : surroundings.sonar) {
    aside.Add(std::max(echo.range_m, 0.0) * echo.direction,
              Plausible(surroundings.own.velocity_mps));
  }
  return ClampNorm(away_mps + aside.Velocity_mps(u_max_mps), u_max_mps);
}

Eigen::Vector3d LayerVelocity(const SurvivalLayer& layer, double u_max_mps,
                              const Surroundings& surroundings) {
  return ClampNorm(LayerVelocity(layer.group, u_max_mps, surroundings) +
                       LayerVelocity(layer.sonar, u_max_mps, surroundings),
                   u_max_mps);
}

std::string_view NameOf(const VelocityLayer& layer) {
  if (std::holds_alternative<FeedForwardLayer>(layer)) return "feed_forward";
  if (std::holds_alternative<FormationLayer>(layer)) return "formation";
  if (std::holds_alternative<SurvivalLayer>(layer)) return "survival_and_sonar";
  return std::holds_alternative<SurvivalSonarLayer>(layer) ? "sonar" : "survival";
}

const SurvivalSonarLayer* SonarOf(const VelocityLayer& layer) {
  if (const auto* both = std::get_if<SurvivalLayer>(&layer)) return &both->sonar;
  return std::get_if<SurvivalSonarLayer>(&layer);
}

const SurvivalGroupLayer* GroupOf(const VelocityLayer& layer) {
  if (const auto* both = std::get_if<SurvivalLayer>(&layer)) return &both->group;
  return std::get_if<SurvivalGroupLayer>(&layer);
}

}  // namespace shoal
