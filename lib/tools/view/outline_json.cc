#include "lib/tools/view/outline_json.h"

namespace shoal {

void WritePoint(const Eigen::Vector2d& point_m, JsonWriter* json) {
  json->BeginArray().Number(point_m.x(), kCentimetres).Number(point_m.y(), kCentimetres).EndArray();
}

void WritePoints(const std::vector<Eigen::Vector2d>& points_m, JsonWriter* json) {
  json->BeginArray();
  for (const Eigen::Vector2d& point_m : points_m) WritePoint(point_m, json);
  json->EndArray();
}

void WriteOutline(std::string_view name, std::string_view kind, const TaskOutline& outline,
                  JsonWriter* json) {
  json->BeginObject().Text("name", name).Text("kind", kind).Key("points");
  WritePoints(outline.points_m, json);
  json->Boolean("closed", outline.closed)
      .Number("radius_m", outline.radius_m, kCentimetres)
      .Boolean("marked", outline.marks_points)
      .Key("area");
  WritePoints(outline.area_m, json);
  json->EndObject();
}

}  // namespace shoal
