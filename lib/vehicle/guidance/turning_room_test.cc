#include "lib/vehicle/guidance/turning_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::turning_room_test {

/// What a law wants, relative to the water: `course_deg` clockwise from North.
TrackCommand Wanted(double course_deg, double speed_mps) {
  const double psi_rad = PsiFromHeading(DegToRad(course_deg));
  return CommandOf(speed_mps * Eigen::Vector3d(std::cos(psi_rad), std::sin(psi_rad), 0), psi_rad,
                   kPi / 4);
}

/// Echoes of a wall along a meridian, `ahead_m` to the East, from 40 m South to 40 m North.
std::vector<SonarEcho> WallToTheEast(double ahead_m) {
  std::vector<SonarEcho> echoes = {};
  for (int y_m = -40; y_m <= 40; y_m += 2) {
    const Eigen::Vector3d echo_m(ahead_m, y_m, 0);
    echoes.push_back({.direction = echo_m.normalized(), .range_m = echo_m.norm()});
  }
  return echoes;
}

/// A vehicle that heads East.
struct Eastbound {
  TurningRoom room = {};
  std::vector<SonarEcho> echoes = {};
  Surroundings seen = {};

  TrackCommand Limit(TrackCommand command) {
    seen.sonar = echoes;
    room.Limit(seen, /*psi_rad=*/0, /*u_max_mps=*/2.5, &command);
    return command;
  }
};

double CourseDeg(const TrackCommand& command) {
  return RadToDeg(HeadingFromPsi(command.psi_d_rad));
}

TEST(TurningRoom, LimitsNothingInOpenWater) {
  Eastbound vehicle;
  const TrackCommand command = vehicle.Limit(Wanted(260, 2));
  EXPECT_NEAR(command.speed_mps, 2, 1e-9);
  EXPECT_NEAR(CourseDeg(command), 260, 1e-9);
}

TEST(TurningRoom, LimitsNothingBesideAWallThatItDoesNotTurnTo) {
  Eastbound vehicle{.echoes = WallToTheEast(30)};
  EXPECT_NEAR(vehicle.Limit(Wanted(100, 2)).speed_mps, 2, 1e-9);
}

TEST(TurningRoom, GivesOnlyTheSpeedAlongTheBowWhereATurnWouldLeadIntoAWall) {
  Eastbound near{.echoes = WallToTheEast(9)};
  EXPECT_NEAR(near.Limit(Wanted(150, 2)).speed_mps, 2 * std::cos(DegToRad(60)), 1e-9);
  EXPECT_NEAR(near.Limit(Wanted(200, 2)).speed_mps, 0, 1e-9) << "never astern";
  EXPECT_FALSE(near.room.goes_back());
  Eastbound far{.echoes = WallToTheEast(60)};
  EXPECT_NEAR(far.Limit(Wanted(200, 2)).speed_mps, 2, 1e-9);
}

TEST(TurningRoom, HasNoRoomBehindAWallThatIsCloserThanItsWayStraightOn) {
  for (double ahead_m = 0.5; ahead_m < 10; ahead_m += 0.5) {
    Eastbound vehicle{.echoes = WallToTheEast(ahead_m)};
    EXPECT_EQ(vehicle.Limit(Wanted(200, 2)).speed_mps, 0) << ahead_m;
  }
}

TEST(TurningRoom, StaysFiniteWithAnEchoAtItsOwnPlace) {
  Eastbound vehicle{.echoes = {{.direction = {1, 0, 0}, .range_m = 0}}};
  const TrackCommand command = vehicle.Limit(Wanted(200, 2));
  EXPECT_TRUE(std::isfinite(command.speed_mps) && std::isfinite(command.psi_d_rad));
}

TEST(TurningRoom, TurnsWithSteerageWayWhereItHasRoom) {
  Eastbound vehicle{.echoes = WallToTheEast(60)};
  EXPECT_NEAR(vehicle.Limit(Wanted(200, 0.3)).speed_mps, 1.5, 1e-9);
  EXPECT_NEAR(vehicle.Limit(Wanted(95, 0.3)).speed_mps, 0.3, 1e-9) << "it hardly turns";
}

TEST(TurningRoom, GoesBackBeforeItIsTooCloseToTurn) {
  Eastbound vehicle{.echoes = WallToTheEast(50)};
  vehicle.Limit(Wanted(90, 0.3));
  EXPECT_FALSE(vehicle.room.goes_back()) << "far";
  vehicle.echoes = WallToTheEast(31);
  vehicle.Limit(Wanted(92, 2));
  EXPECT_FALSE(vehicle.room.goes_back()) << "it makes way";
  // It creeps at the wall, in a current that sets it North: it turns away with the propeller on.
  vehicle.seen.current_mps = {0, 0.5, 0};
  vehicle.echoes = WallToTheEast(13);
  vehicle.Limit(Wanted(92, 0.3));
  EXPECT_FALSE(vehicle.room.goes_back()) << "too late";
  for (double ahead_m = 45; ahead_m > 13 && !vehicle.room.goes_back(); --ahead_m) {
    vehicle.echoes = WallToTheEast(ahead_m);
    vehicle.Limit(Wanted(170, 0.3));
  }
  ASSERT_TRUE(vehicle.room.goes_back());
  const TrackCommand back = vehicle.Limit(Wanted(170, 0.3));
  EXPECT_NEAR(back.speed_mps, 1.5, 1e-9);
  EXPECT_NEAR(std::abs(WrapPi(back.psi_d_rad)), kPi / 2, 1e-9);
  // Until where the law wants it to go there is room again.
  vehicle.echoes = WallToTheEast(60);
  vehicle.Limit(Wanted(170, 1));
  EXPECT_FALSE(vehicle.room.goes_back());
}

TEST(TurningRoom, GoesBackWhereTheLawSlowsItTowardAWall) {
  for (const double wanted_mps : {1.0, 1.6}) {
    Eastbound vehicle;
    for (double ahead_m = 45; ahead_m > 31 && !vehicle.room.goes_back(); --ahead_m) {
      vehicle.echoes = WallToTheEast(ahead_m);
      vehicle.Limit(Wanted(92, wanted_mps));
    }
    EXPECT_EQ(vehicle.room.goes_back(), wanted_mps < 1.2) << wanted_mps;
  }
  // Carried along the wall it does not come closer.
  Eastbound carried{.echoes = WallToTheEast(32)};
  carried.seen.current_mps = {-0.5, 1, 0};
  carried.Limit(Wanted(92, 1));
  EXPECT_FALSE(carried.room.goes_back());
}

TEST(TurningRoom, TakesEchoesAboveAndBelowForNoObstacle) {
  Eastbound vehicle{.echoes = WallToTheEast(9)};
  for (SonarEcho& echo : vehicle.echoes) {
    const Eigen::Vector3d echo_m = echo.range_m * echo.direction + Eigen::Vector3d(0, 0, 4);
    echo = {.direction = echo_m.normalized(), .range_m = echo_m.norm()};
  }
  EXPECT_NEAR(vehicle.Limit(Wanted(200, 2)).speed_mps, 2, 1e-9);
}

}  // namespace shoal::turning_room_test
