#include "lib/vehicle/guidance/path_parts.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/check/check.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kSamePoint_m = 1e-6;
/// Turns up to this are left as they are, and curves are made of chords that turn no more.
constexpr double kChordTurn_rad = kPi / 8;
/// Chords of a curve are about this long, the acceptance radius of path_follow.
constexpr double kChord_m = 10;
constexpr double kMaxChordsPerTurn = 72;

double ChordsPerTurn(double radius_m) {
  return std::clamp(std::ceil(2 * kPi * radius_m / kChord_m), 2 * kPi / kChordTurn_rad,
                    kMaxChordsPerTurn);
}

Eigen::Vector3d AtDepth(const Eigen::Vector2d& point_m, double z_m) {
  return {point_m.x(), point_m.y(), z_m};
}

/// What is there before a part.
struct PathSoFar {
  Eigen::Vector3d end_m = Eigen::Vector3d::Zero();
  double psi_rad = 0;
};

JoinedPath PathOfPart(const PointsPart& part, const PathSoFar& /*before*/) {
  return {.path = {part.points_m}};
}

JoinedPath PathOfPart(const RandomPart& part, const PathSoFar& before) {
  RandomPathParams params = part.bounds;
  params.min_turn_rad = -DegToRad(part.max_turn_deg);
  params.max_turn_rad = -DegToRad(part.min_turn_deg);
  params.start_m = part.start_m.value_or(before.end_m);
  params.start_psi_rad =
      part.start_heading_deg ? PsiFromHeading(DegToRad(*part.start_heading_deg)) : before.psi_rad;
  Stream stream(part.seed, "path");
  return {.path = RandomPath(params, stream)};
}

JoinedPath PathOfPart(const LawnmowerPart& part, const PathSoFar& before) {
  SurveyRoute route = part.route;
  route.start_m = before.end_m.head<2>();
  JoinedPath joined{.has_curves = route.turn_radius_m > 0};
  for (const Eigen::Vector2d& point_m : PathAlong(LanesOver(part.area), route)) {
    joined.path.points_m.push_back(AtDepth(point_m, part.depth_m));
  }
  return joined;
}

JoinedPath PathOfPart(const HelixPart& part, const PathSoFar& /*before*/) {
  JoinedPath joined{.has_curves = true};
  const auto chords = static_cast<int>(CountPoints(part)) - 1;
  const double sense = part.clockwise ? 1 : -1;
  for (int i = 0; i <= chords; ++i) {
    const double done = static_cast<double>(i) / chords;
    const double bearing_rad =
        DegToRad(part.start_bearing_deg) + sense * 2 * kPi * part.turns * done;
    joined.path.points_m.push_back(
        AtDepth(part.center_m + part.radius_m * UnitVector(bearing_rad),
                part.start_depth_m + done * (part.end_depth_m - part.start_depth_m)));
  }
  return joined;
}

JoinedPath PathOfPart(const YoyoPart& part, const PathSoFar& before) {
  const Eigen::Vector3d start_m = part.start_m.value_or(before.end_m);
  const double slope = Tan(DegToRad(part.glide_deg));
  const Eigen::Vector2d way_m = part.to_m - start_m.head<2>();
  const double length_m = way_m.norm();
  JoinedPath joined{.path = {{start_m}}};
  double done_m = 0;
  double z_m = start_m.z();
  bool is_down = z_m < part.bottom_m;
  while (done_m < length_m) {
    const double next_m = is_down ? part.bottom_m : part.top_m;
    const double glide_m = std::abs(next_m - z_m) / slope;
    const double left_m = length_m - done_m;
    const bool is_last = glide_m >= left_m;
    z_m = is_last ? z_m + std::copysign(left_m * slope, next_m - z_m) : next_m;
    done_m = is_last ? length_m : done_m + glide_m;
    joined.path.points_m.push_back(AtDepth(start_m.head<2>() + way_m * (done_m / length_m), z_m));
    is_down = !is_down;
  }
  return joined;
}

/// Returns where a part begins that is put before point `place`, and on what course.
PathSoFar Before(const std::vector<Eigen::Vector3d>& points_m, size_t place,
                 const PathStart& start) {
  PathSoFar before{.end_m = start.position_m, .psi_rad = PsiFromHeading(start.heading_rad)};
  if (place == 0) return before;
  before.end_m = points_m[place - 1];
  const std::vector<double> psis_rad =
      LegPsis_rad({{points_m.begin(), points_m.begin() + static_cast<std::ptrdiff_t>(place)}});
  if (!psis_rad.empty()) before.psi_rad = psis_rad.back();
  return before;
}

/// Returns the points of the arc around a corner, none where it is left as it is.
std::vector<Eigen::Vector3d> ArcAt(const Eigen::Vector3d& from_m, const Eigen::Vector3d& corner_m,
                                   const Eigen::Vector3d& to_m, double radius_m) {
  const Eigen::Vector2d in_m = (corner_m - from_m).head<2>();
  const Eigen::Vector2d out_m = (to_m - corner_m).head<2>();
  const double room_m = std::min(in_m.norm(), out_m.norm()) / 2;
  if (room_m < kSamePoint_m) return {};
  const double heading_rad = HeadingOf(in_m);
  const double turn_rad = WrapPi(HeadingOf(out_m) - heading_rad);
  constexpr double kRightRound_rad = kPi * 0.999;
  if (std::abs(turn_rad) <= kChordTurn_rad || std::abs(turn_rad) > kRightRound_rad) return {};
  const double tangent_m = std::min(radius_m * Tan(std::abs(turn_rad) / 2), room_m);
  const double arc_radius_m = tangent_m / Tan(std::abs(turn_rad) / 2);
  const double side = turn_rad > 0 ? 1 : -1;
  const Eigen::Vector2d begin_m = corner_m.head<2>() - tangent_m * in_m.normalized();
  const Eigen::Vector2d center_m =
      begin_m + side * arc_radius_m * UnitVector(heading_rad + kPi / 2);
  const double chord_rad = 2 * kPi / ChordsPerTurn(arc_radius_m);
  const auto chords = static_cast<int>(std::ceil(std::abs(turn_rad) / chord_rad));
  std::vector<Eigen::Vector3d> arc_m;
  for (int i = 0; i <= chords; ++i) {
    const double course_rad = heading_rad + turn_rad * i / chords;
    arc_m.push_back(
        AtDepth(center_m - side * arc_radius_m * UnitVector(course_rad + kPi / 2), corner_m.z()));
  }
  return arc_m;
}

template <size_t... kPlaces>
std::vector<PathPart> PartsAt(std::index_sequence<kPlaces...> /*places*/) {
  using What = decltype(PathPart::what);
  return {PathPart{.what = What(std::in_place_index<kPlaces>)}...};
}

}  // namespace

std::vector<PathPart> OnePartOfEachKind() {
  return PartsAt(std::make_index_sequence<std::variant_size_v<decltype(PathPart::what)>>());
}

std::string_view KindOf(const PathPart& part) {
  return std::visit([](const auto& what) { return std::decay_t<decltype(what)>::kKind; },
                    part.what);
}

JoinedPath Join(const std::vector<PathPart>& parts, const PathStart& start) {
  JoinedPath joined;
  std::vector<Eigen::Vector3d>& points_m = joined.path.points_m;
  for (const PathPart& part : parts) {
    const size_t place = std::min(part.insert_at.value_or(points_m.size()), points_m.size());
    const PathSoFar before = Before(points_m, place, start);
    JoinedPath next =
        std::visit([&](const auto& what) { return PathOfPart(what, before); }, part.what);
    std::vector<Eigen::Vector3d>& more_m = next.path.points_m;
    const auto is_same = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return (a - b).norm() < kSamePoint_m;
    };
    if (place > 0 && !more_m.empty() && is_same(points_m[place - 1], more_m.front())) {
      more_m.erase(more_m.begin());
    }
    if (place < points_m.size() && !more_m.empty() && is_same(points_m[place], more_m.back())) {
      more_m.pop_back();
    }
    points_m.insert(points_m.begin() + static_cast<std::ptrdiff_t>(place), more_m.begin(),
                    more_m.end());
    joined.has_curves = joined.has_curves || next.has_curves;
  }
  return joined;
}

double CountPoints(const HelixPart& part) {
  return std::max(1.0, std::ceil(part.turns * ChordsPerTurn(part.radius_m))) + 1;
}

double CountPoints(const YoyoPart& part, const Eigen::Vector3d& start_m) {
  const double glide_m = (part.bottom_m - part.top_m) / Tan(DegToRad(part.glide_deg));
  return 3 + (part.to_m - start_m.head<2>()).norm() / glide_m;
}

JoinedPath RoundCorners(const JoinedPath& joined, double radius_m) {
  SHOAL_CHECK(radius_m > 0, "a turn has a radius");
  const std::vector<Eigen::Vector3d>& points_m = joined.path.points_m;
  JoinedPath rounded{.has_curves = joined.has_curves};
  for (size_t i = 0; i < points_m.size(); ++i) {
    std::vector<Eigen::Vector3d> arc_m;
    if (i > 0 && i + 1 < points_m.size()) {
      arc_m = ArcAt(points_m[i - 1], points_m[i], points_m[i + 1], radius_m);
    }
    if (arc_m.empty()) arc_m = {points_m[i]};
    rounded.has_curves = rounded.has_curves || arc_m.size() > 1;
    rounded.path.points_m.insert(rounded.path.points_m.end(), arc_m.begin(), arc_m.end());
  }
  return rounded;
}

}  // namespace shoal
