#include "lib/vehicle/guidance/dubins.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

/// Returns the equal angle in [0, 2 pi), where what rounding leaves of a whole turn is none.
double TurnAngle(double angle_rad) {
  constexpr double kRounding_rad = 1e-9;
  const double wrapped_rad = WrapTwoPi(angle_rad);
  return wrapped_rad > 2 * kPi - kRounding_rad ? 0 : wrapped_rad;
}

/// The names of the source: radius 1, from the origin at the angle alpha to (d, 0) at beta, angles
/// counter-clockwise from the x axis. L turns counter-clockwise, to port.
struct Problem {
  double d, alpha, beta;
  double sa = Sin(alpha), ca = Cos(alpha);
  double sb = Sin(beta), cb = Cos(beta);
  double cab = Cos(alpha - beta);
};

/// The lengths of the three parts; an arc's is its angle.
struct Word {
  std::array<int, 3> turns;
  double t, p, q;
};

constexpr int kL = -1;
constexpr int kS = 0;
constexpr int kR = 1;

std::optional<double> Root(double square) {
  if (square < 0) return std::nullopt;
  return std::sqrt(square);
}

std::optional<Word> Lsl(const Problem& w) {
  const auto p = Root(2 + w.d * w.d - 2 * w.cab + 2 * w.d * (w.sa - w.sb));
  if (!p) return std::nullopt;
  const double angle_rad = Atan2(w.cb - w.ca, w.d + w.sa - w.sb);
  return Word{{kL, kS, kL}, TurnAngle(angle_rad - w.alpha), *p, TurnAngle(w.beta - angle_rad)};
}

std::optional<Word> Rsr(const Problem& w) {
  const auto p = Root(2 + w.d * w.d - 2 * w.cab + 2 * w.d * (w.sb - w.sa));
  if (!p) return std::nullopt;
  const double angle_rad = Atan2(w.ca - w.cb, w.d - w.sa + w.sb);
  return Word{{kR, kS, kR}, TurnAngle(w.alpha - angle_rad), *p, TurnAngle(angle_rad - w.beta)};
}

std::optional<Word> Lsr(const Problem& w) {
  const auto p = Root(-2 + w.d * w.d + 2 * w.cab + 2 * w.d * (w.sa + w.sb));
  if (!p) return std::nullopt;
  const double angle_rad = Atan2(-w.ca - w.cb, w.d + w.sa + w.sb) - Atan2(-2.0, *p);
  return Word{{kL, kS, kR}, TurnAngle(angle_rad - w.alpha), *p, TurnAngle(angle_rad - w.beta)};
}

std::optional<Word> Rsl(const Problem& w) {
  const auto p = Root(-2 + w.d * w.d + 2 * w.cab - 2 * w.d * (w.sa + w.sb));
  if (!p) return std::nullopt;
  const double angle_rad = Atan2(w.ca + w.cb, w.d - w.sa - w.sb) - Atan2(2.0, *p);
  return Word{{kR, kS, kL}, TurnAngle(w.alpha - angle_rad), *p, TurnAngle(w.beta - angle_rad)};
}

std::optional<Word> Rlr(const Problem& w) {
  const double cosine = (6 - w.d * w.d + 2 * w.cab + 2 * w.d * (w.sa - w.sb)) / 8;
  if (std::abs(cosine) > 1) return std::nullopt;
  const double p = TurnAngle(2 * kPi - Acos(cosine));
  const double t = TurnAngle(w.alpha - Atan2(w.ca - w.cb, w.d - w.sa + w.sb) + p / 2);
  return Word{{kR, kL, kR}, t, p, TurnAngle(w.alpha - w.beta - t + p)};
}

std::optional<Word> Lrl(const Problem& w) {
  const double cosine = (6 - w.d * w.d + 2 * w.cab + 2 * w.d * (w.sb - w.sa)) / 8;
  if (std::abs(cosine) > 1) return std::nullopt;
  const double p = TurnAngle(2 * kPi - Acos(cosine));
  const double t = TurnAngle(-w.alpha + Atan2(w.cb - w.ca, w.d + w.sa - w.sb) + p / 2);
  return Word{{kL, kR, kL}, t, p, TurnAngle(w.beta - w.alpha - t + p)};
}

/// Moves `pose` along `length_m` of a part.
void MoveAlong(const DubinsPart& part, double length_m, double radius_m, TurnPose* pose) {
  if (part.turn == 0) {
    pose->position_m += length_m * UnitVector(pose->heading_rad);
    return;
  }
  const double turn_rad = part.turn * length_m / radius_m;
  // The chord points half of the turn away.
  const double chord_m = 2 * radius_m * Sin(length_m / radius_m / 2);
  pose->position_m += chord_m * UnitVector(pose->heading_rad + turn_rad / 2);
  pose->heading_rad += turn_rad;
}

}  // namespace

double DubinsWay::Length_m() const {
  return parts[0].length_m + parts[1].length_m + parts[2].length_m;
}

DubinsWay ShortestWay(const TurnPose& from, const TurnPose& to, double radius_m) {
  const Eigen::Vector2d way_m = to.position_m - from.position_m;
  const double bearing_rad = HeadingOf(way_m);
  // Headings count clockwise, the angles of the source the other way.
  const Problem problem{.d = way_m.norm() / radius_m,
                        .alpha = WrapPi(bearing_rad - from.heading_rad),
                        .beta = WrapPi(bearing_rad - to.heading_rad)};
  DubinsWay best{.from = from, .radius_m = radius_m, .parts = {}};
  double best_length = std::numeric_limits<double>::infinity();
  for (const auto& word :
       {Lsl(problem), Rsr(problem), Lsr(problem), Rsl(problem), Rlr(problem), Lrl(problem)}) {
    if (!word || word->t + word->p + word->q >= best_length) continue;
    best_length = word->t + word->p + word->q;
    best.parts = {DubinsPart{word->turns[0], radius_m * word->t},
                  DubinsPart{word->turns[1], radius_m * word->p},
                  DubinsPart{word->turns[2], radius_m * word->q}};
  }
  return best;
}

std::vector<Eigen::Vector2d> PointsAlong(const DubinsWay& way) {
  constexpr double kStep_rad = kPi / 8;
  std::vector<Eigen::Vector2d> points_m;
  TurnPose pose = way.from;
  for (const DubinsPart& part : way.parts) {
    if (part.length_m <= 0) continue;
    const double steps =
        part.turn == 0 ? 1 : std::max(1.0, std::ceil(part.length_m / way.radius_m / kStep_rad));
    for (int i = 0; i < static_cast<int>(steps); ++i) {
      MoveAlong(part, part.length_m / steps, way.radius_m, &pose);
      points_m.push_back(pose.position_m);
    }
  }
  return points_m;
}

}  // namespace shoal
