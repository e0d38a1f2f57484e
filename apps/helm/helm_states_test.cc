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

TEST_F(HelmStatesTest, ChangesTheSpeedOfATaskThatRunsAndNeitherDrivesNorParksForIt) {
  const HelmOrder faster{.kind = OrderKind::kSpeed, .speed_mps = 3};
  EXPECT_EQ(helm_.Execute(faster), "speed: no task runs");
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  EXPECT_EQ(helm_.Execute(faster), "");
  helm_.Advance(At(0, 0, 0), false);
  EXPECT_EQ(helm_.guidance()->speed_mps, 3);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kPark)), "");
  EXPECT_EQ(helm_.Execute(faster), "speed: no task runs");
}

TEST_F(HelmStatesTest, StaysParkedWhereAnOrderToMoveIsRefused) {
  EXPECT_NE(helm_.Execute({.kind = OrderKind::kTask, .task = "nowhere"}), "");
  EXPECT_EQ(helm_.mode(), HelmMode::kPark);
  EXPECT_EQ(helm_.all_stop(), "never deployed");
}

TEST_F(HelmStatesTest, ShowsTheTaskThatRunsAsOneAim) {
  EXPECT_EQ(helm_.aim().task, nullptr);
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kReturn)), "");
  EXPECT_EQ(helm_.aim().guidance, nullptr);
  helm_.Advance(At(0, 0), false);
  EXPECT_EQ(helm_.aim().task->name, "return");
  EXPECT_TRUE(helm_.aim().is_interruption);
  EXPECT_EQ(helm_.aim().guidance->waypoint_m, Eigen::Vector2d(0, -20));
}

TEST_F(HelmStatesTest, WaitsForNavBeforeItStartsATask) {
  EXPECT_EQ(helm_.Execute(Order(OrderKind::kDeploy)), "");
  helm_.Advance(std::nullopt, false);
  EXPECT_EQ(helm_.mode(), HelmMode::kDrive);
  EXPECT_FALSE(helm_.guidance().has_value());
  helm_.Advance(At(0, 0), false);
  EXPECT_TRUE(helm_.guidance().has_value());
}

}  // namespace shoal::helm_states_test
