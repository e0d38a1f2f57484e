// Behaviors that keep clear of contacts in the plane, and contacts that pass far below.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/helm/behaviors/contact_recipe.h"
#include "lib/mission/file/task_way.h"
#include "lib/mission/file/validate.h"

namespace shoal {

namespace {

/// Vessels so far apart in depth do not touch.
constexpr double kApart_m = 10;

/// Returns true where the behavior may keep clear of that vehicle.
bool MayKeepClearOf(const BehaviorOptions& behavior, const Vehicle& other) {
  const ContactOptions* options = ContactOptionsOf(behavior.what);
  if (options == nullptr) return false;
  if (!options->contact.empty()) return LowerCase(options->contact) == LowerCase(other.name);
  return Passes(*options, {.name = other.name, .group = other.group, .type = other.type});
}

}  // namespace

void WarnOfDivers(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& vehicle = mission.vehicles[i];
    const double own_m = DeepestOf_m(vehicle);
    for (size_t k = 0; k < vehicle.behaviors.size(); ++k) {
      const BehaviorOptions& behavior = vehicle.behaviors[k];
      const auto range = AlertRangeOf(behavior.what);
      if (!range || !range->ends) continue;  // It does not keep clear.
      const double separation_m = ContactOptionsOf(behavior.what)->vertical_separation;
      std::vector<std::string> names;
      for (const Vehicle& other : mission.vehicles) {
        const double apart_m = std::abs(DeepestOf_m(other) - own_m);
        const bool is_apart = apart_m >= kApart_m && (separation_m <= 0 || apart_m < separation_m);
        if (&other != &vehicle && is_apart && MayKeepClearOf(behavior, other)) {
          names.push_back(other.name);
        }
      }
      if (names.empty()) continue;
      file.Below("vehicle", i)
          .Below("behavior", k)
          .Warn("kind",
                fmt::format(
                    "{} keeps clear of {} as if both were at one depth, but their tasks are "
                    "{:g} m or more apart: write vertical_separation = {:g}, or leave contacts "
                    "out by ignore_name = [...]",
                    behavior.name, fmt::join(names, ", "), kApart_m,
                    ContactOptions().vertical_separation));
    }
  }
}

}  // namespace shoal
