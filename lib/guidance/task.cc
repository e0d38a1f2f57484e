#include "lib/guidance/task.h"

namespace shoal {

namespace {

struct Kind {
  std::string_view operator()(const WaypointsTask&) const { return "waypoints"; }
  std::string_view operator()(const LoiterTask&) const { return "loiter"; }
  std::string_view operator()(const StationKeepTask&) const { return "station_keep"; }
  std::string_view operator()(const ReturnTask&) const { return "return"; }
  std::string_view operator()(const PathFollowTask&) const { return "path_follow"; }
  std::string_view operator()(const TargetTrackTask&) const { return "target_track"; }
};

}  // namespace

std::string_view KindOf(const Task& task) { return std::visit(Kind{}, task.what); }

}  // namespace shoal
