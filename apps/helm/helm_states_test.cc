#include "apps/helm/helm_states.h"

#include <gtest/gtest.h>

#include <string>

#include "apps/helm/vessel_testing.h"

namespace shoal::helm_states_test {

Fix At(double x_m, double y_m, double time_s = 0) {
  return {.position_m = {x_m, y_m}, .heading_rad = 0, .time_s = time_s};
}

HelmOrder Order(OrderKind kind) { return {.kind = kind}; }

std::string TaskName(const HelmStates& helm) {
  return helm.task() == nullptr ? "" : helm.task()->name;
}

class HelmStatesTest : public testing::Test {
 protected:
  HelmStates helm_{TestVehicle()};
};

TEST_F(HelmStatesTest, IsParkedUntilDeployed) {
  helm_.Advance(At(0, 0), false);
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
  EXPECT_EQ(helm_.all_stop(), "never deployed");
  EXPECT_EQ(TaskName(helm_), "");
  EXPECT_FALSE(helm_.guidance().has_value());

  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 0), false);
  EXPECT_EQ(helm_.mode(), HelmMode::kDrive);
  EXPECT_EQ(helm_.all_stop(), "clear");
  EXPECT_EQ(TaskName(helm_), "survey");
  EXPECT_TRUE(helm_.guidance().has_value());
}

TEST_F(HelmStatesTest, GoesOnWithTheListWhereItWasParked) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 0, 0), false);
  helm_.Advance(At(0, 99, 60), false);
  EXPECT_EQ(helm_.guidance()->waypoint_index, 1);

  EXPECT_EQ(helm_.Execute(Order(OrderKind::kPark)), "");
  helm_.Advance(At(0, 99, 61), false);
  EXPECT_EQ(helm_.all_stop(), "parked");
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 99, 62), false);
  EXPECT_EQ(helm_.guidance()->waypoint_index, 1);
}

TEST_F(HelmStatesTest, StatesTheReasonThatCameWithAnAllStop) {
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kAllStop, .reason = "collision with bravo"}), "");
  EXPECT_EQ(helm_.mode(), HelmMode::kAllStop);
  EXPECT_EQ(helm_.all_stop(), "collision with bravo");
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kResume)), "");
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kAllStop)), "");
  EXPECT_EQ(helm_.all_stop(), "all_stop command");
}

TEST_F(HelmStatesTest, StandsStillAfterAllStopUntilResume) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 0), false);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kAllStop)), "");
  helm_.Advance(At(0, 1), false);
  EXPECT_EQ(helm_.mode(), HelmMode::kAllStop);
  EXPECT_EQ(helm_.all_stop(), "all_stop command");
  EXPECT_FALSE(helm_.guidance().has_value());
  EXPECT_EQ(TaskName(helm_), "survey");

  EXPECT_EQ(helm_.Execute(Order(OrderKind::kResume)), "");
  helm_.Advance(At(0, 2), false);
  EXPECT_EQ(helm_.mode(), HelmMode::kDrive);
  EXPECT_EQ(TaskName(helm_), "survey");
}

TEST_F(HelmStatesTest, RefusesOrdersToMoveDuringAnAllStopByCommand) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kAllStop)), "");
  for (const OrderKind kind : {OrderKind::kDeploy, OrderKind::kReturn, OrderKind::kStationKeep,
                               OrderKind::kGoto, OrderKind::kSpeed, OrderKind::kTask}) {
    EXPECT_NE(helm_.Execute(Order(kind)), "");
    EXPECT_EQ(helm_.mode(), HelmMode::kAllStop);
  }
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kPark)), "");
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
}

TEST_F(HelmStatesTest, IsParkedAgainAfterAnAllStopInPark) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kAllStop)), "");
  EXPECT_EQ(helm_.mode(), HelmMode::kAllStop);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kResume)), "");
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
  EXPECT_NE(helm_.Execute(Order(OrderKind::kResume)), "");
}

TEST_F(HelmStatesTest, StopsWithoutNavAndGoesOnByItself) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kReturn)), "");
  helm_.Advance(At(0, 0), false);
  helm_.Advance(std::nullopt, true);
  EXPECT_EQ(helm_.mode(), HelmMode::kAllStop);
  EXPECT_EQ(helm_.all_stop(), "no NAV for 2.0 s");
  helm_.Advance(At(0, 0, 5), false);
  EXPECT_EQ(helm_.mode(), HelmMode::kDrive);
  EXPECT_EQ(TaskName(helm_), "return");
}

TEST_F(HelmStatesTest, KeepsStationHereWhenTheListEndsAndStartsItAgainWhenDeployed) {
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  helm_.Advance(At(0, 30, 0), false);
  EXPECT_EQ(TaskName(helm_), "circle");
  helm_.Advance(At(0, 30, 61), false);
  EXPECT_EQ(TaskName(helm_), "circle");
  EXPECT_TRUE(helm_.guidance()->done);
  helm_.Advance(At(0, 30, 61.1), false);
  EXPECT_EQ(TaskName(helm_), "end_of_tasks");
  EXPECT_EQ(helm_.guidance()->waypoint_m, Eigen::Vector2d(0, 30));

  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 30, 62), false);
  EXPECT_EQ(TaskName(helm_), "survey");
}

TEST_F(HelmStatesTest, KeepsStationAtOnceWithAnEmptyList) {
  Vehicle vehicle = TestVehicle();
  vehicle.tasks.clear();
  HelmStates helm(vehicle);
  EXPECT_EQ(helm.Execute(Order(OrderKind::kDeploy)), "");
  helm.Advance(At(3, 4), false);
  EXPECT_EQ(TaskName(helm), "end_of_tasks");
  EXPECT_EQ(helm.guidance()->speed_mps, 0);
}

TEST_F(HelmStatesTest, GoesToAPointAndKeepsStationThere) {
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kGoto, .point_m = {50, 60}}), "");
  helm_.Advance(At(0, 0, 0), false);
  EXPECT_EQ(TaskName(helm_), "goto");
  EXPECT_EQ(KindOf(*helm_.task()), "waypoints");
  helm_.Advance(At(48, 58, 60), false);
  helm_.Advance(At(48, 58, 60.1), false);
  EXPECT_EQ(TaskName(helm_), "goto");
  EXPECT_EQ(KindOf(*helm_.task()), "station_keep");
  EXPECT_EQ(helm_.guidance()->waypoint_m, Eigen::Vector2d(50, 60));
}

TEST_F(HelmStatesTest, GoesOnWithTheListAfterAnInterruption) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 0, 0), false);
  helm_.Advance(At(0, 99, 60), false);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kStationKeep)), "");
  helm_.Advance(At(7, 8, 61), false);
  EXPECT_EQ(helm_.guidance()->waypoint_m, Eigen::Vector2d(7, 8));
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(7, 8, 62), false);
  EXPECT_EQ(TaskName(helm_), "survey");
  EXPECT_EQ(helm_.guidance()->waypoint_index, 1);
}

TEST_F(HelmStatesTest, SailsAtTheOrderedSpeedUntilTheNextTask) {
  EXPECT_NE(helm_.Execute({.kind = OrderKind::kSpeed, .speed_mps = 3}), "");
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kSpeed, .speed_mps = 3}), "");
  helm_.Advance(At(0, 0, 0), false);
  EXPECT_EQ(helm_.guidance()->speed_mps, 3);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(At(0, 0, 1), false);
  EXPECT_EQ(helm_.guidance()->speed_mps, 3);
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  helm_.Advance(At(0, 0, 2), false);
  EXPECT_EQ(helm_.guidance()->speed_mps, 1.5);
}

TEST_F(HelmStatesTest, DoesNotSetAKeptStationInMotionByASpeed) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kStationKeep)), "");
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kSpeed, .speed_mps = 3}), "");
  helm_.Advance(At(0, 0, 0), false);
  EXPECT_EQ(helm_.guidance()->speed_mps, 0);
}

TEST_F(HelmStatesTest, ChangesNothingForATaskThatIsNotThere) {
  EXPECT_EQ(helm_.Execute({.kind = OrderKind::kTask, .task = "nowhere"}),
            "task: there is no task 'nowhere'");
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
}

TEST_F(HelmStatesTest, WaitsForNavBeforeItStartsATask) {
  Vehicle vehicle = TestVehicle();
  vehicle.helm_options.deploy_at_start = true;
  HelmStates helm(vehicle);
  helm.Advance(std::nullopt, false);
  EXPECT_EQ(helm.mode(), HelmMode::kDrive);
  EXPECT_FALSE(helm.guidance().has_value());
  helm.Advance(At(0, 0), false);
  EXPECT_TRUE(helm.guidance().has_value());
}

}  // namespace shoal::helm_states_test
