// The places of a mission file that a person can move on a map: starts, waypoints, loiters,
// surveys, regions, obstacles, the area of operations; each with where its numbers stand in the
// text. plan_edit.h changes them.
//
// Left out: what a template or a fleet gives to several vehicles, points that count from the
// vehicle's start (points_frame), and points that are written as one text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/plan/toml_text.h"

namespace shoal {

enum class PlanShape {
  kPoint,    ///< One place.
  kLine,     ///< One or more, in their order.
  kPolygon,  ///< Three or more.
};

struct PlanPoint {
  double x_m = 0;
  double y_m = 0;
  TextSpan x = {};  ///< The number; empty: the file does not have it.
  TextSpan y = {};
  TextSpan whole = {};  ///< "[10, -20]"; of a table and of a point alone, its value.
};

struct PlanHandle {
  std::string vehicle = {};  ///< Empty: of the mission.
  std::string name = {};     ///< Of the task, behavior or obstacle; empty: it has none.
  std::string kind = {};     ///< "start", "waypoints", "survey", "obstacle", "op_area", ...
  std::string key = {};      ///< "points"
  std::string updates = {};  ///< The variable of a behavior's updates; empty: it takes none.
  PlanShape shape = PlanShape::kPoint;
  std::vector<PlanPoint> points = {};
};

struct PlanVehicle {
  std::string name = {};
  size_t end = 0;  ///< Where a table of it can be added: the begin of a line, or the text's end.
  std::vector<std::string> task_names = {};
};

struct PlanText {
  std::vector<PlanHandle> handles = {};     ///< In the order of the file.
  std::vector<PlanVehicle> vehicles = {};   ///< Of [[vehicle]].
  std::optional<size_t> mission_keys = {};  ///< The line behind [mission]; absent: it has none.
};

/// Returns the places of a text; nothing where it is not TOML.
[[nodiscard]] std::optional<PlanText> ReadPlan(std::string_view text);

}  // namespace shoal
