#include "apps/helm/swarm_view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "apps/helm/sonar_echoes.h"
#include "lib/geometry/angles.h"
#include "lib/guidance/motion_prediction.h"

namespace shoal {

namespace {

/// The laws' own bounds on their inputs (lib/guidance/plausible.h).
constexpr double kFarthest_m = 1e6;
constexpr double kFastest_mps = 1000;

Neighbour NeighbourOf(int id, const nav_t& nav) {
  const Eigen::Vector2d over_ground_mps =
      nav.speed_over_ground_mps * UnitVector(DegToRad(nav.course_over_ground_deg));
  return {.id = id,
          .position_m = {nav.x_m, nav.y_m, nav.z_m},
          .velocity_mps = {over_ground_mps.x(), over_ground_mps.y(), nav.descent_mps}};
}

Neighbour NeighbourOf(int id, const Motion& motion) {
  return {.id = id, .position_m = motion.position_m, .velocity_mps = motion.velocity_mps};
}

Motion MotionOf(const swarm_contact_t& contact) {
  return {.position_m = {contact.x_m, contact.y_m, contact.z_m},
          .velocity_mps = {contact.x_mps, contact.y_mps, contact.z_mps}};
}

Motion NextOf(const swarm_contact_t& contact) {
  return {.position_m = {contact.next_x_m, contact.next_y_m, contact.next_z_m},
          .velocity_mps = {contact.next_x_mps, contact.next_y_mps, contact.next_z_mps}};
}

/// Returns the seconds from one time to another, also where the difference overflows.
double SecondsBetween(int64_t earlier_utime, int64_t later_utime) {
  return (static_cast<double>(later_utime) - static_cast<double>(earlier_utime)) / 1e6;
}

/// Returns the velocity of the current: the velocity over ground less the velocity relative to the
/// water, which NAV has in the body frame. Horizontal; roll turns only what is small.
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

NavNeighbour::NavNeighbour(const nav_t& nav) : neighbour(NeighbourOf(-1, nav)) {
  is_plausible = IsPlausible(neighbour);
}

SwarmView::SwarmView(const Mission& mission, const Vehicle& vehicle)
    : own_(mission.vehicles.size()), silent_after_s_(mission.swarm.silent_after_s) {
  const bool follows = std::any_of(
      vehicle.tasks.begin(), vehicle.tasks.end(),
      [](const Task& task) { return std::holds_alternative<TargetTrackTask>(task.what); });
  if (!follows) return;  // A thousand that follow none need no thousand tables of a thousand.
  neighbours_.resize(mission.vehicles.size() + 1);
  contacts_.resize(mission.vehicles.size() + 1);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) places_[mission.vehicles[i].name] = i;
  // A vehicle that is not in its mission, as in tests, comes behind the others.
  own_ = places_.emplace(vehicle.name, mission.vehicles.size()).first->second;
  for (const auto& [name, place] : places_) {
    if (place == own_) continue;
    for (const Task& task : mission.vehicles[place].tasks) {
      const auto* track = std::get_if<TargetTrackTask>(&task.what);
      const std::optional<Place> target = track == nullptr ? std::nullopt : PlaceOf(track->target);
      if (!target) continue;
      std::vector<Place>& followers = followers_[*target];
      if (followers.empty() || followers.back() != place) followers.push_back(place);
    }
  }
  std::set<std::string> wanted;
  for (const Task& task : vehicle.tasks) {
    const auto* track = std::get_if<TargetTrackTask>(&task.what);
    if (track == nullptr || track->swarm == SwarmKnowledge::kAcoustic) continue;
    wanted.insert(track->target);
    for (const Place place : GroupOf(*track)) wanted.insert(mission.vehicles.at(place).name);
  }
  wanted.erase(vehicle.name);
  names_.assign(wanted.begin(), wanted.end());
  for (const std::string& name : names_) places_of_names_.push_back(places_.at(name));
}

std::optional<SwarmView::Place> SwarmView::PlaceOf(const std::string& name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<SwarmView::Place> SwarmView::GroupOf(const TargetTrackTask& task) const {
  std::vector<Place> group;
  if (task.group.empty()) {
    const std::optional<Place> target = PlaceOf(task.target);
    const auto found = target ? followers_.find(*target) : followers_.end();
    if (found != followers_.end()) group = found->second;
  }
  for (const std::string& name : task.group) {
    if (const std::optional<Place> place = PlaceOf(name); place && *place != own_) {
      group.push_back(*place);
    }
  }
  return group;
}

const SwarmView::Cast& SwarmView::CastOf(const TargetTrackTask& task) {
  if (cast_ && cast_->target == task.target && cast_->group == task.group) return *cast_;
  cast_ = {.target = task.target,
           .group = task.group,
           .target_place = PlaceOf(task.target),
           .group_places = GroupOf(task)};
  if (cast_->target_place) std::erase(cast_->group_places, *cast_->target_place);
  return *cast_;
}

void SwarmView::OnNav(size_t place_in_names, const NavNeighbour& nav) {
  if (!nav.is_plausible) return;
  const Place place = places_of_names_[place_in_names];
  neighbours_[place] = nav.neighbour;
  neighbours_[place]->id = static_cast<int>(place);
}

void SwarmView::OnSwarm(const swarm_t& swarm) {
  for (const swarm_contact_t& contact : swarm.contacts) {
    const bool is_sound = IsPlausible(NeighbourOf(0, MotionOf(contact))) &&
                          IsPlausible(NeighbourOf(0, NextOf(contact)));
    if (const auto place = PlaceOf(contact.name); place && is_sound) contacts_[*place] = contact;
  }
}

std::optional<Neighbour> SwarmView::Find(const TargetTrackTask& task, Place place,
                                         int64_t utime) const {
  if (task.swarm == SwarmKnowledge::kDirect) return neighbours_[place];
  const std::optional<swarm_contact_t>& contact = contacts_[place];
  if (!contact || !contact->is_known) return std::nullopt;
  const double elapsed_s = std::max(0.0, SecondsBetween(contact->report_utime, utime));
  const Motion now =
      contact->has_next
          ? PredictLeader({.now = MotionOf(*contact), .next = NextOf(*contact)}, elapsed_s, {})
          : PredictMember(MotionOf(*contact), elapsed_s);
  Neighbour neighbour = NeighbourOf(static_cast<int>(place), now);
  neighbour.is_silent = IsSilent(*contact, utime);
  return IsPlausible(neighbour) ? std::optional(neighbour) : std::nullopt;
}

bool SwarmView::IsSilent(const swarm_contact_t& contact, int64_t utime) const {
  return SecondsBetween(contact.heard_utime, utime) > silent_after_s_;
}

void SwarmView::OnSonar(const sonar_t& ping) { ping_ = ping; }

const Surroundings* SwarmView::Look(const Task* task, const nav_t& own) {
  const auto* track = task == nullptr ? nullptr : std::get_if<TargetTrackTask>(&task->what);
  if (track == nullptr) return nullptr;
  surroundings_ = {};
  surroundings_.own = NeighbourOf(static_cast<int>(own_), own);
  if (!IsPlausible(surroundings_.own)) return nullptr;
  const Cast& cast = CastOf(*track);
  const std::optional<Place> target = cast.target_place;
  if (target) {
    surroundings_.target = Find(*track, *target, own.utime);
    surroundings_.target_is_silent = track->swarm == SwarmKnowledge::kAcoustic &&
                                     contacts_[*target] && IsSilent(*contacts_[*target], own.utime);
  }
  group_.clear();
  for (const Place place : cast.group_places) {
    if (const auto neighbour = Find(*track, place, own.utime)) group_.push_back(*neighbour);
  }
  surroundings_.group = group_;
  echoes_ = EchoesOf(ping_, own);
  surroundings_.sonar = echoes_;
  surroundings_.current_mps = CurrentOf(own, surroundings_.own.velocity_mps);
  if (own.altitude_m >= 0) surroundings_.seabed_z_m = own.z_m + own.altitude_m;
  return &surroundings_;
}

}  // namespace shoal
