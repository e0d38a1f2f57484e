#include "lib/vehicle/guidance/turning_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/vehicle/guidance/velocity_layers.h"

namespace shoal {

namespace {

// Of a Remus 100 with its rudder hard over, from 0.5 to 1.5 m/s: what it goes before it turns, and
// the circle on which it then does.
constexpr double kStraightOn_m = 8;
constexpr double kTurnRadius_m = 18;
constexpr double kSteerage_mps = 1.5;  ///< Slower, fins turn it on a wider circle.
constexpr double kSlow_mps = 0.8;      ///< Slower than this, they hardly do.
constexpr double kLosesWay_mps = 1.2;  ///< Slower than this toward a wall, it will be too slow.

constexpr double kTouch_m = 3;  ///< With less room than this it does not turn.
constexpr double kRoom_m = 8;   ///< As much room as this it keeps, to go back.
constexpr double kFar_m = 40;   ///< Echoes from here on do not matter.
constexpr double kWideTurn_rad = DegToRad(60);
constexpr double kAhead_rad = DegToRad(90);  ///< While it goes back: the course is this far ahead.
constexpr double kToward = 0.87;             ///< Cosine of 30 degrees.
constexpr double kArcStep_rad = DegToRad(15);
constexpr double kStraightStep_m = 2;

using Points = std::vector<Eigen::Vector2d>;

/// Returns the echoes in its way, horizontally from the vehicle.
Points Obstacles(const Surroundings& surroundings) {
  Points points_m;
  for (const SonarEcho& echo : surroundings.sonar) {
    const Eigen::Vector3d echo_m = std::max(echo.range_m, 0.0) * echo.direction;
    if (std::abs(echo_m.z()) < kEchoHeight_m && echo.range_m < kFar_m + 2 * kTurnRadius_m) {
      points_m.emplace_back(echo_m.head<2>());
    }
  }
  return points_m;
}

/// Returns how near the turn by `turn_rad` leads past the obstacles, with its way straight on.
double RoomFor(const Points& obstacles_m, const Eigen::Vector2d& current_mps, double psi_rad,
               double turn_rad) {
  const double side = turn_rad < 0 ? -1 : 1;
  const auto [sine_0, cosine_0] = SinCos(psi_rad);
  const Eigen::Vector2d bow(cosine_0, sine_0);
  double square_m2 = std::numeric_limits<double>::infinity();
  const auto look = [&](const Eigen::Vector2d& at_m, double way_m) {
    const Eigen::Vector2d carried_m = at_m + way_m / kSteerage_mps * current_mps;
    for (const Eigen::Vector2d& each_m : obstacles_m) {
      square_m2 = std::min(square_m2, (each_m - carried_m).squaredNorm());
    }
  };
  for (int i = 1; i * kStraightStep_m < kStraightOn_m; ++i) {
    look(i * kStraightStep_m * bow, i * kStraightStep_m);
  }
  const int num_steps = static_cast<int>(std::ceil(std::abs(turn_rad) / kArcStep_rad));
  for (int i = 0; i <= num_steps; ++i) {
    const double turned_rad = std::min(i * kArcStep_rad, std::abs(turn_rad));
    const auto [sine, cosine] = SinCos(psi_rad + side * turned_rad);
    look(kStraightOn_m * bow +
             side * kTurnRadius_m * Eigen::Vector2d(sine - sine_0, cosine_0 - cosine),
         kStraightOn_m + kTurnRadius_m * turned_rad);
  }
  return std::sqrt(square_m2);
}

/// Whether it goes about toward `to_m`, over the ground.
bool GoesToward(const Eigen::Vector2d& to_m, const Eigen::Vector2d& ground_mps) {
  return ground_mps.dot(to_m) > kToward * ground_mps.norm() * to_m.norm();
}

}  // namespace

void TurningRoom::Limit(const Surroundings& surroundings, double psi_rad, double u_max_mps,
                        TrackCommand* command) {
  const Points obstacles_m = Obstacles(surroundings);
  if (obstacles_m.empty()) {
    side_ = 0;
    return;
  }
  const Eigen::Vector2d current_mps = surroundings.current_mps.head<2>();
  const auto nearest = std::min_element(
      obstacles_m.begin(), obstacles_m.end(),
      [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
  const double turn_rad = WrapPi(command->psi_d_rad - psi_rad);
  const bool is_wide = std::abs(turn_rad) > kWideTurn_rad;
  const double bow_mps = command->SpeedAlongBow_mps(psi_rad);
  const double room_m = RoomFor(obstacles_m, current_mps, psi_rad, turn_rad);
  const double away_rad = Atan2(-nearest->y(), -nearest->x());
  const double steerage_mps = std::min(kSteerage_mps, u_max_mps);

  if (side_ != 0 && room_m >= kRoom_m && (is_wide || bow_mps >= kSlow_mps)) side_ = 0;
  const auto [sine, cosine] = SinCos(psi_rad);
  // A law that slows before a wall loses the way that a turn needs.
  const bool loses_way =
      bow_mps < kLosesWay_mps &&
      GoesToward(*nearest, current_mps + bow_mps * Eigen::Vector2d(cosine, sine));
  if (side_ == 0 && nearest->norm() < kFar_m && (bow_mps < kSlow_mps || is_wide || loses_way)) {
    const double back_rad = WrapPi(away_rad - psi_rad);
    const double back_room_m = RoomFor(obstacles_m, current_mps, psi_rad, back_rad);
    const bool may_stick = bow_mps < kSlow_mps || room_m < kRoom_m || loses_way;
    if (may_stick && back_room_m >= kTouch_m && back_room_m < kRoom_m) {
      side_ = back_rad < 0 ? -1 : 1;
    }
  }
  if (side_ != 0) {
    const double back_rad = WrapPi(away_rad - psi_rad);
    const double on_side_rad = std::abs(back_rad) < kAhead_rad ? back_rad : side_ * kAhead_rad;
    command->psi_d_rad = WrapPi(psi_rad + on_side_rad);
    command->speed_mps = steerage_mps;
    return;
  }
  command->speed_mps =
      room_m >= kTouch_m ? std::max(command->speed_mps, is_wide ? steerage_mps : 0) : bow_mps;
}

}  // namespace shoal
