#include "lib/vehicle/guidance/moved_task.h"

#include <gtest/gtest.h>

#include <limits>

namespace shoal::moved_task_test {

using Points = std::vector<Eigen::Vector2d>;

template <class T>
T Moved(T what, const std::vector<double>& values) {
  const Result<Task> task = MovedTask({.name = "x", .what = what}, values);
  EXPECT_TRUE(task.ok()) << task.error();
  return std::get<T>(task->what);
}

template <class T>
std::string Refusal(T what, const std::vector<double>& values) {
  return MovedTask({.name = "x", .what = what}, values).error();
}

TEST(MovedTask, HasOtherPlacesAndNothingElse) {
  const WaypointsTask way = {.points_m = {{0, 0}}, .speed_mps = 3, .laps = 2};
  const WaypointsTask moved = Moved(way, {1, 2, 3, 4});
  EXPECT_EQ(moved.points_m, (Points{{1, 2}, {3, 4}}));
  EXPECT_EQ(moved.speed_mps, 3);
  EXPECT_EQ(moved.laps, 2);
  EXPECT_EQ(Moved(LoiterTask{.radius_m = 20}, {5, 6}).center_m, Eigen::Vector2d(5, 6));
  EXPECT_EQ(Moved(LoiterTask{.radius_m = 20}, {5, 6}).radius_m, 20);
  EXPECT_FALSE(Moved(StationKeepTask{}, {5, 6}).here);
  EXPECT_EQ(Moved(ReturnTask{}, {5, 6}).point_m, Eigen::Vector2d(5, 6));
  const PathFollowTask path = {.points_m = {{0, 0, 10}, {9, 9, 20}}};
  EXPECT_EQ(Moved(path, {1, 2, 3, 4}).points_m[1], Eigen::Vector3d(3, 4, 20));
  SurveyTask survey;
  survey.area.polygon_m = {{0, 0}, {100, 0}, {100, 50}};
  survey.area.lane_spacing_m = 10;
  EXPECT_EQ(Moved(survey, {0, 0, 60, 0, 60, 60, 0, 60}).area.polygon_m.size(), 4u);
}

TEST(MovedTask, IsRefusedWhereItHasNoSuchPlaces) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(Refusal(WaypointsTask{}, {}).find("X Y of each point"), std::string::npos);
  EXPECT_NE(Refusal(WaypointsTask{}, {1, 2, 3}).find("X Y of each point"), std::string::npos);
  EXPECT_NE(Refusal(WaypointsTask{}, std::vector<double>(2002)).find("1 to 1000"),
            std::string::npos);
  EXPECT_NE(Refusal(WaypointsTask{}, {kNan, 2}).find("within 1000 km"), std::string::npos);
  EXPECT_NE(Refusal(WaypointsTask{}, {1, 1.1e6}).find("within 1000 km"), std::string::npos);
  EXPECT_EQ(Refusal(LoiterTask{}, {1, 2, 3, 4}), "loiter has one place: give X Y");
  EXPECT_NE(Refusal(PathFollowTask{.points_m = {{0, 0, 1}}}, {1, 2, 3, 4}).find("has 1 points"),
            std::string::npos);
  EXPECT_NE(Refusal(SurveyTask{}, {0, 0, 1, 1}).find("three corners"), std::string::npos);
  EXPECT_NE(Refusal(SurfaceTask{}, {1, 2}).find("surface has no place"), std::string::npos);
  EXPECT_NE(Refusal(TargetTrackTask{}, {1, 2}).find("target_track has no place"),
            std::string::npos);
}

}  // namespace shoal::moved_task_test
