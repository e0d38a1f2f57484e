// What the judge saw that no expectation is about, and that is rarely meant.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "lib/verdict/judge.h"

namespace shoal {

namespace {

constexpr size_t kMaxNamesShown = 5;
/// Vehicles that travelled less have not moved: a helm that keeps station or is in PARK.
constexpr double kMoved_m = 1;

/// Returns "alpha", "alpha, bravo", or the first ones "and 12 more".
std::string Listed(const std::vector<std::string>& names) {
  const size_t num_shown = std::min(names.size(), kMaxNamesShown);
  std::string text = fmt::format("{}", fmt::join(std::span(names).first(num_shown), ", "));
  if (num_shown < names.size()) text += fmt::format(" and {} more", names.size() - num_shown);
  return text;
}

}  // namespace

std::vector<std::string> Judge::Warnings() const {
  std::vector<std::string> warnings;
  bool has_helm = false;
  bool was_deployed = false;
  for (size_t i = 0; i < helms_.size(); ++i) {
    has_helm |= helms_[i].has_value();
    was_deployed |= has_left_park_[i];
  }
  const double farthest_m =
      travelled_m_.empty() ? 0 : *std::max_element(travelled_m_.begin(), travelled_m_.end());
  if (mission_.MayBeSteeredFromOutside()) {
    // What such programs do, and leave, is their business.
  } else if (has_helm && !was_deployed) {
    warnings.push_back("no vehicle was deployed: every helm stayed in PARK");
  } else if (farthest_m < kMoved_m) {
    warnings.push_back(fmt::format("no vehicle moved: none travelled {:g} m", kMoved_m));
  }
  if (const std::string names = VehiclesWithoutReports(); !names.empty()) {
    warnings.push_back("received no report of another vehicle: " + names);
  }
  for (const Case& each : cases_) {
    std::vector<std::string> names;
    for (size_t i = 0; i < each.arrivals.size(); ++i) {
      if (each.arrivals[i].is_met_from_start()) {
        names.push_back(mission_.vehicles[each.vehicles[i]].name);
      }
    }
    if (names.empty()) continue;
    warnings.push_back(fmt::format(
        "an arrival was met before the vehicle had left, by {}: stays = true, or another "
        "point, tests more [{}]",
        Listed(names), each.expectation->where));
  }
  return warnings;
}

/// Returns the names of vehicles to which none of the others' reports was delivered, where others
/// have a node_reporter and there is a broker.
std::string Judge::VehiclesWithoutReports() const {
  if (mission_.broker == Provider::kNone) return {};
  size_t num_reporters = 0;
  for (const Vehicle& vehicle : mission_.vehicles) {
    if (mission_.IsReported(vehicle)) ++num_reporters;
  }
  std::vector<std::string> names;
  for (size_t i = 0; i < mission_.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission_.vehicles[i];
    if (num_reporters < (mission_.IsReported(vehicle) ? 2U : 1U)) continue;
    const int place = static_cast<int>(i);
    if (fates(Kind::kReport).Count(FateCounts::kAll, place, "delivered") == 0) {
      names.push_back(vehicle.name);
    }
  }
  return names.empty() ? std::string() : Listed(names);
}

}  // namespace shoal
