#include "apps/vehicle_sim/vehicle_sim_app.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/time/seconds.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::vehicle_sim_app_test {

constexpr int64_t kTick_us = 100'000;

Mission TestMission() {
  Mission mission;
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.start = {.x_m = 10, .y_m = -20, .heading_deg = 90, .speed_mps = 1};
  mission.vehicles = {vehicle};
  return mission;
}

class VehicleSimAppTest : public testing::Test {
 protected:
  explicit VehicleSimAppTest(const Mission& mission = TestMission())
      : mission_(mission),
        sim_bus_(hub_.Join("vehicle_sim_alpha")),
        test_bus_(hub_.Join("test")),
        sim_(mission_, mission_.vehicles.front(), sim_bus_) {
    Subscribe(test_bus_, channels::Nav("alpha"), [this](const nav_t& nav) {
      nav_ = nav;
      ++num_navs_;
    });
  }

  void Actuate(double thrust_pct, double rudder_deg) {
    actuators_t actuators{};
    actuators.thrust_pct = thrust_pct;
    actuators.rudder_deg = rudder_deg;
    Publish(test_bus_, channels::Actuators("alpha"), actuators);
  }

  void Command(const std::string& command, const std::vector<double>& values = {}) {
    sim_command_t message{};
    message.command = command;
    message.num_values = static_cast<int32_t>(values.size());
    message.values = values;
    Publish(test_bus_, channels::SimCommand("alpha"), message);
  }

  // One step at `utime`; nav_ is what it published.
  void StepAt(int64_t utime) {
    hub_.NextStep();
    hub_.Handle(sim_bus_);
    sim_.Tick(utime);
    hub_.NextStep();
    hub_.Handle(test_bus_);
    utime_ = utime;
  }

  void Run(double duration_s) {
    const int64_t end = utime_ + Microseconds(duration_s);
    while (utime_ < end) StepAt(utime_ + kTick_us);
  }

  size_t NumWarnings() const { return sim_.Status().run_warnings.size(); }

  Mission mission_;
  MemoryBus hub_;
  Bus& sim_bus_;
  Bus& test_bus_;
  VehicleSimApp sim_;
  nav_t nav_{};
  int num_navs_ = 0;
  int64_t utime_ = 0;
};

/// Water that moves to the East at 0.5 m/s, known for x up to 25 m.
class InACurrentGrid : public VehicleSimAppTest {
 protected:
  InACurrentGrid() : VehicleSimAppTest(WithGrids()) {}

  bool IsOffGrid() const {
    return std::ranges::any_of(sim_.Status().run_warnings, [](const std::string& warning) {
      return warning.find("off the grid of the current") != std::string::npos;
    });
  }

  static Mission WithGrids() {
    Mission mission = TestMission();
    mission.file = testing::TempDir() + "in_a_current_grid.toml";
    mission.vehicles.front().start.speed_mps = 0;
    for (const auto& [name, mps] :
         {std::pair("in_a_current_u.asc", "0.5"), {"in_a_current_v.asc", "0"}}) {
      std::ofstream(testing::TempDir() + name)
          << "ncols 3\nnrows 1\nxllcenter 0\nyllcenter -20\ncellsize 10\n"
          << mps << ' ' << mps << ' ' << mps << '\n';
    }
    mission.environment.current_grid.east = "in_a_current_u.asc";
    mission.environment.current_grid.north = "in_a_current_v.asc";
    return mission;
  }
};

TEST_F(InACurrentGrid, DriftsWithTheWaterAndOnAtTheEdgesWithAWarning) {
  Run(28);
  EXPECT_NEAR(nav_.x_m, 10 + 0.5 * 28, 1);
  EXPECT_NEAR(nav_.y_m, -20, 1e-6);
  EXPECT_FALSE(IsOffGrid());
  Run(32);
  EXPECT_NEAR(nav_.x_m, 10 + 0.5 * 60, 1);
  EXPECT_TRUE(IsOffGrid());
  Command("reset");
  Run(1);
  EXPECT_FALSE(IsOffGrid()) << "it is back on the grid";
}

class InACurrent : public VehicleSimAppTest {
 protected:
  InACurrent() : VehicleSimAppTest(WithCurrent()) {}

  static Mission WithCurrent() {
    Mission mission = TestMission();
    mission.vehicles.front().start.speed_mps = 0;
    mission.environment.current = {.speed_mps = "0.5", .direction_deg = "180"};
    return mission;
  }
};

TEST_F(VehicleSimAppTest, PublishesTheStartPoseInTheFirstStepWithoutMoving) {
  StepAt(0);
  EXPECT_EQ(num_navs_, 1);
  EXPECT_EQ(nav_.utime, 0);
  EXPECT_EQ(nav_.x_m, 10);
  EXPECT_EQ(nav_.y_m, -20);
  EXPECT_NEAR(nav_.heading_deg, 90, 1e-12);
  EXPECT_EQ(nav_.speed_mps, 1);
  EXPECT_NEAR(nav_.course_over_ground_deg, 90, 1e-12);
  EXPECT_LT(nav_.altitude_m, 0);
  EXPECT_NEAR(nav_.lat_deg, mission_.origin_lat_deg - 20 / 111'000.0, 1e-5);
}

TEST_F(VehicleSimAppTest, PublishesNavInEveryStepAndMovesByItsActuators) {
  StepAt(0);
  for (int i = 0; i < 100; ++i) {
    Actuate(40, 0);
    Run(0.1);
  }
  EXPECT_EQ(num_navs_, 101);
  EXPECT_NEAR(nav_.speed_mps, 2, 1e-9);
  EXPECT_NEAR(nav_.x_m, 10 + 10 * 2 - 0.5 * 1 * 2, 0.1);
  EXPECT_NEAR(nav_.y_m, -20, 1e-9);
  EXPECT_NEAR(nav_.speed_over_ground_mps, 2, 1e-9);
}

TEST_F(VehicleSimAppTest, TurnsToStarboardWithAPositiveYawRateUnderPositiveRudder) {
  StepAt(0);
  Actuate(40, 20);
  Run(1);
  EXPECT_GT(nav_.heading_deg, 90);
  EXPECT_GT(nav_.yaw_rate_degps, 0);
}

TEST_F(VehicleSimAppTest, HoldsItsActuatorsForTwoSecondsAndThenStopsAndWarns) {
  StepAt(0);
  Actuate(40, 0);
  Run(1.9);
  EXPECT_EQ(NumWarnings(), 0u);
  EXPECT_GT(nav_.speed_mps, 1.8);
  Run(10);
  EXPECT_EQ(nav_.speed_mps, 0);
  EXPECT_EQ(NumWarnings(), 1u);
  Actuate(40, 0);
  Run(1);
  EXPECT_EQ(NumWarnings(), 0u);
  EXPECT_GT(nav_.speed_mps, 0);
}

TEST_F(VehicleSimAppTest, StandsStillWhilePausedAndGoesOnFromThere) {
  StepAt(0);
  Run(0.5);
  Command("pause");
  Run(0.1);
  const nav_t paused = nav_;
  Run(5);
  EXPECT_EQ(nav_.x_m, paused.x_m);
  EXPECT_EQ(nav_.speed_over_ground_mps, 0);
  Command("resume");
  Run(0.2);
  EXPECT_GT(nav_.x_m, paused.x_m);
  EXPECT_LT(nav_.x_m, paused.x_m + 0.3);
}

TEST_F(VehicleSimAppTest, GoesBackToTheStartOrToTheValuesWhenReset) {
  StepAt(0);
  Run(1);
  Command("pause");
  Command("reset");
  Run(0.1);
  EXPECT_EQ(nav_.x_m, 10);
  EXPECT_EQ(nav_.y_m, -20);
  Command("reset", {1, 2, 270, 0.5});
  Run(0.1);
  EXPECT_EQ(nav_.x_m, 1);
  EXPECT_EQ(nav_.y_m, 2);
  EXPECT_NEAR(nav_.heading_deg, 270, 1e-9);
  EXPECT_EQ(NumWarnings(), 0u);
}

TEST_F(InACurrent, DriftsExactlyWithItAndWithTheDriftOfACommand) {
  StepAt(0);
  EXPECT_NEAR(nav_.course_over_ground_deg, 180, 1e-9);
  Run(10);
  EXPECT_NEAR(nav_.y_m, -25, 1e-9);
  EXPECT_EQ(nav_.speed_mps, 0);
  EXPECT_NEAR(nav_.speed_over_ground_mps, 0.5, 1e-12);
  Command("drift", {0.25, 0.5});
  Run(10);
  EXPECT_NEAR(nav_.y_m, -25, 1e-9);
  EXPECT_NEAR(nav_.x_m, 12.5, 1e-9);
}

TEST_F(InACurrent, ComesToTheSamePlaceWhenStepsAreFarApart) {
  StepAt(0);
  StepAt(10'000'000);
  EXPECT_NEAR(nav_.y_m, -25, 1e-9);
  StepAt(10'000'000);
  EXPECT_NEAR(nav_.y_m, -25, 1e-9);
}

TEST_F(VehicleSimAppTest, RefusesInvalidOrdersAndActuators) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  StepAt(0);
  Actuate(nan, 0);
  Actuate(0, infinity);
  Command("jump");
  Command(std::string("\x1b[2J\xff") + std::string(10'000, 'x'));
  Command("pause", {1});
  Command("drift", {1});
  Command("drift", {nan, 0});
  Command("reset", {1, 2, 3});
  Command("reset", {1e300, 0, 0, 0});
  Command("reset", {0, 0, infinity, 0});
  Run(1);
  EXPECT_GE(NumWarnings(), 6u);
  EXPECT_TRUE(std::isfinite(nav_.x_m));
  EXPECT_NEAR(nav_.y_m, -20, 1e-9);
  for (const std::string& warning : sim_.Status().run_warnings) {
    EXPECT_LT(warning.size(), 200u);
    EXPECT_TRUE(std::all_of(warning.begin(), warning.end(), [](char c) { return c >= ' '; }))
        << warning;
  }
}

}  // namespace shoal::vehicle_sim_app_test
