#include "lib/helm/behaviors/contact_recipe.h"

#include <algorithm>
#include <cctype>

#include "lib/base/geometry/angles.h"
#include "lib/base/geometry/convex_polygon.h"
#include "lib/base/text/letters.h"

namespace shoal {
namespace {

constexpr double kAlertHorizon_s = 36'000;
constexpr double kCompletedFactor = 1.1;  // A little behind the alert's end.

bool Holds(const std::vector<std::string>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& each) { return IsSameWord(each, name); });
}

bool PassesOne(const std::vector<std::string>& match, const std::vector<std::string>& ignore,
               const std::string& value) {
  return (match.empty() || Holds(match, value)) && !Holds(ignore, value);
}

}  // namespace

std::optional<AlertRange> AlertRangeOf(const AnyBehavior& what) {
  if (const auto* avoid = std::get_if<AvoidCollisionOptions>(&what)) {
    return AlertRange{avoid->pwt_outer_dist, avoid->completed_dist};
  }
  if (const auto* colregs = std::get_if<ColregsOptions>(&what)) {
    return AlertRange{colregs->pwt_outer_dist, colregs->completed_dist};
  }
  const ContactOptions* options = ContactOptionsOf(what);
  if (options == nullptr || options->alert_range < 0) return std::nullopt;
  return AlertRange{options->alert_range, options->alert_range + 1, false};
}

bool IsAlert(const AlertRange& range, const VesselMotion& own, const VesselMotion& contact) {
  const Eigen::Vector2d offset_m = own.position_m - contact.position_m;
  const double distance_m = offset_m.norm();
  if (distance_m > range.cpa_m) return false;
  if (distance_m <= range.alert_m) return true;
  const auto velocity = [](const VesselMotion& vessel) -> Eigen::Vector2d {
    return vessel.speed_mps * UnitVector(DegToRad(vessel.heading_deg));
  };
  const Eigen::Vector2d velocity_mps = velocity(own) - velocity(contact);
  return ClosestApproach(offset_m, velocity_mps, kAlertHorizon_s) <= range.alert_m;
}

const ContactOptions* ContactOptionsOf(const AnyBehavior& what) {
  return std::visit(
      [](const auto& options) -> const ContactOptions* {
        if constexpr (requires { options.contact.match_name; }) return &options.contact;
        return nullptr;
      },
      what);
}

bool Passes(const ContactOptions& filter, const ContactView& contact) {
  return PassesOne(filter.match_name, filter.ignore_name, contact.name) &&
         PassesOne(filter.match_group, filter.ignore_group, contact.group) &&
         PassesOne(filter.match_type, filter.ignore_type, contact.type);
}

double DistanceTo(const std::vector<Eigen::Vector2d>& polygon_m, const Eigen::Vector2d& point_m) {
  return std::max(0.0, SignedDistance(polygon_m, point_m));
}

std::string EndReason(const BehaviorOptions& options, const BehaviorOrigin& origin,
                      const BehaviorInputs& inputs) {
  if (!origin.obstacle.empty()) {
    const auto& avoid = std::get<AvoidObstacleOptions>(options.what);
    const double distance_m = DistanceTo(avoid.polygon, inputs.own.motion.position_m);
    return distance_m > kCompletedFactor * avoid.completed_dist ? "the obstacle is passed" : "";
  }
  if (origin.contact.empty()) return {};
  const auto contact = inputs.contacts->find(origin.contact);
  if (contact == inputs.contacts->end()) return "its contact is no longer known";
  const ContactOptions& filter = *ContactOptionsOf(options.what);
  if (filter.exit_on_filter_group &&
      !PassesOne(filter.match_group, filter.ignore_group, contact->second.group)) {
    return "its contact has left the group";
  }
  const auto range = AlertRangeOf(options.what);
  if (!range || !range->ends) return {};
  const double distance_m = (contact->second.now.position_m - inputs.own.motion.position_m).norm();
  return distance_m >= kCompletedFactor * range->cpa_m ? "its contact is far away" : "";
}

}  // namespace shoal
