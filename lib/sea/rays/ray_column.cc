#include "lib/sea/rays/ray_column.h"

#include <algorithm>
#include <cmath>

#include "lib/base/arithmetic/elementary.h"
#include "lib/sea/rays/atanh_over_x.h"

namespace shoal {

namespace {

/// Depths nearer than this are one vertex.
constexpr double kSameDepth_m = 1e-9;

/// asin(x) / x, for |x| < 1.
double AsinOverX(double x) {
  const double square = x * x;
  if (square < 1e-4) {
    return 1 + square * (1.0 / 6 + square * (3.0 / 40 + square * (15.0 / 336)));
  }
  return Asin(std::min(x, 1.0)) / x;
}

}  // namespace

RayColumn::RayColumn(const SoundProfile& profile, double surface_m, double bottom_m,
                     double source_m, double receiver_m) {
  std::vector<double> depths_m = {surface_m, bottom_m, source_m, receiver_m};
  for (const SpeedPoint& point : profile.points()) {
    if (point.depth_m > surface_m && point.depth_m < bottom_m) depths_m.push_back(point.depth_m);
  }
  std::ranges::sort(depths_m);
  for (const double depth_m : depths_m) {
    if (!vertices_.empty() && depth_m - vertices_.back().depth_m <= kSameDepth_m) continue;
    vertices_.push_back({depth_m, profile.SpeedAt(depth_m), 0});
  }
  // The gradient comes from the whole layer, of which a vertex may cut off a thin slice.
  for (size_t i = 0; i + 1 < vertices_.size(); ++i) {
    const double middle_m = (vertices_[i].depth_m + vertices_[i + 1].depth_m) / 2;
    const auto points = profile.points();
    const auto below = std::ranges::upper_bound(points, middle_m, {}, &SpeedPoint::depth_m);
    if (below == points.begin() || below == points.end()) continue;
    const SpeedPoint& above = *std::prev(below);
    vertices_[i].gradient = (below->speed_mps - above.speed_mps) / (below->depth_m - above.depth_m);
  }
  source_ = Find(source_m);
  receiver_ = Find(receiver_m);
}

size_t RayColumn::Find(double depth_m) const {
  const auto above = std::ranges::upper_bound(vertices_, depth_m, {}, &Vertex::depth_m);
  return static_cast<size_t>(above - vertices_.begin()) - 1;
}

/// sin^2 at a vertex is 1 - cos^2(launch) c^2 / cs^2, written so that nothing cancels near 0.
double RayColumn::SquareAt(size_t vertex, double sine) const {
  const double own = vertices_[source_].speed_mps;
  const double c = vertices_[vertex].speed_mps;
  return (sine * sine * c * c - (c - own) * (c + own)) / (own * own);
}

double RayColumn::SineAt(size_t vertex, double launch_rad) const {
  return std::sqrt(std::max(0.0, SquareAt(vertex, Sin(launch_rad))));
}

std::vector<double> RayColumn::CriticalAngles() const {
  const double own = vertices_[source_].speed_mps;
  std::vector<double> angles;
  const auto add = [&](size_t vertex, double* fastest) {
    const double c = vertices_[vertex].speed_mps;
    if (c <= *fastest) return;
    *fastest = c;
    angles.push_back(Asin(std::sqrt((c - own) * (c + own)) / c));
  };
  double fastest = own;
  for (size_t i = source_; i-- > 0;) add(i, &fastest);
  fastest = own;
  for (size_t i = source_ + 1; i < vertices_.size(); ++i) add(i, &fastest);
  fastest = own;
  add(receiver_, &fastest);
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  return angles;
}

RayColumn::Kind RayColumn::KindAt(double launch_rad) const {
  const double sine = Sin(launch_rad);
  const size_t upper = std::min(source_, receiver_);
  const size_t lower = std::max(source_, receiver_);
  for (size_t i = upper; i <= lower; ++i) {
    if (!(SquareAt(i, sine) > 0)) return {};
  }
  Kind kind = {.top = upper, .bottom = lower, .reaches = true};
  while (kind.top > 0 && SquareAt(kind.top - 1, sine) > 0) --kind.top;
  while (kind.bottom < bottom() && SquareAt(kind.bottom + 1, sine) > 0) ++kind.bottom;
  kind.turns_above = kind.top > 0;
  kind.turns_below = kind.bottom < bottom();
  return kind;
}

PathSum RayColumn::Cross(size_t first, size_t last, double sine, double p, bool has_times) const {
  PathSum sum;
  if (first == last) return sum;
  double b = std::sqrt(std::max(0.0, SquareAt(first, sine)));
  for (size_t i = first; i < last; ++i) {
    const double a = b;
    b = std::sqrt(std::max(0.0, SquareAt(i + 1, sine)));
    const double ca = vertices_[i].speed_mps;
    const double cb = vertices_[i + 1].speed_mps;
    const double area = (vertices_[i + 1].depth_m - vertices_[i].depth_m) * (ca + cb);
    const double share = area / (a + b);
    sum.range_m += p * share;
    sum.slope += share / (a * b);
    if (!has_times) continue;
    const double product = a * b;
    const double pca = p * ca;
    // (sin a - sin b) / (1 - sin a sin b), over gradient: its atanh is the time. See PartsAt.
    const double u = share * (1 + product) / (ca * ca + cb * cb - pca * pca * cb * cb);
    sum.time_s += u * AtanhOverX(vertices_[i].gradient * u);
    const double arc = area / (a * cb + b * ca);
    sum.length_m += arc * AsinOverX(std::abs(p * vertices_[i].gradient * arc));
  }
  return sum;
}

void RayColumn::AddTurn(double sine, double p, double gradient, bool has_times, PathSum* sum) {
  const double g = std::abs(gradient);
  sum->range_m += sine / (p * g);
  // Half of what the whole turn adds; before it the slope of the ray grows without bound, and
  // after it comes back from minus infinity.
  sum->slope -= 1 / (g * p * p * sine);
  if (!has_times) return;
  sum->time_s += sine * AtanhOverX(sine) / g;
  sum->length_m += sine * AsinOverX(sine) / (p * g);
}

RayParts RayColumn::PartsAt(double launch_rad, const Kind& kind, bool has_times) const {
  const SineAndCosine launch = SinCos(launch_rad);
  const size_t upper = std::min(source_, receiver_);
  const size_t lower = std::max(source_, receiver_);
  RayParts parts;
  parts.p = launch.cosine / vertices_[source_].speed_mps;
  parts.up = Cross(kind.top, upper, launch.sine, parts.p, has_times);
  parts.between = Cross(upper, lower, launch.sine, parts.p, has_times);
  parts.down = Cross(lower, kind.bottom, launch.sine, parts.p, has_times);
  const auto add_turn = [&](size_t vertex, double gradient, PathSum* sum) {
    const double sine_there = std::sqrt(std::max(0.0, SquareAt(vertex, launch.sine)));
    AddTurn(sine_there, parts.p, gradient, has_times, sum);
  };
  if (kind.turns_above) add_turn(kind.top, vertices_[kind.top - 1].gradient, &parts.up);
  if (kind.turns_below) add_turn(kind.bottom, vertices_[kind.bottom].gradient, &parts.down);
  return parts;
}

bool RayColumn::IsStraightBetween() const {
  const size_t upper = std::min(source_, receiver_);
  const size_t lower = std::max(source_, receiver_);
  for (size_t i = upper; i < lower; ++i) {
    if (vertices_[i].gradient != 0) return false;
  }
  if (upper < lower) return true;
  // At one depth, water of constant speed on either side carries the horizontal ray.
  return (upper > 0 && vertices_[upper - 1].gradient == 0) ||
         (upper < bottom() && vertices_[upper].gradient == 0);
}

}  // namespace shoal
