// Every vehicle model has a pilot.
#include "apps/helm/pilot.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shoal::pilot_test {

TEST(Pilot, OfEachModelSteersAndRests) {
  for (const AnyModel& model : EachModel()) {
    const std::string_view name = FactsOfModel(model).name;
    Vehicle vehicle;
    vehicle.model = model;
    const auto pilot = MakePilot(Mission{}, vehicle);
    ASSERT_NE(pilot, nullptr) << name;
    EXPECT_FALSE(pilot->GainsText().empty()) << name;

    nav_t nav{};
    nav.speed_mps = nav.surge_mps = 1;
    nav.altitude_m = 100;
    desired_t desired{};
    actuators_t actuators{};
    Guidance guidance;
    guidance.heading_rad = 1;
    guidance.speed_mps = 1.5;
    for (int i = 0; i < 20; ++i) pilot->Steer(guidance, nav, 0.1, &desired, &actuators);
    if (!FactsOfModel(model).passive.empty()) {
      EXPECT_EQ(actuators.thrust_pct, 0) << name << " has no actuators";
      continue;
    }
    EXPECT_GT(actuators.thrust_pct + actuators.propeller_rpm, 0) << name;
    EXPECT_GT(actuators.rudder_deg, 0) << name << " does not turn to starboard";
    EXPECT_NEAR(desired.heading_deg, 57.3, 0.1) << name;
    EXPECT_EQ(desired.speed_mps, 1.5) << name;

    pilot->Rest(nav, &desired, &actuators);
    EXPECT_EQ(actuators.thrust_pct + actuators.propeller_rpm, 0) << name;
    EXPECT_EQ(desired.speed_mps, 0) << name;
  }
}

}  // namespace shoal::pilot_test
