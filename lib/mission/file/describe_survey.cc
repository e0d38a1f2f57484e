// The keys of [[vehicle.task]] kind = "survey".
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/file/task_fields.h"

namespace shoal {
namespace {

constexpr size_t kMaxPolygonCorners = 200;
constexpr size_t kMaxMembers = 10'000;
/// More would be a spacing in the wrong unit.
constexpr double kMaxLanes = 2000;

constexpr std::array<std::pair<std::string_view, SurveyEntry>, 5> kEntries = {{
    {"nearest", SurveyEntry::kNearest},
    {"north_west", SurveyEntry::kNorthWest},
    {"north_east", SurveyEntry::kNorthEast},
    {"south_east", SurveyEntry::kSouthEast},
    {"south_west", SurveyEntry::kSouthWest},
}};

constexpr std::array<std::pair<std::string_view, LaneEnds>, 2> kLaneEnds = {{
    {"cover", LaneEnds::kCover},
    {"inside", LaneEnds::kInside},
}};

}  // namespace

void DescribePolygon(Fields& fields, SurveyArea& area) {
  fields.Require("polygon", "polygon = [[0, 0], [200, 0], [200, 100], [0, 100]]");
  fields.Pairs("polygon", area.polygon_m, kTaskPlace, kMaxPolygonCorners);
}

void DescribeLanes(Fields& fields, SurveyArea& area) {
  fields.Number("lane_spacing_m", area.lane_spacing_m, Above(0, 100'000));
  if (fields.Has("lane_angle_deg", area.lane_angle_deg.has_value())) {
    double angle_deg = area.lane_angle_deg.value_or(0);
    fields.Number("lane_angle_deg", angle_deg, Between(-360, 360));
    area.lane_angle_deg = angle_deg;
  }
  fields.Choice("lane_ends", area.lane_ends, kLaneEnds);
  if (!fields.Has("polygon", true) || !fields.IsSound()) {
    area.polygon_m.clear();
    return;
  }
  std::string problem = PolygonProblem(area.polygon_m);
  std::string_view key = "polygon";
  if (problem.empty() && CountLanes(area) > kMaxLanes) {
    key = "lane_spacing_m";
    problem = fmt::format("lane_spacing_m = {} gives {:.0f} lanes; allowed: at most {}",
                          area.lane_spacing_m, CountLanes(area), kMaxLanes);
  }
  if (problem.empty()) return;
  fields.Refuse(key, problem);
  area.polygon_m.clear();
}

void DescribeRoute(Fields& fields, SurveyRoute& route) {
  fields.Choice("entry", route.entry, kEntries);
  fields.Number("turn_radius_m", route.turn_radius_m, Between(0, 10'000));
  fields.Number("overrun_m", route.overrun_m, Between(0, 10'000));
}

void Describe(Fields& fields, SurveyTask& task, const StartPose& start) {
  DescribePolygon(fields, task.area);
  const Eigen::Vector2d offset_m = DescribeFrame(fields, start);
  for (Eigen::Vector2d& corner_m : task.area.polygon_m) Move(fields, "polygon", corner_m, offset_m);
  DescribeLanes(fields, task.area);
  if (fields.reading()) task.route.start_m = {start.x_m, start.y_m};
  DescribeRoute(fields, task.route);
  fields.Texts("divide_among", task.divide_among, kMaxMembers);
  DescribeSpeed(fields, task.speed_mps);
  Describe(fields, task.capture);
  DescribeLineFollowing(fields, task);
}

}  // namespace shoal
