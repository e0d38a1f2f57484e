// What a vehicle's instruments show: MEASURED_NAV, SONAR, WATER_SAMPLE, and what happens where two
// vehicles touch.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/bus/bus/memory_bus.h"
#include "lib/sea/ocean/plume.h"

namespace shoal::instruments_app_test {

constexpr int64_t kTick_us = 100'000;

/// Two AUVs, 60 m deep over a flat floor 90 m deep; bravo 40 m ahead (East) of alpha.
Mission TwoAuvs() {
  Mission mission;
  mission.seed = 7;
  mission.environment.floor.style = "flat";
  mission.environment.floor.depth_m = 90;
  for (const std::string name : {"alpha", "bravo"}) {
    Vehicle vehicle;
    vehicle.name = name;
    vehicle.model = Remus100Options{};
    vehicle.length_m = 1.6;
    vehicle.start = {.x_m = name == "alpha" ? 0.0 : 40.0, .heading_deg = 90, .depth_m = 60};
    mission.vehicles.push_back(vehicle);
  }
  return mission;
}

/// All vehicle_sims of a mission on one bus, and a subscriber to alpha.
class Sims {
 public:
  explicit Sims(Mission mission) : mission_(std::move(mission)) {
    for (const Vehicle& vehicle : mission_.vehicles) {
      buses_.push_back(&hub_.Join("vehicle_sim_" + vehicle.name));
      sims_.push_back(std::make_unique<VehicleSimApp>(mission_, vehicle, *buses_.back()));
    }
    Bus& test_bus = *(test_bus_ = &hub_.Join("test"));
    Subscribe(test_bus, channels::Nav("alpha"), [this](const nav_t& nav) { nav_ = nav; });
    Subscribe(test_bus, channels::Nav("bravo"), [this](const nav_t& nav) { other_nav_ = nav; });
    Subscribe(test_bus, channels::HelmCommand("alpha"),
              [this](const helm_command_t& command) { helm_commands_.push_back(command); });
    Subscribe(test_bus, channels::MeasuredNav("alpha"),
              [this](const nav_t& nav) { measured_.push_back(nav); });
    Subscribe(test_bus, channels::Sonar("alpha"),
              [this](const sonar_t& ping) { pings_.push_back(ping); });
    Subscribe(test_bus, channels::WaterSample("alpha"),
              [this](const water_sample_t& sample) { samples_.push_back(sample); });
  }

  void Run(int num_steps) {
    for (int i = 0; i < num_steps; ++i) {
      hub_.NextStep();
      for (size_t k = 0; k < sims_.size(); ++k) hub_.Handle(*buses_[k]);
      for (const auto& sim : sims_) sim->Tick(utime_);
      hub_.NextStep();
      hub_.Handle(*test_bus_);
      for (size_t k = 0; k < sims_.size(); ++k) hub_.Handle(*buses_[k]);
      utime_ += kTick_us;
    }
  }
  void Command(std::string_view vehicle, const std::string& command,
               std::vector<double> values = {}) {
    sim_command_t message{};
    message.command = command;
    message.num_values = static_cast<int32_t>(values.size());
    message.values = std::move(values);
    Publish(*test_bus_, channels::SimCommand(vehicle), message);
  }
  VehicleSimApp& alpha() { return *sims_.front(); }

  nav_t nav_{};
  nav_t other_nav_{};
  std::vector<helm_command_t> helm_commands_;
  std::vector<nav_t> measured_;
  std::vector<sonar_t> pings_;
  std::vector<water_sample_t> samples_;

 private:
  Mission mission_;
  MemoryBus hub_;
  std::vector<Bus*> buses_;
  Bus* test_bus_ = nullptr;
  std::vector<std::unique_ptr<VehicleSimApp>> sims_;
  int64_t utime_ = 0;
};

TEST(Instruments, AreSilentWhereTheMissionGivesNone) {
  Sims sims(TwoAuvs());
  sims.Run(5);
  EXPECT_TRUE(sims.measured_.empty());
  EXPECT_TRUE(sims.pings_.empty());
  EXPECT_TRUE(sims.samples_.empty());
}

TEST(MeasuredNav, IsTheTruthWhereTheSensorsHaveNoNoise) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sensors.is_fitted = true;
  Sims sims(mission);
  sims.Run(1);
  ASSERT_EQ(sims.measured_.size(), 1U);
  EXPECT_EQ(sims.measured_[0].x_m, sims.nav_.x_m);
  EXPECT_EQ(sims.measured_[0].heading_deg, sims.nav_.heading_deg);
  EXPECT_EQ(sims.measured_[0].altitude_m, 30);
  EXPECT_EQ(sims.measured_[0].lat_deg, sims.nav_.lat_deg);
}

TEST(MeasuredNav, ScattersByTheStandardDeviationsOfTheMission) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sensors = {.is_fitted = true,
                                 .position_noise_m = 3,
                                 .depth_noise_m = 0.2,
                                 .attitude_noise_deg = 0.5,
                                 .altitude_noise_m = 1};
  Sims sims(mission);
  sims.Command("alpha", "pause");
  sims.Run(2000);
  ASSERT_EQ(sims.measured_.size(), 2000U);
  const auto sigma = [&](auto error) {
    double sum = 0;
    for (const nav_t& nav : sims.measured_) sum += error(nav) * error(nav);
    return std::sqrt(sum / 2000);
  };
  // The estimate of a standard deviation from 2000 draws scatters by 1.6 %; 5 sigma are 8 %.
  EXPECT_NEAR(sigma([&](const nav_t& nav) { return nav.x_m - sims.nav_.x_m; }), 3, 0.24);
  EXPECT_NEAR(sigma([&](const nav_t& nav) { return nav.y_m - sims.nav_.y_m; }), 3, 0.24);
  EXPECT_NEAR(sigma([&](const nav_t& nav) { return nav.z_m - sims.nav_.z_m; }), 0.2, 0.016);
  EXPECT_NEAR(sigma([&](const nav_t& nav) { return nav.heading_deg - sims.nav_.heading_deg; }), 0.5,
              0.04);
  EXPECT_NEAR(sigma([&](const nav_t& nav) { return nav.altitude_m - sims.nav_.altitude_m; }), 1,
              0.08);
  EXPECT_EQ(sigma([&](const nav_t& nav) { return nav.yaw_rate_degps - sims.nav_.yaw_rate_degps; }),
            0);
}

TEST(MeasuredNav, KnowsNoFloorBeyondTheAltimetersRange) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sensors = {.is_fitted = true, .altimeter_range_m = 29};
  Sims sims(mission);
  sims.Run(1);
  EXPECT_EQ(sims.nav_.altitude_m, 30);
  EXPECT_EQ(sims.measured_.at(0).altitude_m, -1);
}

TEST(SonarOfAVehicle, SeesTheOneAheadAtTheDistanceOfItsSphere) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sonar = {.is_fitted = true, .tilt_deg = 0};
  Sims sims(mission);
  sims.Run(2);
  ASSERT_EQ(sims.pings_.size(), 2U);
  const sonar_t& ping = sims.pings_.back();
  EXPECT_EQ(ping.utime, kTick_us);
  ASSERT_EQ(ping.beams.size(), 55U);
  const sonar_beam_t& middle = ping.beams[27];
  EXPECT_NEAR(middle.azimuth_deg, 0, 1e-9);
  EXPECT_NEAR(middle.elevation_deg, 0, 1e-9);
  EXPECT_NEAR(middle.range_m, 40 - 1.6, 0.1);
}

TEST(SonarOfAVehicle, CountsAzimuthsToStarboardAndElevationsUpward) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sonar = {.is_fitted = true, .tilt_deg = 0};
  // To starboard of a vehicle that looks East is South; 10 degrees of it.
  mission.vehicles[1].start.y_m = -40 * std::tan(10 * 3.14159265358979 / 180);
  Sims sims(mission);
  sims.Run(2);
  const sonar_t& ping = sims.pings_.back();
  EXPECT_NEAR(ping.beams.front().azimuth_deg, -25, 1e-9);
  EXPECT_NEAR(ping.beams.front().elevation_deg, 7.5, 1e-9);
  EXPECT_NEAR(ping.beams.back().azimuth_deg, 25, 1e-9);
  EXPECT_NEAR(ping.beams.back().elevation_deg, -7.5, 1e-9);
  for (const sonar_beam_t& beam : ping.beams) {
    const bool points_there = std::abs(beam.azimuth_deg - 10) < 1 && beam.elevation_deg == 0;
    const bool points_to_port = std::abs(beam.azimuth_deg + 10) < 1;
    EXPECT_TRUE(!points_there || beam.range_m > 35) << "it sees bravo";
    EXPECT_TRUE(!points_to_port || beam.range_m < 0) << "and nothing to port";
  }
}

TEST(SonarOfAVehicle, PingsAtItsRate) {
  Mission mission = TwoAuvs();
  mission.vehicles[0].sonar = {.is_fitted = true, .rate_hz = 2};
  Sims sims(mission);
  sims.Run(21);
  ASSERT_EQ(sims.pings_.size(), 5U);
  EXPECT_EQ(sims.pings_[1].utime, 500'000);
}

TEST(WaterSample, HasTheConcentrationOfThePlume) {
  Mission mission = TwoAuvs();
  mission.environment.plume = {.exists = true, .source_m = {-50, 0, 60}, .rate_gps = 100};
  Sims sims(mission);
  sims.Run(1);
  ASSERT_EQ(sims.samples_.size(), 1U);
  const Plume plume = {.source_m = {-50, 0, 60}, .rate_gps = 100, .floor_z_m = 90};
  EXPECT_GT(sims.samples_[0].concentration_gpm3, 0);
  EXPECT_EQ(sims.samples_[0].concentration_gpm3, Concentration(plume, {0, 0, 60}));
}

TEST(Contact, StopsBothVehiclesForGoodWhereTheMissionDemandsIt) {
  Mission mission = TwoAuvs();
  mission.environment.contact = ContactRule::kStop;
  mission.environment.current = {.speed_mps = "0.5", .direction_deg = "90"};
  mission.vehicles[1].start.x_m = 1.5;
  Sims sims(mission);
  sims.Run(20);
  EXPECT_LT(sims.nav_.x_m, 0.1) << "the drift until both have received each other's NAV";
  EXPECT_EQ(sims.nav_.x_m, sims.other_nav_.x_m - 1.5) << "both stopped in the same step";
  EXPECT_EQ(sims.nav_.speed_over_ground_mps, 0);
  EXPECT_NE(sims.alpha().Status().text.find("ran into bravo"), std::string::npos);
  ASSERT_EQ(sims.helm_commands_.size(), 1U) << "the helm is stopped once";
  EXPECT_EQ(sims.helm_commands_[0].command, "all_stop");
  EXPECT_EQ(sims.helm_commands_[0].argument, "collision with bravo");

  sims.Command("alpha", "reset", {-100, 0, 90, 0, 60});
  sims.Run(20);
  EXPECT_NEAR(sims.nav_.x_m, -99, 0.1) << "put elsewhere, it drifts again";
  EXPECT_EQ(sims.nav_.z_m > 59 && sims.nav_.z_m < 61, true) << "at the depth it was put to";
}

TEST(Contact, IsIgnoredByDefault) {
  Mission mission = TwoAuvs();
  mission.environment.current = {.speed_mps = "0.5", .direction_deg = "90"};
  mission.vehicles[1].start.x_m = 1.5;
  Sims sims(mission);
  sims.Run(21);
  EXPECT_NEAR(sims.nav_.x_m, 1, 0.05);
  EXPECT_TRUE(sims.helm_commands_.empty());
}

}  // namespace shoal::instruments_app_test
