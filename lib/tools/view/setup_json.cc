#include "lib/tools/view/setup_json.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lib/base/check/enum_table.h"
#include "lib/base/time/seconds.h"
#include "lib/comms/routing/cause.h"
#include "lib/comms/routing/control.h"
#include "lib/helm/behaviors/behavior_outline.h"
#include "lib/mission/file/ocean_of.h"
#include "lib/mission/model/coverage_area.h"
#include "lib/mission/model/vehicle_colors.h"
#include "lib/run/command_line/version.h"
#include "lib/tools/view/background_tiles.h"
#include "lib/tools/view/fate_text.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/outline_json.h"

namespace shoal {

namespace {

/// An area that is to be covered.
void WriteCoverage(const Mission& mission, const CoverageExpectation& coverage, JsonWriter* json) {
  json->BeginObject().Number("width_m", coverage.sensor_width_m, kCentimetres).Key("areas");
  json->BeginArray();
  for (const auto& polygon_m : PolygonsOf(mission, coverage)) WritePoints(polygon_m, json);
  json->EndArray().Key("vehicles").BeginArray();
  for (const size_t place : VehiclesOf(mission, coverage)) {
    json->Text(mission.vehicles[place].name);
  }
  json->EndArray().EndObject();
}

void WriteVehicle(const Mission& mission, const Vehicle& vehicle, uint32_t color, bool knows_models,
                  JsonWriter* json) {
  json->BeginObject()
      .Text("name", vehicle.name)
      .Text("type", vehicle.type)
      .Text("color", vehicle.color)
      .Text("shown_color", ColorText(color))
      .Text("group", vehicle.group)
      .Number("length_m", vehicle.length_m, kCentimetres)
      .Text("model", knows_models ? FactsOfModel(vehicle.model).name : "")
      .Boolean("in_swarm", mission.SwarmOf(vehicle) != nullptr)
      .Boolean("has_helm", vehicle.helm != Provider::kNone)
      .Key("start");
  WritePoint({vehicle.start.x_m, vehicle.start.y_m}, json);
  json->Key("return");
  WritePoint(vehicle.return_task.point_m, json);
  json->Key("tasks").BeginArray();
  for (const Task& task : vehicle.tasks) {
    WriteOutline(task.name, KindOf(task), FactsOf(task).outline, json);
  }
  json->EndArray().Key("behaviors").BeginArray();
  for (const BehaviorOptions& behavior : vehicle.behaviors) {
    for (const TaskOutline& outline : OutlinesOf(behavior.what)) {
      WriteOutline(behavior.name, KindOf(behavior.what), outline, json);
    }
  }
  json->EndArray().EndObject();
}

void WriteCause(const CauseRow& row, JsonWriter* json) {
  constexpr EnumTable<CauseOutcome, std::string_view> kOutcomes = {"whole", "damaged", "stopped",
                                                                   "pending"};
  json->BeginObject()
      .Text("key", row.key)
      .Text("text", CauseWords(row.cause))
      .Text("color", row.color)
      .Text("outcome", kOutcomes[row.outcome])
      .EndObject();
}

/// A rule that can change while the mission runs.
void WriteRule(const ControlRow& row, JsonWriter* json) {
  json->BeginObject()
      .Text("rule", row.rule)
      .Text("label", row.label)
      .Text("unit", row.unit)
      .Boolean("of_vehicle", row.of_vehicle)
      .Boolean("takes_value", row.type != ControlType::kRequest)
      .Text("values", row.values)
      .Text("example", row.example)
      .Text("about", row.about)
      .EndObject();
}

/// A square grid of samples.
struct SampleGrid {
  Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();  ///< The most south-western.
  double step_m = 1;
  int nx = 1;
  int ny = 1;
};

/// Returns the grid with the shortest step of 1, 2 or 5 times a power of ten that has at most
/// kMaxSide samples each way; they stand at multiples of the step.
SampleGrid GridOver(const Eigen::AlignedBox2d& area_m) {
  constexpr int kMaxSide = 101;
  constexpr double kLeastStep_m = 1;
  SampleGrid grid;
  double decade_m = kLeastStep_m;
  for (int i = 0;; ++i) {
    constexpr std::array<double, 3> kDigits = {1, 2, 5};
    if (i == 3) {
      i = 0;
      decade_m *= 10;
    }
    grid.step_m = kDigits.at(static_cast<size_t>(i)) * decade_m;
    const Eigen::Array2d first = (area_m.min().array() / grid.step_m).floor();
    const Eigen::Array2d last = (area_m.max().array() / grid.step_m).ceil();
    if (((last - first) >= kMaxSide).any()) continue;
    grid.corner_m = first * grid.step_m;
    grid.nx = static_cast<int>(last.x() - first.x()) + 1;
    grid.ny = static_cast<int>(last.y() - first.y()) + 1;
    return grid;
  }
}

/// Returns the area of what is planned and of op_area, with a margin. A vehicle without a plan, a
/// shore station for one, adds to it where it begins no farther beside it than it reaches: a
/// larger grid is a coarser one.
Eigen::AlignedBox2d AreaOf(const Mission& mission) {
  constexpr double kLeastMargin_m = 100;
  constexpr double kMarginPerSide = 0.2;
  Eigen::AlignedBox2d area_m;
  const auto add = [&](const Eigen::Vector2d& point_m) {
    if (point_m.allFinite()) area_m.extend(point_m);
  };
  for (const Eigen::Vector2d& corner_m : mission.op_area_m) add(corner_m);
  for (const Obstacle& obstacle : mission.obstacles) {
    for (const Eigen::Vector2d& corner_m : obstacle.polygon_m) add(corner_m);
  }
  std::vector<Eigen::Vector2d> still_m;
  for (const Vehicle& vehicle : mission.vehicles) {
    const Eigen::Vector2d start_m(vehicle.start.x_m, vehicle.start.y_m);
    if (vehicle.tasks.empty() && vehicle.behaviors.empty()) {
      still_m.push_back(start_m);
      continue;
    }
    add(start_m);
    add(vehicle.return_task.point_m);
    const auto add_outline = [&](const TaskOutline& outline) {
      for (const Eigen::Vector2d& point_m : outline.points_m) add(point_m);
      for (const Eigen::Vector2d& corner_m : outline.area_m) add(corner_m);
    };
    for (const Task& task : vehicle.tasks) add_outline(FactsOf(task).outline);
    for (const BehaviorOptions& behavior : vehicle.behaviors) {
      for (const TaskOutline& outline : OutlinesOf(behavior.what)) add_outline(outline);
    }
  }
  const Eigen::AlignedBox2d planned_m = area_m;
  for (const Eigen::Vector2d& point_m : still_m) {
    const bool is_near =
        planned_m.isEmpty() || planned_m.exteriorDistance(point_m) <=
                                   std::max(kLeastMargin_m, planned_m.sizes().maxCoeff());
    if (is_near) add(point_m);
  }
  if (area_m.isEmpty()) area_m.extend(Eigen::Vector2d(0, 0));
  const double margin_m = std::max(kLeastMargin_m, kMarginPerSide * area_m.sizes().maxCoeff());
  area_m.min().array() -= margin_m;
  area_m.max().array() += margin_m;
  return area_m;
}

}  // namespace

std::string SetupJson(const Mission& mission, const SetupFacts& facts,
                      const std::string& floor_json) {
  JsonWriter json;
  json.BeginObject()
      .Integer("protocol", kViewProtocol)
      .Text("mode", facts.mode)
      .Text("boot", facts.boot)
      .Text("mission", mission.name)
      .Text("file", mission.file)
      .Text("version", kVersion)
      .Key("seed")
      .Raw(std::to_string(mission.seed))
      .Number("duration_s", mission.duration_s, 3)
      .Number("tick_s", Seconds(mission.tick_us), 6)
      .Boolean("commands", facts.commands)
      .Number("begin_s", facts.begin_s, 3)
      .Number("end_s", facts.end_s, 3)
      .Key("origin")
      .BeginObject()
      .Number("lat_deg", mission.origin_lat_deg, 6)
      .Number("lon_deg", mission.origin_lon_deg, 6)
      .EndObject()
      .Key("op_area");
  WritePoints(mission.op_area_m, &json);
  json.Key("obstacles").BeginArray();
  for (const Obstacle& obstacle : mission.obstacles) {
    json.BeginObject().Text("id", obstacle.id).Key("polygon");
    WritePoints(obstacle.polygon_m, &json);
    json.EndObject();
  }
  json.EndArray().Key("vehicles").BeginArray();
  std::vector<std::string> requested;
  for (const Vehicle& vehicle : mission.vehicles) requested.push_back(vehicle.color);
  const std::vector<uint32_t> colors = ChooseColors(requested);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    WriteVehicle(mission, mission.vehicles[i], colors[i], facts.knows_models, &json);
  }
  json.EndArray().Key("coverage").BeginArray();
  for (const Expectation& expectation : mission.expectations) {
    if (const auto* coverage = std::get_if<CoverageExpectation>(&expectation.what)) {
      WriteCoverage(mission, *coverage, &json);
    }
  }
  json.EndArray().Key("causes").BeginArray();
  for (const CauseRow& row : kCauseTable) WriteCause(row, &json);
  json.EndArray().Key("rules").BeginArray();
  for (const ControlRow& row : ControlTable()) WriteRule(row, &json);
  json.EndArray().Key("orders").BeginArray();
  std::set<std::string_view> orders;
  for (const NamedOrder& order : mission.orders) {
    if (orders.insert(order.name).second) json.Text(order.name);
  }
  json.EndArray().Key("backgrounds");
  WriteBackgrounds(BackgroundsOf(mission), &json);
  json.Key("floor").Raw(floor_json).Key("notes").BeginArray();
  for (const std::string& note : facts.notes) json.Text(note);
  json.EndArray().EndObject();
  return json.Take();
}

std::string FloorJson(const Mission& mission, std::vector<std::string>* notes) {
  if (mission.environment.floor.style == "none") return "null";
  const Result<Ocean> ocean = OceanOf(mission);
  if (!ocean.ok()) {
    notes->push_back("the sea floor is not shown: " + ocean.error());
    return "null";
  }
  if (!(*ocean).floor) return "null";
  const SampleGrid grid = GridOver(AreaOf(mission));
  JsonWriter json;
  json.BeginObject()
      .Number("x0", grid.corner_m.x(), kCentimetres)
      .Number("y0", grid.corner_m.y(), kCentimetres)
      .Number("step_m", grid.step_m, kCentimetres)
      .Integer("nx", grid.nx)
      .Integer("ny", grid.ny)
      .Key("depth_m")
      .BeginArray();
  for (int row = 0; row < grid.ny; ++row) {
    for (int column = 0; column < grid.nx; ++column) {
      const Eigen::Vector2d place_m = grid.corner_m + grid.step_m * Eigen::Vector2d(column, row);
      json.Number((*ocean).floor->DepthAt(place_m), 1);
    }
  }
  json.EndArray().EndObject();
  return json.Take();
}

}  // namespace shoal
