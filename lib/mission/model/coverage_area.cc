#include "lib/mission/model/coverage_area.h"

#include <algorithm>
#include <string>
#include <variant>

namespace shoal {

std::vector<size_t> VehiclesOf(const Mission& mission, const CoverageExpectation& coverage) {
  std::vector<size_t> places;
  const auto add = [&](const std::string& name) {
    for (const Vehicle* vehicle : mission.VehiclesNamed(name)) {
      places.push_back(static_cast<size_t>(vehicle - mission.vehicles.data()));
    }
  };
  for (const std::string& name : coverage.vehicles) add(name);
  if (coverage.vehicles.empty()) add("all");
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::vector<Eigen::Vector2d>> PolygonsOf(const Mission& mission,
                                                     const CoverageExpectation& coverage) {
  if (!coverage.polygon_m.empty()) return {coverage.polygon_m};
  std::vector<std::vector<Eigen::Vector2d>> polygons_m;
  for (const size_t place : VehiclesOf(mission, coverage)) {
    for (const Task& task : mission.vehicles[place].tasks) {
      const auto* survey = std::get_if<SurveyTask>(&task.what);
      if (survey == nullptr || survey->area.polygon_m.empty()) continue;
      const auto& polygon_m = survey->area.polygon_m;
      if (std::find(polygons_m.begin(), polygons_m.end(), polygon_m) == polygons_m.end()) {
        polygons_m.push_back(polygon_m);
      }
    }
  }
  return polygons_m;
}

}  // namespace shoal
