#include "apps/helm/swarm_view.h"

#include <algorithm>
#include <set>

#include "apps/helm/sonar_echoes.h"
#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/vehicle/guidance/motion_prediction.h"

namespace shoal {

namespace {

/// The laws' own bounds on their inputs (lib/vehicle/guidance/plausible.h).
constexpr double kFarthest_m = 1e6;
constexpr double kFastest_mps = 1000;
/// A follower that has not steered for the target for longer than this starts again.
constexpr double kLongestPause_s = 2;

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

/// Returns the seconds since a time that a message has. That may be any number: the difference of
/// the integers could overflow, which SecondsBetween() does not allow.
double SecondsSince(int64_t earlier_utime, int64_t utime) {
  return (static_cast<double>(utime) - static_cast<double>(earlier_utime)) / 1e6;
}

/// Returns the velocity of the current: the velocity over ground less the velocity relative to the
/// water, which NAV has in the body frame. Only horizontal. Roll is left out: it changes the result
/// very little.
Eigen::Vector3d CurrentOf(const nav_t& nav, const Eigen::Vector3d& over_ground_mps) {
  const double pitch_rad = DegToRad(nav.pitch_deg);
  const double heading_rad = DegToRad(nav.heading_deg);
  const double ahead_mps = nav.surge_mps * Cos(pitch_rad) + nav.heave_mps * Sin(pitch_rad);
  const Eigen::Vector2d through_water_mps =
      ahead_mps * UnitVector(heading_rad) + nav.sway_mps * UnitVector(heading_rad + kPi / 2);
  const Eigen::Vector2d current_mps = over_ground_mps.head<2>() - through_water_mps;
  const bool is_plausible = current_mps.cwiseAbs().maxCoeff() <= kFastest_mps;
  if (!is_plausible || !current_mps.allFinite()) return Eigen::Vector3d::Zero();
  return {current_mps.x(), current_mps.y(), 0};
}

/// Returns where a contact is now, by its last report.
Motion Predicted(const swarm_contact_t& contact, int64_t utime) {
  const double elapsed_s = std::max(0.0, SecondsSince(contact.report_utime, utime));
  if (!contact.has_next) return PredictMember(MotionOf(contact), elapsed_s);
  return PredictLeader({.now = MotionOf(contact), .next = NextOf(contact)}, elapsed_s, {});
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

double SilentAfter_s(const Mission& mission, const Vehicle& vehicle) {
  const SwarmOptions* swarm = mission.SwarmOf(vehicle);
  return swarm == nullptr ? SwarmOptions().silent_after_s : swarm->silent_after_s;
}

SwarmView::SwarmView(const Mission& mission, const Vehicle& vehicle)
    : own_(mission.vehicles.size()), silent_after_s_(SilentAfter_s(mission, vehicle)) {
  const bool looks = std::any_of(vehicle.tasks.begin(), vehicle.tasks.end(),
                                 [](const Task& task) { return InterestOf(task).has_value(); });
  if (!looks) return;  // A thousand that go by none need no thousand tables of a thousand.
  neighbours_.resize(mission.vehicles.size() + 1);
  contacts_.resize(mission.vehicles.size() + 1);
  for (size_t i = 0; i < mission.vehicles.size(); ++i) places_[mission.vehicles[i].name] = i;
  // A vehicle that is not in its mission, as in tests, comes behind the others.
  own_ = places_.emplace(vehicle.name, mission.vehicles.size()).first->second;
  for (const auto& [name, place] : places_) {
    if (place == own_) continue;
    if (FactsOfModel(mission.vehicles[place].model).is_underwater) divers_.push_back(place);
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
    const std::optional<Interest> interest = InterestOf(task);
    if (!interest || interest->swarm == SwarmKnowledge::kAcoustic) continue;
    if (interest->target != nullptr) wanted.insert(*interest->target);
    for (const Place place : MembersOf(*interest)) wanted.insert(mission.vehicles.at(place).name);
  }
  wanted.erase(vehicle.name);
  names_.assign(wanted.begin(), wanted.end());
  for (const std::string& name : names_) places_of_names_.push_back(places_.at(name));
}

std::optional<SwarmView::Place> SwarmView::PlaceOf(const std::string& name) const {
  const auto found = places_.find(name);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<SwarmView::Interest> SwarmView::InterestOf(const Task& task) {
  if (const auto* track = std::get_if<TargetTrackTask>(&task.what)) {
    return Interest{.target = &track->target,
                    .group = &track->group,
                    .swarm = track->swarm,
                    .smoothing_mps = track->smoothing_mps,
                    .cascade = std::get_if<VelocityCascade>(&track->track.law)};
  }
  const auto* path = std::get_if<PathFollowTask>(&task.what);
  if (path == nullptr || path->cascade.layers.empty()) return std::nullopt;
  const bool knows_others =
      std::any_of(path->cascade.layers.begin(), path->cascade.layers.end(),
                  [](const VelocityLayer& layer) { return GroupOf(layer) != nullptr; });
  return Interest{.group = knows_others ? &path->group : nullptr,
                  .swarm = path->swarm,
                  .cascade = &path->cascade};
}

std::vector<SwarmView::Place> SwarmView::MembersOf(const Interest& interest) const {
  std::vector<Place> group;
  if (interest.group == nullptr) return group;
  if (interest.group->empty() && interest.target == nullptr) return divers_;
  if (interest.group->empty()) {
    const std::optional<Place> target = PlaceOf(*interest.target);
    const auto found = target ? followers_.find(*target) : followers_.end();
    if (found != followers_.end()) group = found->second;
  }
  for (const std::string& name : *interest.group) {
    if (const std::optional<Place> place = PlaceOf(name); place && *place != own_) {
      group.push_back(*place);
    }
  }
  return group;
}

const SwarmView::Cast& SwarmView::CastOf(const Interest& interest) {
  static const std::string kNone;
  static const std::vector<std::string> kNoNames;
  const std::string& target = interest.target == nullptr ? kNone : *interest.target;
  const bool has_group = interest.group != nullptr;
  const std::vector<std::string>& group = has_group ? *interest.group : kNoNames;
  if (cast_ && cast_->has_group == has_group && cast_->target == target && cast_->group == group) {
    return *cast_;
  }
  cast_ = {.has_group = has_group,
           .target = target,
           .group = group,
           .target_place = interest.target == nullptr ? std::nullopt : PlaceOf(target),
           .group_places = MembersOf(interest)};
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

std::optional<Neighbour> SwarmView::Find(SwarmKnowledge swarm, Place place, int64_t utime) const {
  if (swarm == SwarmKnowledge::kDirect) return neighbours_[place];
  const std::optional<swarm_contact_t>& contact = contacts_[place];
  if (!contact || !contact->is_known) return std::nullopt;
  Neighbour neighbour = NeighbourOf(static_cast<int>(place), Predicted(*contact, utime));
  neighbour.is_silent = IsSilent(*contact, utime);
  return IsPlausible(neighbour) ? std::optional(neighbour) : std::nullopt;
}

void SwarmView::Smooth(double rate_mps, Place place, int64_t utime, Neighbour* target) {
  const swarm_contact_t& contact = *contacts_[place];
  const double since_s = smoothed_ ? SecondsBetween(smoothed_->utime, utime) : -1;
  const bool goes_on =
      smoothed_ && smoothed_->place == place && since_s >= 0 && since_s <= kLongestPause_s;
  if (rate_mps <= 0) {
    smoothed_.reset();
    return;
  }
  if (!goes_on) {
    smoothed_ = {.place = place, .utime = utime, .contact = contact, .ahead_m = {0, 0, 0}};
    return;
  }
  Eigen::Vector3d& ahead_m = smoothed_->ahead_m;
  const double left_m = std::max(0.0, ahead_m.norm() - rate_mps * since_s);
  ahead_m = left_m > 0 ? Eigen::Vector3d(left_m * ahead_m.normalized()) : Eigen::Vector3d::Zero();
  smoothed_->utime = utime;
  if (smoothed_->contact.heard_utime != contact.heard_utime ||
      smoothed_->contact.report_utime != contact.report_utime) {
    ahead_m += Predicted(smoothed_->contact, utime).position_m - target->position_m;
    smoothed_->contact = contact;
  }
  target->position_m += ahead_m;
}

bool SwarmView::IsSilent(const swarm_contact_t& contact, int64_t utime) const {
  return SecondsSince(contact.heard_utime, utime) > silent_after_s_;
}

void SwarmView::OnSonar(const sonar_t& ping) { ping_ = ping; }

void SwarmView::LookAhead(const VelocityCascade* cascade, const nav_t& own) {
  double memory_s = 0;
  for (size_t i = 0; cascade != nullptr && i < cascade->layers.size(); ++i) {
    const SurvivalSonarLayer* sonar = SonarOf(cascade->layers[i]);
    if (sonar != nullptr) memory_s = std::max(memory_s, sonar->memory_s);
  }
  echoes_ = EchoesOf(ping_, own);
  if (memory_s <= 0) return;
  const double time_s = Seconds(own.utime);
  const Eigen::Vector3d& position_m = surroundings_.own.position_m;
  if (remembered_utime_ != ping_.utime) memory_.Take(position_m, echoes_, time_s);
  remembered_utime_ = ping_.utime;
  const std::span<const SonarEcho> known = memory_.Recall(position_m, time_s, memory_s);
  echoes_.insert(echoes_.end(), known.begin(), known.end());
}

const Surroundings* SwarmView::Look(const Task* task, const nav_t& own) {
  const std::optional<Interest> interest = task == nullptr ? std::nullopt : InterestOf(*task);
  if (!interest) return nullptr;
  surroundings_ = {};
  surroundings_.own = NeighbourOf(static_cast<int>(own_), own);
  if (!IsPlausible(surroundings_.own)) return nullptr;
  const Cast& cast = CastOf(*interest);
  const std::optional<Place> target = cast.target_place;
  if (target) {
    surroundings_.target = Find(interest->swarm, *target, own.utime);
    if (surroundings_.target && interest->swarm == SwarmKnowledge::kAcoustic) {
      Smooth(interest->smoothing_mps, *target, own.utime, &*surroundings_.target);
    }
    surroundings_.target_is_silent = interest->swarm == SwarmKnowledge::kAcoustic &&
                                     contacts_[*target] && IsSilent(*contacts_[*target], own.utime);
  }
  group_.clear();
  for (const Place place : cast.group_places) {
    if (const auto neighbour = Find(interest->swarm, place, own.utime)) {
      group_.push_back(*neighbour);
    }
  }
  surroundings_.group = group_;
  LookAhead(interest->cascade, own);
  surroundings_.sonar = echoes_;
  surroundings_.current_mps = CurrentOf(own, surroundings_.own.velocity_mps);
  if (own.altitude_m >= 0) surroundings_.seabed_z_m = own.z_m + own.altitude_m;
  return &surroundings_;
}

}  // namespace shoal
