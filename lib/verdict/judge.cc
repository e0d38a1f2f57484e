#include "lib/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "lib/mission/coverage_area.h"
#include "lib/routing/vehicle_name.h"
#include "lib/verdict/expectation_text.h"

namespace shoal {

namespace {

/// A quarter of the Earth's circumference: positions farther away are invalid.
constexpr double kFarthest_m = 1e7;
/// A vehicle whose motion is older has no encounters.
constexpr double kOldestMotion_s = 5;

std::vector<std::string> NamesOf(const Mission& mission) {
  std::vector<std::string> names;
  for (const Vehicle& vehicle : mission.vehicles) names.push_back(vehicle.name);
  return names;
}

std::vector<Polygon> PolygonsOfObstacles(const Mission& mission) {
  std::vector<Polygon> polygons_m;
  for (const Obstacle& obstacle : mission.obstacles) polygons_m.push_back(obstacle.polygon_m);
  return polygons_m;
}

std::vector<double> LengthsOf(const Mission& mission) {
  std::vector<double> lengths_m;
  for (const Vehicle& vehicle : mission.vehicles) lengths_m.push_back(vehicle.length_m);
  return lengths_m;
}

/// Returns the name of the vehicle or vehicles that an expectation is put to, one by one; nothing
/// where it looks at all of them together.
std::string_view PutTo(const Expectation& expectation) {
  return std::visit(
      [](const auto& what) -> std::string_view {
        if constexpr (requires { what.vehicle; }) return what.vehicle;
        return {};
      },
      expectation.what);
}

/// Returns how an expectation's encounters begin and end; nullptr where it is not about any.
const EncounterOptions* EncountersOf(const Expectation& expectation) {
  return std::visit(
      [](const auto& what) -> const EncounterOptions* {
        if constexpr (requires { what.encounter; }) return &what.encounter;
        return nullptr;
      },
      expectation.what);
}

}  // namespace

Judge::Judge(const Mission& mission)
    : mission_(mission),
      sightings_(mission.vehicles.size()),
      altitudes_m_(mission.vehicles.size(), -1),
      travelled_m_(mission.vehicles.size()),
      helms_(mission.vehicles.size()),
      fates_(kNumKinds, FateCounts(NamesOf(mission))),
      swarm_counts_(NamesOf(mission)),
      has_left_park_(mission.vehicles.size()),
      positions_m_(mission.vehicles.size(), Eigen::Vector3d::Zero()),
      collision_watch_(LengthsOf(mission)),
      obstacle_watch_(LengthsOf(mission), PolygonsOfObstacles(mission)),
      motions_(mission.vehicles.size()),
      motion_s_(mission.vehicles.size(), -1),
      has_new_motion_(mission.vehicles.size()) {
  for (const Expectation& expectation : mission.expectations) {
    Case& each = cases_.emplace_back();
    each.expectation = &expectation;
    each.vehicles = VehiclesNamed(PutTo(expectation));
    if (const auto* distance = std::get_if<DistanceExpectation>(&expectation.what);
        distance != nullptr && VehicleKey(distance->to) != "all") {
      std::erase(each.vehicles,
                 VehiclesNamed(distance->to).at(0));  // No vehicle is far from itself.
    }
    if (const auto* arrival = std::get_if<ArrivalExpectation>(&expectation.what)) {
      for (const size_t vehicle : each.vehicles) {
        each.arrivals.emplace_back(ArrivalGoal{
            .point_m = arrival->point_m.value_or(mission.vehicles[vehicle].return_task.point_m),
            .within_m = arrival->within_m,
            .by_s = LimitSeconds(mission, arrival->by_s),
            .stays = arrival->stays});
      }
    }
    if (const auto* coverage = std::get_if<CoverageExpectation>(&expectation.what)) {
      each.vehicles = VehiclesOf(mission, *coverage);
      each.coverage.emplace(PolygonsOf(mission, *coverage), coverage->sensor_width_m,
                            mission.vehicles.size());
    }
    if (std::holds_alternative<LapsExpectation>(expectation.what)) {
      each.laps.resize(each.vehicles.size());
    }
    if (std::holds_alternative<SeparationExpectation>(expectation.what)) watches_separation_ = true;
    each.extremes.resize(each.vehicles.size());
    if (const EncounterOptions* options = EncountersOf(expectation)) {
      while (each.encounters < encounters_.size() &&
             encounters_[each.encounters].options() != *options) {
        ++each.encounters;
      }
      if (each.encounters == encounters_.size()) encounters_.emplace_back(*options);
    }
  }
}

bool Judge::TakeNav(size_t vehicle, const Eigen::Vector3d& position_m, double altitude_m) {
  if (!position_m.allFinite() || position_m.cwiseAbs().maxCoeff() > kFarthest_m) return false;
  altitudes_m_[vehicle] = altitude_m;
  Sighting& sighting = sightings_[vehicle];
  if (sighting.seen) travelled_m_[vehicle] += (position_m - sighting.position_m).norm();
  sighting = {.seen = true, .position_m = position_m};
  positions_m_[vehicle] = position_m;
  moved_now_.push_back(static_cast<uint32_t>(vehicle));
  return true;
}

bool Judge::TakeMotion(size_t vehicle, double heading_deg, double speed_mps) {
  if (!std::isfinite(heading_deg) || !std::isfinite(speed_mps)) return false;
  VesselMotion& motion = motions_[vehicle].motion;
  motion.position_m = sightings_[vehicle].position_m.head<2>();
  motion.heading_deg = heading_deg;
  motion.speed_mps = std::max(0.0, speed_mps);
  motions_[vehicle].depth_m = sightings_[vehicle].position_m.z();
  motions_[vehicle].length_m = mission_.vehicles[vehicle].length_m;
  has_new_motion_[vehicle] = sightings_[vehicle].seen;
  return true;
}

void Judge::TakeHelm(size_t vehicle, const HelmFacts& helm, int64_t utime) {
  helms_[vehicle] = helm;
  if (helm.state != "PARK") has_left_park_[vehicle] = true;
  for (Case& each : cases_) {
    const auto* expected = std::get_if<LapsExpectation>(&each.expectation->what);
    if (expected == nullptr || expected->task != helm.task) continue;
    for (size_t i = 0; i < each.vehicles.size(); ++i) {
      if (each.vehicles[i] != vehicle) continue;
      LapsWatch& watch = each.laps[i];
      watch.most = std::max(watch.most, helm.laps_done);
      if (watch.most >= expected->at_least && !watch.reached_s) {
        watch.reached_s = SecondsSinceStart(utime);
      }
    }
  }
}

void Judge::TakeSwarm(size_t vehicle, const std::string& sender, const SwarmShares& shares) {
  SwarmShares& last = swarm_last_[{vehicle, sender}];
  const auto add = [&](std::string_view outcome, int64_t SwarmShares::*member) {
    // Counters that went back are those of a process that was started again.
    const int64_t more =
        shares.*member >= last.*member ? shares.*member - last.*member : shares.*member;
    constexpr int64_t kMost = std::numeric_limits<int32_t>::max();
    swarm_counts_.Add(sender, mission_.vehicles[vehicle].name, outcome,
                      static_cast<int32_t>(std::clamp<int64_t>(more, 0, kMost)));
  };
  add("clean", &SwarmShares::clean);
  add("recovered", &SwarmShares::recovered);
  add("rejected", &SwarmShares::rejected);
  last = shares;
}

void Judge::WatchCollisions(double time_s) {
  std::sort(moved_now_.begin(), moved_now_.end());
  moved_now_.erase(std::unique(moved_now_.begin(), moved_now_.end()), moved_now_.end());
  for (const Collision& collision : collision_watch_.Look(moved_now_, positions_m_)) {
    ++num_collisions_;
    if (collisions_.size() < kMaxCollisions) collisions_.push_back({collision, time_s});
  }
  for (const ObstacleHit& hit : obstacle_watch_.Look(moved_now_, positions_m_)) {
    ++num_collisions_;
    if (collisions_.size() >= kMaxCollisions) continue;
    collisions_.push_back({.collision = {.first = hit.vehicle,
                                         .second = hit.obstacle,
                                         .range_m = hit.distance_m,
                                         .allowed_m = hit.allowed_m},
                           .time_s = time_s,
                           .is_obstacle = true});
  }
  moved_now_.clear();
}

void Judge::WatchEncounters(double time_s) {
  for (size_t i = 0; i < motions_.size(); ++i) {
    if (has_new_motion_[i]) motion_s_[i] = time_s;
    has_new_motion_[i] = false;
    motions_[i].is_seen = motion_s_[i] >= 0 && time_s - motion_s_[i] <= kOldestMotion_s;
  }
  for (EncounterWatch& watch : encounters_) watch.Look(time_s, motions_);
}

void Judge::EndStep(int64_t utime) {
  WatchCollisions(SecondsSinceStart(utime));
  if (!encounters_.empty()) WatchEncounters(SecondsSinceStart(utime));
  if (watches_separation_) separation_.Look(sightings_, utime);
  for (Case& each : cases_) {
    WatchExtremes(&each, SecondsSinceStart(utime));
    if (each.coverage) {
      for (const size_t vehicle : each.vehicles) {
        const Sighting& sighting = sightings_[vehicle];
        if (!sighting.seen) continue;
        each.coverage->Look(vehicle, sighting.position_m.head<2>(), SecondsSinceStart(utime));
      }
    }
    for (size_t i = 0; i < each.arrivals.size(); ++i) {
      const Sighting& sighting = sightings_[each.vehicles[i]];
      if (!sighting.seen) continue;
      each.arrivals[i].Look(sighting.position_m.head<2>(), SecondsSinceStart(utime));
    }
  }
}

void Judge::WatchExtremes(Case* each, double time_s) const {
  const auto& what = each->expectation->what;
  for (size_t i = 0; i < each->vehicles.size(); ++i) {
    const size_t vehicle = each->vehicles[i];
    const Sighting& own = sightings_[vehicle];
    if (const auto* track = std::get_if<TrackExpectation>(&what)) {
      const std::optional<HelmFacts>& helm = helms_[vehicle];
      if (time_s < track->from_s || !helm || !helm->cross_track_error_m) continue;
      each->extremes[i].Look(std::abs(*helm->cross_track_error_m), time_s);
    } else if (const auto* distance = std::get_if<DistanceExpectation>(&what)) {
      if (time_s < distance->from_s || !own.seen) continue;
      for (const size_t other : VehiclesNamed(distance->to)) {
        if (other == vehicle || !sightings_[other].seen) continue;
        each->extremes[i].Look((sightings_[other].position_m - own.position_m).norm(), time_s);
      }
    } else if (std::holds_alternative<AltitudeExpectation>(what)) {
      if (own.seen && altitudes_m_[vehicle] >= 0) {
        each->extremes[i].Look(altitudes_m_[vehicle], time_s);
      }
    }
  }
}

std::vector<size_t> Judge::VehiclesNamed(std::string_view name) const {
  const std::string key = VehicleKey(name);
  std::vector<size_t> vehicles;
  for (size_t i = 0; i < mission_.vehicles.size(); ++i) {
    if (key == "all" || key == VehicleKey(mission_.vehicles[i].name)) vehicles.push_back(i);
  }
  return vehicles;
}

/// Returns the place past the mission's vehicles, that of all others, for names it does not have.
int Judge::PlaceInCounts(std::string_view name) const {
  if (VehicleKey(name) == "all") return FateCounts::kAll;
  const std::vector<size_t> named = VehiclesNamed(name);
  return static_cast<int>(named.empty() ? mission_.vehicles.size() : named.front());
}

double Judge::SecondsSinceStart(int64_t utime) const {
  return static_cast<double>(utime - mission_.start_utime) / 1e6;
}

}  // namespace shoal
