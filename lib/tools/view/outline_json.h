// Places and outlines of tasks and behaviors as JSON: docs/extending/viewer_protocol.md,
// /api/setup.
#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "lib/tools/view/json_writer.h"
#include "lib/vehicle/guidance/task.h"

namespace shoal {

/// Writes [x, y].
void WritePoint(const Eigen::Vector2d& point_m, JsonWriter* json);
/// Writes [[x, y], ...].
void WritePoints(const std::vector<Eigen::Vector2d>& points_m, JsonWriter* json);
/// Writes one outline of a task, or of a behavior, which may have several.
void WriteOutline(std::string_view name, std::string_view kind, const TaskOutline& outline,
                  JsonWriter* json);

}  // namespace shoal
