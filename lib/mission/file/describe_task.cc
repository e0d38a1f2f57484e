// The tables [[vehicle.task]] and [vehicle.return].
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/describe.h"
#include "lib/mission/file/task_fields.h"

namespace shoal {
namespace {

void Describe(Fields& fields, WaypointsTask& task, const StartPose& start) {
  fields.Require("points", "points = [[0, 0], [100, 0]]");
  fields.Pairs("points", task.points_m, kTaskPlace, kMaxTaskPoints);
  if (task.points_m.empty() && fields.Has("points", true)) {
    fields.Refuse("points", "points must hold at least one point, like [[100, 0]]");
  }
  const Eigen::Vector2d offset_m = DescribeFrame(fields, start);
  for (Eigen::Vector2d& point_m : task.points_m) Move(fields, "points", point_m, offset_m);
  DescribeSpeed(fields, task.speed_mps);
  Describe(fields, task.capture);
  fields.SmallInteger("laps", task.laps, 0, 1'000'000);
  DescribeLineFollowing(fields, task);
}

void Describe(Fields& fields, LoiterTask& task, const StartPose& start) {
  fields.Require("center", "center = [100, -50]");
  fields.Pair("center", task.center_m, kTaskPlace);
  Move(fields, "center", task.center_m, DescribeFrame(fields, start));
  fields.Number("radius_m", task.radius_m, Above(0, 100'000));
  fields.SmallInteger("num_points", task.num_points, 3, 360);
  fields.Flag("clockwise", task.clockwise);
  DescribeSpeed(fields, task.speed_mps);
  Describe(fields, task.capture);
  DescribeLineFollowing(fields, task);
  fields.Number("duration_s", task.duration_s, Between(0, kLongest_s));
}

void Describe(Fields& fields, StationKeepTask& task, const StartPose& start) {
  task.here = !fields.Has("point", !task.here);
  const Eigen::Vector2d offset_m = DescribeFrame(fields, start);
  if (!task.here) {
    fields.Pair("point", task.point_m, kTaskPlace);
    Move(fields, "point", task.point_m, offset_m);
  }
  fields.Number("inner_radius_m", task.inner_radius_m, Above(0, 10'000));
  fields.Number("outer_radius_m", task.outer_radius_m, Above(0, 10'000));
  if (task.outer_radius_m <= task.inner_radius_m) {
    fields.Refuse("outer_radius_m", "outer_radius_m must be greater than inner_radius_m");
  }
  DescribeSpeed(fields, task.speed_mps);
}

}  // namespace

void Describe(Fields& fields, ReturnTask& task, const StartPose& start) {
  if (fields.reading()) task.point_m = {start.x_m, start.y_m};
  const bool has_point = fields.Has("point", true);
  fields.Pair("point", task.point_m, kTaskPlace);
  const Eigen::Vector2d offset_m = DescribeFrame(fields, start);
  if (has_point) Move(fields, "point", task.point_m, offset_m);
  DescribeSpeed(fields, task.speed_mps);
  Describe(fields, task.capture);
  fields.Number("outer_radius_m", task.outer_radius_m, Above(0, 10'000));
}

void Describe(Fields& fields, Task& task, const StartPose& start) {
  const std::vector<Task> kinds = OneTaskOfEachKind();
  std::vector<std::string_view> words;
  words.reserve(kinds.size());
  for (const Task& each : kinds) words.push_back(KindOf(each));
  std::string kind(fields.reading() ? "" : KindOf(task));
  fields.Require("kind", "kind = \"waypoints\"");
  fields.Word("kind", kind, words);
  if (fields.reading()) {
    for (const Task& each : kinds) {
      if (kind == KindOf(each)) task.what = each.what;
    }
    task.name = kind;
  }
  fields.Text("name", task.name, {.min_length = 1});
  fields.Number("pwt", task.pwt, Between(0, 1e6));
  if (kind.empty()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return;
  }
  std::visit([&](auto& what) { Describe(fields, what, start); }, task.what);
}

}  // namespace shoal
