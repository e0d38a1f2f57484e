#include "lib/helm/behaviors/loiter.h"

#include <algorithm>
#include <cmath>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/helm/behaviors/preference.h"

namespace shoal {

LoiterBehavior::LoiterBehavior(const LoiterOptions& options)
    : BehaviorWith(options), polygon_m_(options.polygon) {}

BehaviorAnswer LoiterBehavior::Idle(const BehaviorInputs&) {
  is_new_ = true;
  return {};
}

void LoiterBehavior::Reconfigure(const LoiterOptions& options) {
  const bool is_same_way =
      options.polygon == options_.polygon && options.clockwise == options_.clockwise;
  options_ = options;
  if (is_same_way) return;
  polygon_m_ = options.polygon;
  is_new_ = true;
}

void LoiterBehavior::Arrange(bool clockwise) {
  clockwise_ = clockwise;
  vertices_m_ = polygon_m_;
  if (IsClockwise(vertices_m_) != clockwise) std::reverse(vertices_m_.begin(), vertices_m_.end());
}

void LoiterBehavior::Begin(const BehaviorInputs& inputs) {
  const VesselMotion& own = inputs.own.motion;
  if (options_.center_activate) {
    const Eigen::Vector2d moved_m = own.position_m - Centroid(options_.polygon);
    polygon_m_ = options_.polygon;
    for (Eigen::Vector2d& corner_m : polygon_m_) corner_m += moved_m;
  }
  // With the centre to starboard, clockwise is the shorter way in.
  const double centre_deg = BearingDeg(own.position_m, Centroid(polygon_m_));
  const bool is_to_starboard = Wrap180(centre_deg - own.heading_deg) >= 0;
  Arrange(options_.clockwise == "best" ? is_to_starboard : options_.clockwise == "true");
  rounds_ = RouteRounds(vertices_m_.size(), rounds_.index() % vertices_m_.size());
  is_new_ = false;
  is_acquired_ = false;
  capture_.reset();
  bearing_deg_.reset();
  gone_round_deg_ = 0;
}

// A vertex is visible where one of its two edges faces the vessel. Of those, the one with the
// largest turn, in the direction of travel, from the approach into its next leg is met
// tangentially.
size_t LoiterBehavior::TangentialVertex(const Eigen::Vector2d& position_m) const {
  const size_t size = vertices_m_.size();
  const double side = clockwise_ ? 1 : -1;
  const auto faces = [&](size_t from) {
    const Leg edge = {.from_m = vertices_m_[from], .to_m = vertices_m_[(from + 1) % size]};
    return side * Project(edge, position_m).cross_track_m < 0;
  };
  size_t best = rounds_.index();
  double largest_deg = -1000;
  for (size_t i = 0; i < size; ++i) {
    if (!faces(i) && !faces((i + size - 1) % size)) continue;
    const double leg_deg = BearingDeg(vertices_m_[i], vertices_m_[(i + 1) % size]);
    const double turn_deg = side * Wrap180(leg_deg - BearingDeg(position_m, vertices_m_[i]));
    if (turn_deg > largest_deg) {
      largest_deg = turn_deg;
      best = i;
    }
  }
  return best;
}

void LoiterBehavior::Spiral() {
  const Eigen::Vector2d centre_m = Centroid(polygon_m_);
  double radius_m = 0;
  for (const Eigen::Vector2d& corner_m : polygon_m_) radius_m += (corner_m - centre_m).norm();
  radius_m /= static_cast<double>(polygon_m_.size());
  for (Eigen::Vector2d& corner_m : polygon_m_) {
    corner_m = centre_m + (radius_m + options_.spiral_factor) / radius_m * (corner_m - centre_m);
  }
  Arrange(clockwise_);
}

void LoiterBehavior::GoRound(const BehaviorInputs& inputs) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  const auto head_for_vertex = [&] {
    const size_t size = vertices_m_.size();
    const size_t index = rounds_.index();
    capture_.emplace(
        CaptureRule{.capture_radius_m = options_.radius, .slip_radius_m = options_.slip_radius},
        Leg{.from_m = vertices_m_[(index + size - 1) % size], .to_m = vertices_m_[index]},
        position_m);
  };
  if (!capture_) head_for_vertex();
  if (!capture_->Reached(position_m)) return;
  rounds_.Pass();
  const bool is_round = rounds_.num_reached() % static_cast<int>(vertices_m_.size()) == 0;
  if (is_round && options_.spiral_factor > 0) Spiral();
  head_for_vertex();
}

std::string LoiterBehavior::Mode(double distance_m) const {
  if (std::abs(distance_m) <= options_.acquire_dist) return "stable";
  return std::string(is_acquired_ ? "recovering_" : "acquiring_") +
         (distance_m > 0 ? "external" : "internal");
}

void LoiterBehavior::Report(const BehaviorInputs& inputs, double distance_m,
                            BehaviorAnswer& answer) const {
  const std::string& suffix = options_.post_suffix;
  const double outside_m = std::max(0.0, distance_m);
  const double speed_mps = inputs.own.motion.speed_mps;
  answer.state = Mode(distance_m);
  Post(answer, "LOITER_INDEX", static_cast<double>(rounds_.index()), suffix);
  Post(answer, "LOITER_MODE", answer.state, suffix);
  Post(answer, "LOITER_ACQUIRE", answer.state == "stable" ? 0 : 1, suffix);
  Post(answer, "LOITER_DIST_TO_POLY", std::round(distance_m), suffix);
  Post(answer, "LOITER_ETA_TO_POLY", speed_mps > 0 ? std::round(outside_m / speed_mps) : -1,
       suffix);
}

BehaviorAnswer LoiterBehavior::Run(const BehaviorInputs& inputs) {
  const Eigen::Vector2d& position_m = inputs.own.motion.position_m;
  if (options_.polygon.empty()) {
    BehaviorAnswer answer;
    answer.state = "no polygon";
    return answer;
  }
  if (is_new_) Begin(inputs);
  const double distance_m = SignedDistance(vertices_m_, position_m);
  if (distance_m > options_.acquire_dist) {
    rounds_.GoTo(TangentialVertex(position_m));
    capture_.reset();
    bearing_deg_.reset();
  } else {
    GoRound(inputs);
    const double bearing_deg = BearingDeg(Centroid(vertices_m_), position_m);
    const double step_deg = Wrap180(bearing_deg - bearing_deg_.value_or(bearing_deg));
    gone_round_deg_ += clockwise_ ? step_deg : -step_deg;
    bearing_deg_ = bearing_deg;
  }

  const bool is_alternative = options_.use_alt_speed && options_.speed_alt >= 0;
  const double speed_mps = InDomain(inputs, is_alternative ? options_.speed_alt : options_.speed);
  const Eigen::Vector2d& vertex_m = vertices_m_[rounds_.index()];
  BehaviorAnswer answer = PreferBoth(
      inputs, PeakOverCourse(BearingDeg(position_m, vertex_m), 0, 180),
      options_.ipf_type == "zaic_spd" ? TransitSpeed(inputs, speed_mps, 85)
                                      : PeakOverAxis(inputs.domain->speed_mps, speed_mps, 0, 0.3),
      options_.patience);
  Report(inputs, distance_m, answer);
  is_acquired_ = is_acquired_ || answer.state == "stable";
  answer.completes = options_.slingshot >= 0 && gone_round_deg_ > options_.slingshot;
  answer.view = {.points_m = vertices_m_, .closed = true, .steers_for_m = vertex_m};
  return answer;
}

}  // namespace shoal
