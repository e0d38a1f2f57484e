#include "apps/helm/task_list.h"

#include <gtest/gtest.h>

#include <string>

#include "apps/helm/vessel_testing.h"

namespace shoal::task_list_test {

Fix At(double x_m, double y_m, double time_s = 0) {
  return {.position_m = {x_m, y_m}, .heading_rad = 0, .time_s = time_s};
}

HelmOrder Order(OrderKind kind) { return {.kind = kind}; }

std::string TaskName(const TaskList& tasks) {
  return tasks.task() == nullptr ? "" : tasks.task()->name;
}

class TaskListTest : public testing::Test {
 protected:
  TaskList tasks_{TestVehicle()};
};

TEST_F(TaskListTest, KeepsStationHereWhenTheListEndsAndStartsItAgainWhenDeployed) {
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  tasks_.Advance(At(0, 30, 0));
  EXPECT_EQ(TaskName(tasks_), "circle");
  tasks_.Advance(At(0, 30, 61));
  EXPECT_EQ(TaskName(tasks_), "circle");
  EXPECT_TRUE(tasks_.guidance()->done);
  tasks_.Advance(At(0, 30, 61.1));
  EXPECT_EQ(TaskName(tasks_), "end_of_tasks");
  EXPECT_EQ(tasks_.guidance()->waypoint_m, Eigen::Vector2d(0, 30));

  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(0, 30, 62));
  EXPECT_EQ(TaskName(tasks_), "survey");
}

TEST_F(TaskListTest, KeepsStationAtOnceWithAnEmptyList) {
  Vehicle vehicle = TestVehicle();
  vehicle.tasks.clear();
  TaskList tasks(vehicle);
  EXPECT_EQ(tasks.Execute(Order(OrderKind::kDeploy)), "");
  tasks.Advance(At(3, 4));
  EXPECT_EQ(TaskName(tasks), "end_of_tasks");
  EXPECT_EQ(tasks.guidance()->speed_mps, 0);
}

TEST_F(TaskListTest, GoesToAPointAndKeepsStationThere) {
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kGoto, .point_m = {50, 60}}), "");
  tasks_.Advance(At(0, 0, 0));
  EXPECT_EQ(TaskName(tasks_), "goto");
  EXPECT_EQ(KindOf(*tasks_.task()), "waypoints");
  tasks_.Advance(At(48, 58, 60));
  tasks_.Advance(At(48, 58, 60.1));
  EXPECT_EQ(TaskName(tasks_), "goto");
  EXPECT_EQ(KindOf(*tasks_.task()), "station_keep");
  EXPECT_EQ(tasks_.guidance()->waypoint_m, Eigen::Vector2d(50, 60));
}

TEST_F(TaskListTest, GoesOnWithMovedWaypointsWhereItWas) {
  Vehicle vehicle = TestVehicle();
  vehicle.tasks = {
      {.name = "way", .what = WaypointsTask{.points_m = {{0, 100}, {0, 200}, {0, 300}}}},
      {.name = "round", .what = LoiterTask{.center_m = {0, 0}}}};
  TaskList tasks(vehicle);
  EXPECT_EQ(tasks.Execute(Order(OrderKind::kDeploy)), "");
  tasks.Advance(At(0, 0, 0));
  tasks.Advance(At(0, 99, 60));  // The first is reached.
  EXPECT_EQ(tasks.guidance()->waypoint_index, 1);
  const std::vector<double> places = {9, 9, 50, 200, 0, 300, 0, 400};
  EXPECT_EQ(tasks.Move("way", places), "");
  tasks.Advance(At(0, 100, 61));
  EXPECT_EQ(tasks.guidance()->waypoint_index, 1) << "what was passed stays passed";
  EXPECT_EQ(tasks.guidance()->waypoint_m, Eigen::Vector2d(50, 200));
  const std::vector<double> one = {20, 30};
  EXPECT_EQ(tasks.Move("way", one), "");
  tasks.Advance(At(0, 100, 62));
  EXPECT_EQ(tasks.guidance()->waypoint_m, Eigen::Vector2d(20, 30)) << "the last there is";
}

TEST_F(TaskListTest, MovesTasksThatAreStillToCome) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(0, 0, 0));
  const Eigen::Vector2d before_m = tasks_.guidance()->waypoint_m;
  const std::vector<double> place = {500, 600};
  EXPECT_EQ(tasks_.Move("circle", place), "");
  tasks_.Advance(At(0, 0, 1));
  EXPECT_EQ(tasks_.guidance()->waypoint_m, before_m);
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  tasks_.Advance(At(500, 600, 2));
  EXPECT_LT((tasks_.guidance()->waypoint_m - Eigen::Vector2d(500, 600)).norm(), 200);
}

TEST_F(TaskListTest, StatesWhyATaskCannotBeMoved) {
  const std::vector<double> places = {1, 2, 3, 4};
  EXPECT_EQ(tasks_.Move("nowhere", places), "move: there is no task 'nowhere'");
  EXPECT_EQ(tasks_.Move("circle", places), "move: loiter has one place: give X Y");
}

TEST_F(TaskListTest, GoesOnWithTheListAfterAnInterruption) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(0, 0, 0));
  tasks_.Advance(At(0, 99, 60));
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kStationKeep)), "");
  tasks_.Advance(At(7, 8, 61));
  EXPECT_EQ(tasks_.guidance()->waypoint_m, Eigen::Vector2d(7, 8));
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(7, 8, 62));
  EXPECT_EQ(TaskName(tasks_), "survey");
  EXPECT_EQ(tasks_.guidance()->waypoint_index, 1);
}

TEST_F(TaskListTest, SailsAtTheOrderedSpeedUntilTheNextTask) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  EXPECT_EQ(tasks_.ChangeSpeed(3), "");
  tasks_.Advance(At(0, 0, 0));
  EXPECT_EQ(tasks_.guidance()->speed_mps, 3);
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(0, 0, 1));
  EXPECT_EQ(tasks_.guidance()->speed_mps, 3);
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  tasks_.Advance(At(0, 0, 2));
  EXPECT_EQ(tasks_.guidance()->speed_mps, 1.5);
}

TEST_F(TaskListTest, DoesNotSetAKeptStationInMotionByASpeed) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kStationKeep)), "");
  EXPECT_EQ(tasks_.ChangeSpeed(3), "");
  tasks_.Advance(At(0, 0, 0));
  EXPECT_EQ(tasks_.guidance()->speed_mps, 0);
}

TEST_F(TaskListTest, ChangesNothingForATaskThatIsNotThere) {
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kTask, .task = "nowhere"}),
            "task: there is no task 'nowhere'");
  EXPECT_EQ(TaskName(tasks_), "");
}

TEST_F(TaskListTest, AsksForNothingWhileItPauses) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kDeploy)), "");
  tasks_.Advance(At(0, 0, 0));
  tasks_.Pause();
  EXPECT_FALSE(tasks_.guidance().has_value());
  EXPECT_EQ(TaskName(tasks_), "survey");
}

TEST_F(TaskListTest, HasNoEndingWhereTheListIsEmptyAndBehaviorsLead) {
  Vehicle vehicle = TestVehicle();
  vehicle.tasks.clear();
  vehicle.behaviors = {{.name = "stop", .what = AnyBehavior(FullStopOptions{})}};
  TaskList tasks(vehicle);
  EXPECT_EQ(tasks.Execute(Order(OrderKind::kDeploy)), "");
  tasks.Advance(At(3, 4));
  EXPECT_EQ(TaskName(tasks), "");
  EXPECT_FALSE(tasks.guidance().has_value());
}

TEST_F(TaskListTest, IsInterruptedByOrdersAndNotByItsEnding) {
  EXPECT_EQ(tasks_.Execute(Order(OrderKind::kReturn)), "");
  EXPECT_TRUE(tasks_.is_interrupted());
  EXPECT_EQ(tasks_.Execute({.kind = OrderKind::kTask, .task = "circle"}), "");
  EXPECT_FALSE(tasks_.is_interrupted());
  for (const double time_s : {0.0, 61.0, 61.1}) tasks_.Advance(At(0, 30, time_s));
  EXPECT_EQ(TaskName(tasks_), "end_of_tasks");
  EXPECT_FALSE(tasks_.is_interrupted());
}

}  // namespace shoal::task_list_test
