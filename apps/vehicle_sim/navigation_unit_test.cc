#include "apps/vehicle_sim/navigation_unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "apps/vehicle_sim/vehicle_sim_app.h"
#include "lib/base/geometry/angles.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal::navigation_unit_test {

constexpr int64_t kTick_us = 100'000;

/// One AUV, 20 m deep over a floor at 50 m, with instruments of survey grade.
Mission OneAuv() {
  Mission mission;
  mission.seed = 3;
  mission.environment.floor.style = "flat";
  mission.environment.floor.depth_m = 50;
  Vehicle vehicle;
  vehicle.name = "alpha";
  vehicle.model = Remus100Options{};
  vehicle.start = {.heading_deg = 40, .depth_m = 20};
  vehicle.navigation.is_fitted = true;
  mission.vehicles.push_back(vehicle);
  return mission;
}

const LocalFrame kFrame({.lat_deg = 43, .lon_deg = -70});

/// A vehicle at rest.
nav_t At(double x_m, double depth_m, int64_t step) {
  nav_t nav{};
  nav.utime = step * kTick_us;
  nav.x_m = x_m;
  nav.z_m = depth_m;
  nav.heading_deg = 40;
  nav.altitude_m = 50 - depth_m;
  return nav;
}

/// Lets the unit do steps at rest; returns the last estimate.
nav_t Rest(NavigationUnit* unit, double x_m, int first, int count) {
  nav_t estimate{};
  for (int i = first; i < first + count; ++i) {
    estimate = unit->Estimate(At(x_m, 20, i), Eigen::Vector2d::Zero(), kFrame);
  }
  return estimate;
}

TEST(NavigationUnit, EstimatesNearTheTruthAndNotTheTruth) {
  const Mission mission = OneAuv();
  NavigationUnit unit(mission, mission.vehicles[0]);
  const nav_t estimate = Rest(&unit, 0, 0, 100);
  const double error_m = std::hypot(estimate.x_m, estimate.y_m);
  EXPECT_GT(error_m, 0.01);
  EXPECT_LT(error_m, 8);
  EXPECT_NEAR(estimate.z_m, 20, 0.3);
  EXPECT_NE(estimate.z_m, 20);
  EXPECT_NEAR(Wrap180(estimate.heading_deg - 40), 0, 3);
  EXPECT_NEAR(kFrame.ToLocal({estimate.lat_deg, estimate.lon_deg}).value().x(), estimate.x_m, 1e-6);
}

TEST(NavigationUnit, ReportsAtItsIntervalAndAtTheStart) {
  const Mission mission = OneAuv();
  NavigationUnit unit(mission, mission.vehicles[0]);
  std::vector<int64_t> times;
  for (int i = 0; i <= 25; ++i) {
    static_cast<void>(Rest(&unit, 0, i, 1));
    const auto report = unit.Report(i * kTick_us);
    if (report) times.push_back(report->utime);
  }
  EXPECT_EQ(times, (std::vector<int64_t>{0, 1'000'000, 2'000'000}));
}

TEST(NavigationUnit, ShowsWhatItsEstimateCameFrom) {
  const Mission mission = OneAuv();
  NavigationUnit unit(mission, mission.vehicles[0]);
  static_cast<void>(Rest(&unit, 0, 0, 101));
  const navigation_t report = unit.Report(10'000'000).value();
  EXPECT_TRUE(report.has_dvl_lock);
  EXPECT_FALSE(report.has_gps_fix);
  EXPECT_GE(report.num_compass, 20);
  EXPECT_GE(report.num_dvl, 17);
  EXPECT_GE(report.num_log, 10);
  EXPECT_EQ(report.num_gps, 0);
  EXPECT_GT(report.ellipse_major_m, 2);
  EXPECT_LT(report.ellipse_major_m, 10);
  EXPECT_GE(report.ellipse_major_m, report.ellipse_minor_m);
}

TEST(NavigationUnit, ListsRangesTakenAndRejected) {
  Mission mission = OneAuv();
  mission.vehicles[0].navigation.ranging.dropout = 0;
  mission.beacons = {{.name = "near", .point_m = {150, 0}, .depth_m = 20, .interval_s = 2}};
  NavigationUnit unit(mission, mission.vehicles[0]);
  static_cast<void>(Rest(&unit, 0, 0, 100));
  navigation_t report = unit.Report(9'900'000).value();
  EXPECT_EQ(report.num_ranges_taken, 5);
  ASSERT_EQ(report.ranges.size(), 5U);
  EXPECT_EQ(report.ranges[0].beacon, "near");
  EXPECT_NEAR(report.ranges[0].range_m, 150, 3);
  EXPECT_TRUE(report.ranges[0].is_taken);
  // It is carried off without noticing: ranges no longer fit.
  static_cast<void>(Rest(&unit, -100, 100, 40));
  report = unit.Report(13'900'000).value();
  EXPECT_EQ(report.num_ranges_rejected, 2);
  ASSERT_EQ(report.ranges.size(), 2U) << "since the last message";
  EXPECT_FALSE(report.ranges[1].is_taken);
  EXPECT_GT(report.ranges[1].distance2, report.ranges[1].gate);
}

TEST(NavigationUnit, TakesPacketsOfTheSenderAsRanges) {
  Mission mission = OneAuv();
  mission.beacons = {
      {.name = "buoy", .point_m = {300, 0}, .depth_m = 20, .kind = "packets", .sender = "Ship"}};
  NavigationUnit unit(mission, mission.vehicles[0]);
  EXPECT_TRUE(unit.takes_packets());
  static_cast<void>(Rest(&unit, 0, 0, 10));
  acoustic_rx_t packet{};
  packet.source = "other";
  unit.TakePacket(packet);
  static_cast<void>(Rest(&unit, 0, 10, 1));
  packet.source = "SHIP";
  unit.TakePacket(packet);
  static_cast<void>(Rest(&unit, 0, 11, 1));
  const navigation_t report = unit.Report(1'100'000).value();
  ASSERT_EQ(report.ranges.size(), 1U);
  EXPECT_NEAR(report.ranges[0].range_m, 300, 3);
}

TEST(NavigationUnit, DriftsByTheErrorOfTheSurveyWhereABeaconIsNotWhereItIsBelieved) {
  Mission mission = OneAuv();
  mission.vehicles[0].navigation.ranging.dropout = 0;
  mission.beacons = {{.name = "near", .point_m = {150, 0}, .depth_m = 20, .interval_s = 0.5}};
  mission.beacons[0].position_sigma_m = 20;
  NavigationUnit unit(mission, mission.vehicles[0]);
  static_cast<void>(Rest(&unit, 0, 0, 300));
  const navigation_t report = unit.Report(29'900'000).value();
  // The ranges are good to half a metre; the survey is not, and the filter allows for it.
  double largest_m = 0;
  for (const navigation_range_t& range : report.ranges) {
    largest_m = std::max(largest_m, std::abs(range.innovation_m));
  }
  EXPECT_GT(largest_m, 2);
}

TEST(VehicleSim, PublishesTheEstimateWithNavigationAndTheTruthAsBefore) {
  const auto nav_of = [](const Mission& mission, std::vector<nav_t>* estimates) {
    MemoryBus hub;
    Bus& own = hub.Join("vehicle_sim_alpha");
    Bus& test = hub.Join("test");
    VehicleSimApp sim(mission, mission.vehicles[0], own);
    nav_t nav{};
    Subscribe(test, channels::Nav("alpha"), [&](const nav_t& each) { nav = each; });
    Subscribe(test, channels::EstimatedNav("alpha"),
              [&](const nav_t& each) { estimates->push_back(each); });
    for (int i = 0; i < 20; ++i) {
      hub.NextStep();
      hub.Handle(own);
      sim.Tick(i * kTick_us);
      hub.NextStep();
      hub.Handle(test);
    }
    return nav;
  };
  std::vector<nav_t> estimates;
  const Mission with = OneAuv();
  Mission without = OneAuv();
  without.vehicles[0].navigation.is_fitted = false;
  const nav_t truth = nav_of(without, &estimates);
  EXPECT_TRUE(estimates.empty());
  const nav_t same = nav_of(with, &estimates);
  EXPECT_EQ(same.x_m, truth.x_m);
  EXPECT_EQ(same.heading_deg, truth.heading_deg);
  ASSERT_EQ(estimates.size(), 20U);
  EXPECT_NE(estimates.back().x_m, truth.x_m);
  EXPECT_EQ(estimates.back().utime, truth.utime);
}

TEST(VehicleSim, BeginsItsNavigationAnewWhereItIsReset) {
  const Mission mission = OneAuv();
  NavigationUnit unit(mission, mission.vehicles[0]);
  static_cast<void>(Rest(&unit, 0, 0, 50));
  unit.Start({.x_m = 700, .heading_deg = 40, .depth_m = 20});
  EXPECT_NEAR(Rest(&unit, 700, 50, 10).x_m, 700, 10);
}

}  // namespace shoal::navigation_unit_test
