// Every vehicle model runs in vehicle_sim.
#include "apps/vehicle_sim/simulated_craft.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace shoal::simulated_craft_test {

Vehicle VehicleOf(const AnyModel& model) {
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = model;
  return vehicle;
}

TEST(SimulatedCraft, OfEachModelStartsWhereItIsPut) {
  for (const AnyModel& model : EachModel()) {
    const ModelFacts facts = FactsOfModel(model);
    const auto craft = MakeSimulatedCraft(VehicleOf(model));
    ASSERT_NE(craft, nullptr) << facts.name;
    const double depth_m = facts.is_underwater ? 12 : 0;
    craft->Reset({.x_m = 30, .y_m = -40, .heading_deg = 90, .speed_mps = 1, .depth_m = depth_m},
                 {});
    EXPECT_EQ(craft->position_m(), Eigen::Vector3d(30, -40, depth_m)) << facts.name;
  }
}

TEST(SimulatedCraft, OfEachModelDriftsWithTheWaterAndPublishesFiniteNumbers) {
  for (const AnyModel& model : EachModel()) {
    const ModelFacts facts = FactsOfModel(model);
    const auto craft = MakeSimulatedCraft(VehicleOf(model));
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
  for (const AnyModel& model : EachModel()) {
    const auto craft = MakeSimulatedCraft(VehicleOf(model));
    craft->Reset({}, {});
    actuators_t actuators{};
    EXPECT_TRUE(craft->Execute(actuators)) << FactsOfModel(model).name;
    actuators.rudder_deg = std::nan("");
    EXPECT_FALSE(craft->Execute(actuators)) << FactsOfModel(model).name;
  }
}

}  // namespace shoal::simulated_craft_test
