#include "lib/sea/rays/traced_ray.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/bounds.h"
#include "lib/sea/rays/ray_step.h"

namespace shoal {

namespace {

/// An arc turns by at most this much, so that it meets a straight edge once or twice.
constexpr double kLargestArc_rad = 0.5;
/// In other water a ray turns by at most this much in a step: delays are then good to 1e-12 s.
constexpr double kLargestTurn_rad = 0.015;
/// And the gradient of the speed, relative to it and per length of a step, changes by at most this.
constexpr double kLargestChange = 1e-3;
constexpr int kMaxSteps = 200'000;
constexpr int kMaxSolves = 60;

/// A straight line that ends a cell: where `normal` . (place - point) falls to 0.
struct Edge {
  enum class Kind { kRange, kLayer, kSurface, kBottom };
  Kind kind = Kind::kRange;
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< Unit length, into the cell.

  size_t piece = 0;  ///< Of a boundary, counted along the range.

  double DistanceOf(const Eigen::Vector2d& at) const { return normal.dot(at - point); }
};

Edge PieceOf(Edge::Kind kind, std::span<const BoundaryPoint> boundary, double range_m) {
  const auto next = std::ranges::upper_bound(boundary, range_m, {}, &BoundaryPoint::range_m);
  const double inward = kind == Edge::Kind::kBottom ? -1 : 1;
  const auto piece = static_cast<size_t>(next - boundary.begin());
  if (next == boundary.begin() || next == boundary.end()) {
    const double depth_m = DepthAt(boundary, range_m);
    return {kind, {range_m, depth_m}, {0, inward}, piece};
  }
  const BoundaryPoint& a = *std::prev(next);
  const Eigen::Vector2d along(next->range_m - a.range_m, next->depth_m - a.depth_m);
  const double length = std::sqrt(along.squaredNorm());
  const Eigen::Vector2d normal = inward / length * Eigen::Vector2d(-along.y(), along.x());
  return {kind, {a.range_m, a.depth_m}, normal, piece};
}

/// One ray under way.
class RayMarch {
 public:
  /// `ranges_m`: kinks of the scene. All arguments outlive it.
  RayMarch(const RayScene& scene, std::span<const double> ranges_m, const SectionPoint& source,
           double range_m, double launch_rad, const RayLimits& limits)
      : scene_(scene),
        ranges_m_(ranges_m),
        limits_(limits),
        range_m_(range_m),
        points_(scene_.water.front().profile.points()) {
    const double c = SpeedAt(scene_, source.range_m, source.depth_m);
    const auto [sine, cosine] = SinCos(launch_rad);
    ray_.at = {source.range_m, source.depth_m};
    ray_.slowness = Eigen::Vector2d(cosine, sine) / c;
    ray_.slowness_slope = Eigen::Vector2d(-sine, cosine) / c;
    layer_ = LayerOf(source.depth_m, sine);
    EnterColumn(source.range_m);
  }

  TracedRay Run(std::vector<Eigen::Vector2d>* path) {
    const double longest_m = path != nullptr ? (range_m_ - ray_.at.x()) / 100 : kInfinity;
    for (int i = 0; i < kMaxSteps && !is_done_; ++i) {
      if (path != nullptr) path->push_back(ray_.at);
      Advance(longest_m);
    }
    if (path != nullptr) path->push_back(ray_.at);
    return result_;
  }

 private:
  /// Layers are counted from the surface: layer i ends at point i of the profile.
  size_t LayerOf(double depth_m, double downward) const {
    size_t layer = 0;
    while (layer < points_.size() && (points_[layer].depth_m < depth_m ||
                                      (points_[layer].depth_m == depth_m && downward > 0))) {
      ++layer;
    }
    return layer;
  }

  /// Sets what does not change until the next kink in range.
  void EnterColumn(double range_m) {
    const auto next = std::ranges::upper_bound(ranges_m_, range_m);
    const double end_m = next == ranges_m_.end() ? range_m_ : std::min(*next, range_m_);
    range_edge_ = {Edge::Kind::kRange, {end_m, 0}, {-1, 0}};
    const double middle_m = (range_m + end_m) / 2;
    surface_ = PieceOf(Edge::Kind::kSurface, scene_.surface, middle_m);
    bottom_ = PieceOf(Edge::Kind::kBottom, scene_.bottom, middle_m);
    column_m_ = middle_m;
    EnterLayer();
  }

  void EnterLayer() {
    top_ = {Edge::Kind::kLayer, {0, layer_ > 0 ? points_[layer_ - 1].depth_m : -kFar_m}, {0, 1}};
    base_ = {Edge::Kind::kLayer,
             {0, layer_ < points_.size() ? points_[layer_].depth_m : kFar_m},
             {0, -1}};
    const std::vector<ProfileAtRange>& water = scene_.water;
    const auto next = std::ranges::upper_bound(water, column_m_, {}, &ProfileAtRange::range_m);
    const ProfileAtRange& near = next == water.begin() ? *next : *std::prev(next);
    const ProfileAtRange& far = next == water.end() ? near : *next;
    const double width_m = &near == &far ? 1 : far.range_m - near.range_m;
    const auto speed_of = [this](const ProfileAtRange& which, bool below) {
      const auto points = which.profile.points();
      const size_t index = below ? layer_ : layer_ - 1;
      if (layer_ == 0) return points.front().speed_mps;
      return points[std::min(index, points.size() - 1)].speed_mps;
    };
    const bool is_inside = layer_ > 0 && layer_ < points_.size();
    const double height_m = is_inside ? base_.point.y() - top_.point.y() : 1;
    cell_.range_m = near.range_m;
    cell_.depth_m = is_inside ? top_.point.y() : 0;
    cell_.speed_mps = speed_of(near, false);
    cell_.by_range = (speed_of(far, false) - cell_.speed_mps) / width_m;
    cell_.by_depth = (speed_of(near, true) - cell_.speed_mps) / height_m;
    cell_.by_both =
        ((speed_of(far, true) - speed_of(far, false)) / height_m - cell_.by_depth) / width_m;
  }

  double LongestStep(double longest_m) const {
    if (cell_.IsLayered()) {
      const double turn = std::abs(cell_.by_depth * ray_.slowness.x());
      return std::min({turn > 0 ? kLargestArc_rad / turn : kInfinity, longest_m, kFar_m});
    }
    const double turn = std::sqrt(cell_.GradientAt(ray_.at).squaredNorm()) / cell_.At(ray_.at);
    // The gradient of a bilinear cell changes along the way.
    const double change = std::abs(cell_.by_both) / cell_.At(ray_.at);
    const double by_turn = turn > 0 ? kLargestTurn_rad / turn : kInfinity;
    const double by_change = change > 0 ? std::sqrt(kLargestChange / change) : kInfinity;
    return std::min({by_turn, by_change, longest_m, kFar_m});
  }

  void Advance(double longest_m) {
    double step_m = LongestStep(longest_m);
    const double by_range_m = 1.001 * (range_edge_.point.x() - ray_.at.x()) /
                              std::max(ray_.slowness.x() * cell_.At(ray_.at), 1e-3);
    step_m = std::min(step_m, std::max(by_range_m, 1e-9));
    RayState next = StepOf(ray_, cell_, step_m);
    const Edge* met = nullptr;
    for (const Edge* edge : {&range_edge_, &surface_, &bottom_, &top_, &base_}) {
      // The first to be met stays: each makes the step shorter.
      if (MeetWithin(*edge, met != nullptr, &step_m, &next)) met = edge;
    }
    NoteCaustic(next);
    if (ray_.slowness.y() * next.slowness.y() < 0) {
      result_.turns = result_.turns * kHashFactor + layer_ + 1;
    }
    ray_ = next;
    result_.length_m += step_m;
    if (met != nullptr) {
      Project(*met);
      Meet(*met);
    } else if (ray_.slowness.x() <= 0) {
      is_done_ = true;
    }
  }

  /// Returns whether the step ends at the edge or beyond it, or dips below it and comes back; if
  /// so, shortens it to where it first meets the edge.
  /// `has_met`: another edge ends the step already; what is as far within rounding is met later.
  bool MeetWithin(const Edge& edge, bool has_met, double* step_m, RayState* next) const {
    const double before_m = edge.DistanceOf(ray_.at);
    const double leaving = edge.normal.dot(ray_.slowness);
    double far_m = *step_m;
    RayState far = *next;
    if (edge.DistanceOf(far.at) >= 0) {
      if (!(leaving < 0 && edge.normal.dot(far.slowness) > 0)) return false;
      far = Nearest(edge, &far_m);
      if (edge.DistanceOf(far.at) >= 0) return false;
    }
    if (leaving >= 0 && before_m <= kOnEdge_m) {
      // It starts on the edge and leaves it, yet ends beyond: it bent back. It meets it again.
      if (!(edge.normal.dot(far.slowness) < 0)) return false;
    } else if (before_m <= 0) {
      *step_m = 0;
      *next = ray_;
      return true;
    }
    const double at_m = Solve(edge, far_m, &far);
    if (has_met && at_m > *step_m - kOnEdge_m) return false;
    *step_m = at_m;
    *next = far;
    return true;
  }

  /// The place of the step at which the distance to the edge is least.
  RayState Nearest(const Edge& edge, double* step_m) const {
    double low_m = 0;
    double high_m = *step_m;
    RayState state = ray_;
    for (int i = 0; i < kMaxSolves && high_m - low_m > 1e-9; ++i) {
      *step_m = (low_m + high_m) / 2;
      state = StepOf(ray_, cell_, *step_m);
      (edge.normal.dot(state.slowness) < 0 ? low_m : high_m) = *step_m;
      if (edge.DistanceOf(state.at) < 0) break;
    }
    return state;
  }

  /// Returns about where the ray meets the edge, by the parabola through the step's ends and its
  /// slope at the beginning.
  double GuessOf(const Edge& edge, double far_m, const RayState& far) const {
    const double near_distance_m = edge.DistanceOf(ray_.at);
    const double far_distance_m = edge.DistanceOf(far.at);
    const double slope = edge.normal.dot(ray_.slowness) * cell_.At(ray_.at);
    const double bend = (far_distance_m - near_distance_m - slope * far_m) / (far_m * far_m);
    const double root = slope * slope - 4 * bend * near_distance_m;
    if (!(root >= 0)) return far_m;
    const double part = -slope + std::copysign(std::sqrt(root), -slope);
    // Of two places the first, unless the ray leaves the edge and comes back to it.
    const double first_m = part != 0 ? 2 * near_distance_m / part : 0;
    const double other_m = bend != 0 ? part / (2 * bend) : 0;
    if (first_m > kOnEdge_m && first_m < far_m) return first_m;
    return other_m > kOnEdge_m && other_m < far_m ? other_m : far_m;
  }

  /// Returns the length of the step that ends on the edge, and where it ends. @pre `state`, after
  /// `far_m`, is beyond the edge
  double Solve(const Edge& edge, double far_m, RayState* state) const {
    double low_m = 0;
    double high_m = far_m;
    double at_m = GuessOf(edge, far_m, *state);
    if (at_m != far_m) *state = StepOf(ray_, cell_, at_m);
    for (int i = 0; i < kMaxSolves; ++i) {
      const double distance_m = edge.DistanceOf(state->at);
      if (std::abs(distance_m) < 1e-12) break;
      (distance_m > 0 ? low_m : high_m) = at_m;
      const double rate = edge.normal.dot(state->slowness) * cell_.At(state->at);
      double guess_m = at_m - distance_m / rate;
      if (!(guess_m > low_m && guess_m < high_m)) guess_m = (low_m + high_m) / 2;
      if (guess_m == at_m) break;
      at_m = guess_m;
      *state = StepOf(ray_, cell_, at_m);
    }
    return at_m;
  }

  /// Rays of other launch angles meet the edge earlier or later: slopes are taken on the edge.
  void Project(const Edge& edge) {
    const RayState rate = RateOf(ray_, cell_);
    const double along = edge.normal.dot(rate.at);
    if (along == 0) return;
    const double shift = -edge.normal.dot(ray_.at_slope) / along;
    ray_.at_slope += shift * rate.at;
    ray_.slowness_slope += shift * rate.slowness;
  }

  static double TubeOf(const RayState& ray) {
    return ray.slowness.x() * ray.at_slope.y() - ray.slowness.y() * ray.at_slope.x();
  }

  void NoteCaustic(const RayState& next) {
    const double tube = TubeOf(next);
    if (tube * tube_ < 0) ++result_.num_caustics;
    if (tube != 0) tube_ = tube;
  }

  void Meet(const Edge& edge) {
    switch (edge.kind) {
      case Edge::Kind::kRange:
        ray_.at.x() = edge.point.x();
        if (edge.point.x() >= range_m_) return Arrive();
        return EnterColumn(ray_.at.x());
      case Edge::Kind::kLayer: {
        const bool goes_down = &edge == &base_;
        ray_.at.y() = edge.point.y();
        layer_ += goes_down ? 1 : static_cast<size_t>(-1);
        return EnterLayer();
      }
      case Edge::Kind::kSurface:
      case Edge::Kind::kBottom:
        return Bounce(edge);
    }
  }

  void Bounce(const Edge& edge) {
    const double c = cell_.At(ray_.at);
    const double sine = std::min(1.0, std::abs(edge.normal.dot(ray_.slowness)) * c);
    const bool is_surface = edge.kind == Edge::Kind::kSurface;
    const Reflection reflection =
        Reflect(is_surface ? scene_.surface_reflector : scene_.bottom_reflector, Asin(sine),
                {.speed_mps = c, .hz = scene_.hz, .density = scene_.water_density});
    result_.reflection *= reflection.magnitude;
    result_.phase_rad += reflection.phase_rad;
    ++(is_surface ? result_.num_surface : result_.num_bottom);
    result_.history = result_.history * kHashFactor + 2 * edge.piece + (is_surface ? 1 : 2);
    ray_.slowness -= 2 * edge.normal.dot(ray_.slowness) * edge.normal;
    ray_.slowness_slope -= 2 * edge.normal.dot(ray_.slowness_slope) * edge.normal;
    tube_ = TubeOf(ray_);
    if (ray_.slowness.x() <= 0 || result_.reflection < limits_.min_reflection ||
        result_.num_surface + result_.num_bottom > limits_.max_bounces) {
      is_done_ = true;
    }
  }

  void Arrive() {
    is_done_ = true;
    result_.arrived = true;
    result_.depth_m = ray_.at.y();
    result_.arrive_rad = Atan2(ray_.slowness.y(), ray_.slowness.x());
    result_.delay_s = ray_.time_s;
    result_.depth_slope_m = ray_.at_slope.y();
    result_.phase_rad += result_.num_caustics * std::numbers::pi / 2;
  }

  static constexpr uint64_t kHashFactor = 6364136223846793005ULL;
  static constexpr double kFar_m = 1e6;
  static constexpr double kOnEdge_m = 1e-9;

  const RayScene& scene_;
  std::span<const double> ranges_m_;
  const RayLimits& limits_;
  double range_m_;
  std::span<const SpeedPoint> points_;
  RayState ray_;
  TracedRay result_;
  size_t layer_ = 0;
  double column_m_ = 0;
  SpeedCell cell_;
  Edge range_edge_, surface_, bottom_, top_, base_;
  double tube_ = 0;
  bool is_done_ = false;
};

}  // namespace

RayTracer::RayTracer(const RayScene& scene) : scene_(scene) {
  for (const BoundaryPoint& point : scene.surface) ranges_m_.push_back(point.range_m);
  for (const BoundaryPoint& point : scene.bottom) ranges_m_.push_back(point.range_m);
  for (const ProfileAtRange& profile : scene.water) ranges_m_.push_back(profile.range_m);
  std::sort(ranges_m_.begin(), ranges_m_.end());
  ranges_m_.erase(std::unique(ranges_m_.begin(), ranges_m_.end()), ranges_m_.end());
}

TracedRay RayTracer::Trace(const SectionPoint& source, double range_m, double launch_rad,
                           const RayLimits& limits, std::vector<Eigen::Vector2d>* path) const {
  return RayMarch(scene_, ranges_m_, source, range_m, launch_rad, limits).Run(path);
}

}  // namespace shoal
