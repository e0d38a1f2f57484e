// A vehicle of model remus100 in its process: NAV, SIM_COMMAND, the floor.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::remus100_app_test {

class Remus100AppTest : public testing::Test {
 protected:
  Remus100AppTest()
      : mission_(DivingMission()),
        sim_bus_(hub_.Join("vehicle_sim_alpha")),
        test_bus_(hub_.Join("test")),
        sim_(mission_, mission_.vehicles.front(), sim_bus_) {
    Subscribe(test_bus_, channels::Nav("alpha"), [this](const nav_t& nav) { nav_ = nav; });
    Step();
  }

  static Mission DivingMission() {
    Mission mission;
    Vehicle vehicle;
    vehicle.name = "alpha";
    vehicle.model = Remus100Options{};
    vehicle.start = {.x_m = 10, .y_m = -20, .heading_deg = 90, .speed_mps = 1.5, .depth_m = 12};
    mission.vehicles = {vehicle};
    mission.environment.current = {.speed_mps = "0.2", .direction_deg = "0"};
    mission.environment.floor.style = "flat";
    mission.environment.floor.depth_m = 20;
    return mission;
  }

  void Actuate(double stern_plane_deg, double propeller_rpm) {
    actuators_t actuators{};
    actuators.stern_plane_deg = stern_plane_deg;
    actuators.propeller_rpm = propeller_rpm;
    Publish(test_bus_, channels::Actuators("alpha"), actuators);
  }
  void Command(const std::string& command, const std::vector<double>& values = {}) {
    sim_command_t message{};
    message.command = command;
    message.num_values = static_cast<int32_t>(values.size());
    message.values = values;
    Publish(test_bus_, channels::SimCommand("alpha"), message);
  }
  void Step() {
    hub_.NextStep();
    hub_.Handle(sim_bus_);
    sim_.Tick(utime_);
    hub_.NextStep();
    hub_.Handle(test_bus_);
    utime_ += 100'000;
  }
  /// Dives until it touches the floor.
  void Dive() {
    for (int i = 0; i < 600; ++i) {
      Actuate(-10, 1400);
      Step();
    }
  }

  Mission mission_;
  MemoryBus hub_;
  Bus& sim_bus_;
  Bus& test_bus_;
  VehicleSimApp sim_;
  nav_t nav_{};
  int64_t utime_ = 0;
};

TEST_F(Remus100AppTest, PublishesItsDepthAndItsHeightAboveTheFloor) {
  EXPECT_EQ(nav_.z_m, 12);
  EXPECT_EQ(nav_.altitude_m, 8);
  EXPECT_NEAR(nav_.speed_mps, 1.5, 1e-12);
  EXPECT_NEAR(nav_.speed_over_ground_mps, std::hypot(1.5, 0.2), 1e-12);
  EXPECT_NE(sim_.Status().text.find("Vehicle: alpha (remus100)"), std::string::npos);
  EXPECT_NE(sim_.Status().text.find("depth 12.00 m, 8.0 m above the floor"), std::string::npos)
      << sim_.Status().text;
}

TEST_F(Remus100AppTest, RunsAgroundAndStaysThereUntilItIsReset) {
  Dive();
  EXPECT_NEAR(nav_.z_m, 20, 0.5);
  EXPECT_EQ(nav_.altitude_m, 0);
  EXPECT_EQ(nav_.speed_over_ground_mps, 0);
  EXPECT_EQ(nav_.descent_mps, 0);
  EXPECT_NE(sim_.Status().text.find("Aground: it moves no more"), std::string::npos);
  const double x_m = nav_.x_m;
  Dive();
  EXPECT_EQ(nav_.x_m, x_m);
  Command("reset");
  Step();
  EXPECT_NEAR(nav_.z_m, 12, 0.1);
  EXPECT_EQ(sim_.Status().text.find("Aground"), std::string::npos);
  Actuate(0, 1200);
  for (int i = 0; i < 15; ++i) Step();
  EXPECT_GT(nav_.x_m, 11);
}

TEST_F(Remus100AppTest, IsResetToItsStartDepthOrToTheSurfaceOfAnotherPlace) {
  for (int i = 0; i < 20; ++i) Step();
  Command("reset", {-50, 60, 180, 0});
  Step();
  EXPECT_NEAR(nav_.x_m, -50, 0.01);
  EXPECT_NEAR(nav_.y_m, 60, 0.05);
  EXPECT_NEAR(nav_.z_m, 0.09, 0.01) << "where it floats";
  EXPECT_NEAR(nav_.heading_deg, 180, 0.01);
  EXPECT_NEAR(nav_.altitude_m, 19.91, 0.01);
  Command("reset");
  Step();
  EXPECT_NEAR(nav_.z_m, 12, 0.01);
  EXPECT_NEAR(nav_.heading_deg, 90, 0.01);
}

TEST_F(Remus100AppTest, StandsStillWhilePausedAndGoesOnAfterwards) {
  Actuate(-5, 1200);
  for (int i = 0; i < 15; ++i) Step();
  Command("pause");
  Step();
  const nav_t paused = nav_;
  EXPECT_EQ(paused.descent_mps, 0);
  EXPECT_EQ(paused.speed_mps, 0);
  EXPECT_EQ(paused.sway_mps, 0);
  EXPECT_EQ(paused.heave_mps, 0);
  EXPECT_EQ(paused.pitch_rate_degps, 0);
  EXPECT_LT(paused.pitch_deg, 0) << "a pause keeps the attitude";
  for (int i = 0; i < 10; ++i) Step();
  for (double nav_t::*pose : {&nav_t::x_m, &nav_t::y_m, &nav_t::z_m, &nav_t::roll_deg,
                              &nav_t::pitch_deg, &nav_t::heading_deg, &nav_t::altitude_m}) {
    EXPECT_EQ(nav_.*pose, paused.*pose);
  }
  Command("resume");
  Actuate(-5, 1200);
  for (int i = 0; i < 10; ++i) Step();
  EXPECT_GT(nav_.z_m, paused.z_m);
  EXPECT_GT(nav_.x_m, paused.x_m + 1);
}

TEST_F(Remus100AppTest, CountsActuatorsThatAreNoNumbersAsRefused) {
  Actuate(std::numeric_limits<double>::quiet_NaN(), 1200);
  Step();
  ASSERT_EQ(sim_.Status().run_warnings.size(), 1U);
  EXPECT_NE(sim_.Status().run_warnings.front().find("ACTUATORS with NaN"), std::string::npos);
}

}  // namespace shoal::remus100_app_test
