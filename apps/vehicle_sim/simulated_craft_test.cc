// Every vehicle model runs in vehicle_sim.
#include "apps/vehicle_sim/simulated_craft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lib/base/geometry/angles.h"

namespace shoal::simulated_craft_test {

std::unique_ptr<SimulatedCraft> CraftOf(const AnyModel& model) {
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = model;
  return MakeSimulatedCraft(Mission(), vehicle);
}

/// The models that move by themselves: where one is that is replayed, its file states.
std::vector<AnyModel> EachMovedModel() {
  std::vector<AnyModel> models = EachModel();
  std::erase_if(models,
                [](const AnyModel& model) { return std::holds_alternative<TrackOptions>(model); });
  return models;
}

Mission MissionNear(const std::string& folder) {
  Mission mission;
  mission.file = std::string(SHOAL_SOURCE_DIR) + "/" + folder + "/m.toml";
  return mission;
}

TEST(SimulatedCraft, OfEachModelStartsWhereItIsPut) {
  for (const AnyModel& model : EachMovedModel()) {
    const ModelFacts facts = FactsOfModel(model);
    const auto craft = CraftOf(model);
    ASSERT_NE(craft, nullptr) << facts.name;
    const double depth_m = facts.is_underwater ? 12 : 0;
    craft->Reset({.x_m = 30, .y_m = -40, .heading_deg = 90, .speed_mps = 1, .depth_m = depth_m},
                 {});
    EXPECT_EQ(craft->position_m(), Eigen::Vector3d(30, -40, depth_m)) << facts.name;
  }
}

TEST(SimulatedCraft, OfEachModelDriftsWithTheWaterAndPublishesFiniteNumbers) {
  for (const AnyModel& model : EachMovedModel()) {
    const ModelFacts facts = FactsOfModel(model);
    const auto craft = CraftOf(model);
    const Water water{.velocity_mps = {0.5, 0}, .floor_z_m = 100};
    craft->Reset({.depth_m = facts.is_underwater ? 20.0 : 0.0}, water);
    craft->Rest();
    for (int i = 0; i < 200; ++i) craft->Step(water, 0.1);
    nav_t nav{};
    craft->Show(water, &nav);
    EXPECT_NEAR(nav.x_m, 10, 2) << facts.name;
    EXPECT_NEAR(nav.y_m, 0, 2) << facts.name;
    EXPECT_TRUE(std::isfinite(nav.heading_deg) && std::isfinite(nav.speed_mps)) << facts.name;
    EXPECT_GT(nav.altitude_m, 0) << facts.name;
    EXPECT_FALSE(craft->ActuatorsText().empty()) << facts.name;
  }
}

TEST(SimulatedCraft, OfEachModelRefusesACommandThatIsNoNumber) {
  for (const AnyModel& model : EachMovedModel()) {
    const auto craft = CraftOf(model);
    craft->Reset({}, {});
    actuators_t actuators{};
    EXPECT_TRUE(craft->Execute(actuators)) << FactsOfModel(model).name;
    actuators.rudder_deg = std::nan("");
    EXPECT_FALSE(craft->Execute(actuators)) << FactsOfModel(model).name;
  }
}

TEST(SimulatedTrack, IsWhereItsFileHasItWhateverItIsOrdered) {
  Vehicle vehicle;
  vehicle.name = "launch";
  vehicle.model = TrackOptions{.file = "tracks/launch.csv"};
  const auto craft = MakeSimulatedCraft(MissionNear("missions"), vehicle);
  Water water{.velocity_mps = {0, 0.5}, .floor_z_m = 30};
  craft->Reset({.x_m = 7}, water);
  EXPECT_EQ(craft->position_m(), Eigen::Vector3d(300, 320, 0));
  actuators_t actuators{};
  actuators.thrust_pct = 100;
  EXPECT_TRUE(craft->Execute(actuators));
  water.time_s = 62.4;
  craft->Step(water, 0.1);
  water.time_s = 62.5;
  nav_t nav{};
  craft->Show(water, &nav);
  // Half way between the lines of 60 and 65 s.
  EXPECT_NEAR(nav.x_m, (172.7 + 161.1) / 2, 1e-9);
  EXPECT_NEAR(nav.y_m, (192.7 + 183.3) / 2, 1e-9);
  EXPECT_NEAR(nav.heading_deg, 232.5, 1e-9);
  EXPECT_NEAR(nav.yaw_rate_degps, 3, 1e-9);
  EXPECT_NEAR(nav.speed_over_ground_mps, std::hypot(11.6, 9.4) / 5, 1e-9);
  EXPECT_EQ(nav.altitude_m, 30);
  // Over ground it is the sum of what it makes relative to the water and of the current.
  const double heading_rad = DegToRad(nav.heading_deg);
  const Eigen::Vector2d ahead = UnitVector(heading_rad);
  const Eigen::Vector2d starboard(ahead.y(), -ahead.x());
  const Eigen::Vector2d over_ground =
      nav.surge_mps * ahead + nav.sway_mps * starboard + water.velocity_mps;
  EXPECT_NEAR(over_ground.x(), -11.6 / 5, 1e-9);
  EXPECT_NEAR(over_ground.y(), -9.4 / 5, 1e-9);
}

TEST(SimulatedTrack, LiesStillBehindItsEnd) {
  Vehicle vehicle;
  vehicle.model = TrackOptions{.file = "tracks/launch.csv"};
  const auto craft = MakeSimulatedCraft(MissionNear("missions"), vehicle);
  const Water water{.time_s = 1000, .floor_z_m = std::nullopt};
  craft->Step(water, 0.1);
  nav_t nav{};
  craft->Show(water, &nav);
  EXPECT_EQ(nav.speed_over_ground_mps, 0);
  EXPECT_EQ(nav.yaw_rate_degps, 0);
  EXPECT_NEAR(nav.heading_deg, 45, 1e-9);
  EXPECT_EQ(nav.altitude_m, -1) << "the depth is not known";
}

}  // namespace shoal::simulated_craft_test
