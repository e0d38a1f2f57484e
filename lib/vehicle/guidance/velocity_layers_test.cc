#include "lib/vehicle/guidance/velocity_layers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/vehicle/guidance/vectors_testing.h"

namespace shoal::velocity_layers_test {

using Eigen::Vector3d;

constexpr double kUMax_mps = 2.5;

// Returns the speed toward a target `range_m` to the East.
double FormationSpeed(double range_m) {
  TargetScene scene;
  scene.target.position_m = {range_m, 0, 0};
  const Vector3d v_mps = LayerVelocity(FormationLayer{}, kUMax_mps, scene.Seen());
  EXPECT_EQ(v_mps.y(), 0);
  EXPECT_EQ(v_mps.z(), 0);
  return v_mps.x();
}

TEST(FormationLayer, HasItsFiveZones) {
  EXPECT_EQ(FormationSpeed(5), -kUMax_mps);
  EXPECT_EQ(FormationSpeed(10), -kUMax_mps);
  EXPECT_NEAR(FormationSpeed(45), -kUMax_mps / 8, 1e-12);
  EXPECT_EQ(FormationSpeed(80), 0);
  EXPECT_EQ(FormationSpeed(100), 0);
  EXPECT_EQ(FormationSpeed(120), 0);
  EXPECT_NEAR(FormationSpeed(155), kUMax_mps / 8, 1e-12);
  EXPECT_EQ(FormationSpeed(190), kUMax_mps);
  EXPECT_EQ(FormationSpeed(1e6), kUMax_mps);
}

RC_GTEST_PROP(FormationLayer, HasNoJumpAtItsBorders, ()) {
  const double border_m = *rc::gen::element(10.0, 80.0, 120.0, 190.0);
  RC_ASSERT(std::abs(FormationSpeed(border_m - 1e-6) - FormationSpeed(border_m + 1e-6)) < 1e-6);
}

TEST(FormationLayer, PartsVehiclesThatCoincideInOppositeDirections) {
  TargetScene scene;
  scene.own.id = 1;
  scene.target.id = 2;
  const Vector3d one_mps = LayerVelocity(FormationLayer{}, kUMax_mps, scene.Seen());
  std::swap(scene.own, scene.target);
  const Vector3d other_mps = LayerVelocity(FormationLayer{}, kUMax_mps, scene.Seen());
  EXPECT_EQ(one_mps.norm(), kUMax_mps);
  EXPECT_EQ(one_mps, -other_mps);
}

TEST(Layers, DoNothingWithoutAnybodyThere) {
  const Surroundings alone{.own = {.id = 3}};
  EXPECT_EQ(LayerVelocity(FeedForwardLayer{}, kUMax_mps, alone), Vector3d::Zero());
  EXPECT_EQ(LayerVelocity(FormationLayer{}, kUMax_mps, alone), Vector3d::Zero());
  EXPECT_EQ(LayerVelocity(SurvivalLayer{}, kUMax_mps, alone), Vector3d::Zero());
}

TEST(FeedForwardLayer, MovesAsTheTargetDoes) {
  TargetScene scene;
  scene.target.velocity_mps = {1, -2, 0.3};
  EXPECT_EQ(LayerVelocity(FeedForwardLayer{}, kUMax_mps, scene.Seen()), Vector3d(1, -2, 0.3));
}

TEST(SurvivalGroupLayer, RepelsAtFullSpeedInsideTheSafeDistance) {
  TargetScene scene;
  scene.group = {{.id = 2, .position_m = {0, 9, 0}}};
  EXPECT_EQ(LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen()),
            Vector3d(0, -kUMax_mps, 0));
  scene.group[0].position_m.y() = 25;
  EXPECT_NEAR(LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen()).y(), -kUMax_mps / 8,
              1e-12);
}

TEST(SurvivalGroupLayer, StandsStillBetweenTwoThatAreEquallyNear) {
  TargetScene scene;
  scene.group = {{.id = 2, .position_m = {0, 15, 0}}, {.id = 3, .position_m = {0, -15, 0}}};
  EXPECT_NEAR(LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen()).norm(), 0, 1e-12);
}

TEST(SurvivalGroupLayer, PartsVehiclesThatCoincide) {
  TargetScene scene;
  scene.group = {{.id = 7}};
  const Vector3d v_mps = LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen());
  EXPECT_EQ(v_mps, Vector3d(-kUMax_mps, 0, 0));
  std::swap(scene.own, scene.group[0]);
  EXPECT_EQ(LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen()), -v_mps);
}

RC_GTEST_PROP(SurvivalGroupLayer, DoesNothingOutsideItsZone, ()) {
  TargetScene scene = AnyTargetScene();
  scene.sonar.clear();
  for (Neighbour& member : scene.group) {
    const Vector3d offset_m = member.position_m - scene.own.position_m;
    RC_PRE(offset_m.norm() > 1e-3);
    member.position_m = scene.own.position_m + offset_m.normalized() * DrawBetween(40.001, 1000);
  }
  RC_ASSERT(LayerVelocity(SurvivalLayer{}, kUMax_mps, scene.Seen()) == Vector3d::Zero());
}

TEST(SurvivalSonarLayer, MovesAwayFromTheEcho) {
  TargetScene scene;
  scene.sonar = {{.direction = Vector3d::UnitX(), .range_m = 20}};
  EXPECT_NEAR(LayerVelocity(SurvivalSonarLayer{}, kUMax_mps, scene.Seen()).x(), -kUMax_mps / 8,
              1e-12);
  scene.sonar[0].range_m = 40;
  EXPECT_EQ(LayerVelocity(SurvivalSonarLayer{}, kUMax_mps, scene.Seen()), Vector3d::Zero());
}

RC_GTEST_PROP(SurvivalSonarLayer, IsNoStrongerForMoreBeamsOnTheSameObstacle, ()) {
  TargetScene scene = AnyTargetScene();
  const Vector3d once_mps = LayerVelocity(SurvivalSonarLayer{}, kUMax_mps, scene.Seen());
  const std::vector<SonarEcho> echoes = scene.sonar;
  scene.sonar.insert(scene.sonar.end(), echoes.begin(), echoes.end());
  const Vector3d twice_mps = LayerVelocity(SurvivalSonarLayer{}, kUMax_mps, scene.Seen());
  RC_ASSERT((once_mps - twice_mps).norm() < 1e-12);
}

RC_GTEST_PROP(Layers, TurnWithTheWorldAndKeepToTheirLimit, ()) {
  const TargetScene scene = AnyTargetScene();
  const double angle_rad = DrawBetween(-3.1, 3.1);
  const TargetScene turned = scene.Turned(angle_rad);
  const std::vector<VelocityLayer> layers = {FeedForwardLayer{}, FormationLayer{},
                                             SurvivalGroupLayer{}, SurvivalSonarLayer{},
                                             SurvivalLayer{}};
  for (const VelocityLayer& layer : layers) {
    const auto velocity = [&](const TargetScene& seen) {
      return std::visit(
          [&](const auto& which) { return LayerVelocity(which, kUMax_mps, seen.Seen()); }, layer);
    };
    const Vector3d v_mps = velocity(scene);
    RC_ASSERT((velocity(turned) - AboutZ(angle_rad) * v_mps).norm() < 1e-8);
    if (std::holds_alternative<FeedForwardLayer>(layer)) continue;  // As fast as the target.
    RC_ASSERT(v_mps.norm() <= kUMax_mps * (1 + 1e-12));
  }
}

TEST(Layers, RefuseWhatIsNoNumber) {
  TargetScene scene;
  scene.group = {{.id = 2, .position_m = {0, std::numeric_limits<double>::quiet_NaN(), 0}}};
  EXPECT_DEATH((void)LayerVelocity(SurvivalGroupLayer{}, kUMax_mps, scene.Seen()),
               "inputs of guidance are finite");
}

/// A vehicle that goes East at 2 m/s, and one echo.
Surroundings EchoAhead(const std::vector<SonarEcho>& echoes) {
  return {.own = {.id = 1, .velocity_mps = {2, 0, 0}}, .sonar = echoes};
}

SonarEcho EchoAt(const Vector3d& way_m) {
  return {.direction = way_m.normalized(), .range_m = way_m.norm()};
}

Vector3d SonarVelocity(const std::vector<SonarEcho>& echoes, double r_pass_m) {
  return LayerVelocity(SurvivalSonarLayer{.r_avoid_m = 40, .r_pass_m = r_pass_m}, kUMax_mps,
                       EchoAhead(echoes));
}

TEST(Sidestep, GoesToStarboardOfWhatLiesDeadAhead) {
  const Vector3d without_mps = SonarVelocity({EchoAt({20, 0, 0})}, 0);
  const Vector3d with_mps = SonarVelocity({EchoAt({20, 0, 0})}, 10);
  EXPECT_EQ(without_mps.y(), 0);
  // y is North: to port of a vehicle that goes East. 1 - (20 / 40)^2, and nothing abeam.
  EXPECT_NEAR(with_mps.y(), -kUMax_mps * 0.75, 1e-12);
  EXPECT_NEAR(with_mps.x(), without_mps.x(), 1e-12) << "the repulsion stays";
}

TEST(Sidestep, GoesToTheSideAwayFromWhatLiesAbeam) {
  const double to_port_mps = SonarVelocity({EchoAt({20, -4, 0})}, 10).y();
  const double to_starboard_mps = SonarVelocity({EchoAt({20, 4, 0})}, 10).y();
  EXPECT_GT(to_port_mps, 0.5);
  EXPECT_NEAR(to_port_mps, -to_starboard_mps, 1e-12);
}

TEST(Sidestep, GoesToTheEmptierSideOfAWall) {
  std::vector<SonarEcho> wall;
  for (int y_m = -9; y_m <= 3; y_m += 2) wall.push_back(EchoAt({20, static_cast<double>(y_m), 0}));
  EXPECT_GT(SonarVelocity(wall, 10).y(), 1) << "most of it lies to starboard";
}

TEST(Sidestep, LeavesAloneWhatIsNotInTheWay) {
  const auto aside_mps = [](const Vector3d& way_m) {
    return (SonarVelocity({EchoAt(way_m)}, 10) - SonarVelocity({EchoAt(way_m)}, 0)).norm();
  };
  EXPECT_GT(aside_mps({20, 9, 0}), 0);
  EXPECT_EQ(aside_mps({20, 10.5, 0}), 0) << "it is passed far enough";
  EXPECT_EQ(aside_mps({-20, 1, 0}), 0) << "it lies astern";
  EXPECT_EQ(aside_mps({41, 0, 0}), 0) << "it is too far";
  EXPECT_GT(aside_mps({20, 0, kEchoHeight_m - 0.1}), 0);
  EXPECT_EQ(aside_mps({20, 0, kEchoHeight_m + 0.1}), 0) << "a floor that it flies along";
}

TEST(Sidestep, MeasuresFromTheLineOfTravelOfAVehicleThatClimbs) {
  Surroundings around = EchoAhead({});
  around.own.velocity_mps = {2, 0, -0.5};
  const std::vector<SonarEcho> slope = {EchoAt({20, 0, -1})};  // 4 m below the line of travel.
  around.sonar = slope;
  EXPECT_EQ(LayerVelocity(SurvivalSonarLayer{.r_pass_m = 10}, kUMax_mps, around).y(), 0);
}

TEST(Sidestep, WaitsForAVehicleThatStandsStill) {
  Surroundings around = EchoAhead({});
  around.own.velocity_mps = {0.05, 0, 0};
  const std::vector<SonarEcho> echoes = {EchoAt({20, 0, 0})};
  around.sonar = echoes;
  EXPECT_EQ(LayerVelocity(SurvivalSonarLayer{.r_pass_m = 10}, kUMax_mps, around).y(), 0);
}

RC_GTEST_PROP(Sidestep, NeverAsksForMoreThanTheBudgetAndIsSymmetric, ()) {
  std::vector<SonarEcho> echoes, mirrored;
  for (int i = 0; i < *rc::gen::inRange(1, 20); ++i) {
    const Vector3d way_m(DrawBetween(1, 60), DrawBetween(-20, 20), DrawBetween(-5, 5));
    echoes.push_back(EchoAt(way_m));
    mirrored.push_back(EchoAt(way_m.cwiseProduct(Vector3d(1, -1, 1))));
  }
  const Vector3d one_mps = SonarVelocity(echoes, 10);
  const Vector3d other_mps = SonarVelocity(mirrored, 10).cwiseProduct(Vector3d(1, -1, 1));
  RC_ASSERT(one_mps.norm() <= kUMax_mps * (1 + 1e-12));
  // A tie goes to starboard both times; else the mirror image does the same.
  RC_ASSERT((one_mps - other_mps).norm() < 1e-9 || std::abs(one_mps.y() + other_mps.y()) < 1e-9);
}

TEST(Sidestep, OfTwoVehiclesGoesToTheSameHandOfBoth) {
  const SurvivalGroupLayer layer = {.r_pass_m = 20};
  for (const double across_m : {0.0, 3.0, -3.0}) {
    const Neighbour east{.id = 1, .position_m = {0, 0, 0}, .velocity_mps = {2, 0, 0}};
    const Neighbour west{.id = 2, .position_m = {30, across_m, 0}, .velocity_mps = {-2, 0, 0}};
    const std::vector<Neighbour> to_east = {west}, to_west = {east};
    const double east_mps = LayerVelocity(layer, kUMax_mps, {.own = east, .group = to_east}).y();
    const double west_mps = LayerVelocity(layer, kUMax_mps, {.own = west, .group = to_west}).y();
    EXPECT_GT(std::abs(east_mps), 0.5);
    EXPECT_NEAR(east_mps, -west_mps, 1e-12) << across_m;
  }
}

TEST(Layers, HaveTheWordsOfMissionFiles) {
  EXPECT_EQ(NameOf(SurvivalGroupLayer{}), "survival");
  EXPECT_EQ(NameOf(SurvivalSonarLayer{}), "sonar");
  EXPECT_EQ(NameOf(SurvivalLayer{}), "survival_and_sonar");
  EXPECT_EQ(NameOf(FormationLayer{}), "formation");
  EXPECT_EQ(NameOf(FeedForwardLayer{}), "feed_forward");
}

}  // namespace shoal::velocity_layers_test
