#include "apps/helm/swarm_view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lib/geometry/angles.h"

namespace shoal {

namespace {

/// The laws' own bounds on what they are told (lib/guidance/plausible.h).
constexpr double kFarthest_m = 1e6;
constexpr double kFastest_mps = 1000;

Neighbour NeighbourOf(int id, const nav_t& nav) {
  const Eigen::Vector2d over_ground_mps =
      nav.speed_over_ground_mps * UnitVector(DegToRad(nav.course_over_ground_deg));
  return {.id = id,
          .position_m = {nav.x_m, nav.y_m, nav.z_m},
          .velocity_mps = {over_ground_mps.x(), over_ground_mps.y(), nav.descent_mps}};
}

/// Returns how the water moves: what is left of the velocity over ground without that through the
/// water, which NAV tells in the body's frame. Horizontal; roll turns only what is small.
Eigen::Vector3d CurrentOf(const nav_t& nav, const Eigen::Vector3d& over_ground_mps) {
  const double pitch_rad = DegToRad(nav.pitch_deg);
  const double heading_rad = DegToRad(nav.heading_deg);
  const double ahead_mps =
      nav.surge_mps * std::cos(pitch_rad) + nav.heave_mps * std::sin(pitch_rad);
  const Eigen::Vector2d through_water_mps =
      ahead_mps * UnitVector(heading_rad) + nav.sway_mps * UnitVector(heading_rad + kPi / 2);
  const Eigen::Vector2d current_mps = over_ground_mps.head<2>() - through_water_mps;
  const bool is_plausible = current_mps.cwiseAbs().maxCoeff() <= kFastest_mps;
  if (!is_plausible || !current_mps.allFinite()) return Eigen::Vector3d::Zero();
  return {current_mps.x(), current_mps.y(), 0};
}

bool IsPlausible(const Neighbour& neighbour) {
  return neighbour.position_m.cwiseAbs().maxCoeff() <= kFarthest_m &&
         neighbour.velocity_mps.cwiseAbs().maxCoeff() <= kFastest_mps &&
         neighbour.position_m.allFinite() && neighbour.velocity_mps.allFinite();
}

}  // namespace

SwarmView::SwarmView(const Mission& mission, const Vehicle& vehicle) : own_name_(vehicle.name) {
  std::map<std::string, std::set<std::string>> followers;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const Vehicle& each = mission.vehicles[i];
    ids_[each.name] = static_cast<int>(i);
    for (const Task& task : each.tasks) {
      const auto* track = std::get_if<TargetTrackTask>(&task.what);
      if (track != nullptr && each.name != own_name_) followers[track->target].insert(each.name);
    }
  }
  for (const auto& [target, names] : followers) {
    followers_[target].assign(names.begin(), names.end());
  }
  std::set<std::string> wanted;
  for (const Task& task : vehicle.tasks) {
    const auto* track = std::get_if<TargetTrackTask>(&task.what);
    if (track == nullptr) continue;
    wanted.insert(track->target);
    const std::vector<std::string>& group = GroupOf(*track);
    wanted.insert(group.begin(), group.end());
  }
  wanted.erase(own_name_);
  names_.assign(wanted.begin(), wanted.end());
}

const std::vector<std::string>& SwarmView::GroupOf(const TargetTrackTask& task) const {
  static const std::vector<std::string> kNone;
  if (!task.group.empty()) return task.group;
  const auto found = followers_.find(task.target);
  return found == followers_.end() ? kNone : found->second;
}

void SwarmView::Hear(const std::string& name, const nav_t& nav) {
  const Neighbour neighbour = NeighbourOf(ids_[name], nav);
  if (IsPlausible(neighbour)) heard_[name] = neighbour;
}

const Surroundings* SwarmView::Look(const Task* task, const nav_t& own) {
  const auto* track = task == nullptr ? nullptr : std::get_if<TargetTrackTask>(&task->what);
  if (track == nullptr) return nullptr;
  surroundings_ = {};
  surroundings_.own = NeighbourOf(ids_[own_name_], own);
  if (!IsPlausible(surroundings_.own)) return nullptr;
  if (const auto found = heard_.find(track->target); found != heard_.end()) {
    surroundings_.target = found->second;
  }
  group_.clear();
  for (const std::string& name : GroupOf(*track)) {
    const auto found = heard_.find(name);
    const bool is_other = name != own_name_ && name != track->target;
    if (is_other && found != heard_.end()) group_.push_back(found->second);
  }
  surroundings_.group = group_;
  surroundings_.current_mps = CurrentOf(own, surroundings_.own.velocity_mps);
  if (own.altitude_m >= 0) surroundings_.seabed_z_m = own.z_m + own.altitude_m;
  return &surroundings_;
}

}  // namespace shoal
