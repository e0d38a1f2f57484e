#include "lib/run/verdict/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "lib/base/time/seconds.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/model/coverage_area.h"
#include "lib/run/verdict/encounter_outcomes.h"
#include "lib/run/verdict/expectation_text.h"

namespace shoal {

namespace {

constexpr size_t kMaxFailuresShown = 5;
constexpr size_t kMaxNamesShown = 5;
/// Vehicles that travelled less have not moved: a helm that keeps station or is in PARK.
constexpr double kMoved_m = 1;
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

/// Returns "alpha", "alpha, bravo", or the first ones "and 12 more".
std::string Listed(const std::vector<std::string>& names) {
  const size_t num_shown = std::min(names.size(), kMaxNamesShown);
  std::string text = fmt::format("{}", fmt::join(std::span(names).first(num_shown), ", "));
  if (num_shown < names.size()) text += fmt::format(" and {} more", names.size() - num_shown);
  return text;
}

/// Judges by the share (at_least_pct, at_most_pct) that `count` has in all that was offered.
void JudgeShare(const auto& limits, int64_t count, int64_t offered, Outcome* outcome) {
  if (offered == 0) {
    outcome->passed = !limits.at_least_pct;
    outcome->numbers = "nothing was offered on these links";
    return;
  }
  // A share that is exactly the limit is within it, whatever binary fractions make of the limit.
  constexpr double kRounding_pct = 1e-9;
  const double share_pct = 100 * static_cast<double>(count) / static_cast<double>(offered);
  outcome->value = share_pct;
  outcome->numbers = fmt::format("{} of {} ({:.4g} %)", count, offered, share_pct);
  const double missing_pct = limits.at_least_pct.value_or(0) - share_pct;
  const double excess_pct = share_pct - limits.at_most_pct.value_or(100);
  if (missing_pct > kRounding_pct) {
    outcome->passed = false;
    outcome->numbers += fmt::format(", {} % too low", FormatExcess(missing_pct));
  }
  if (excess_pct > kRounding_pct) {
    outcome->passed = false;
    outcome->numbers += fmt::format(", {} % too high", FormatExcess(excess_pct));
  }
}

Outcome JudgeCoverage(const CoverageWatch& watch, double at_least_pct) {
  const double missing_pct = at_least_pct - watch.covered_pct();
  Outcome outcome = {.passed = missing_pct <= 0,
                     .strain = missing_pct,
                     .numbers = fmt::format("{:.2f} % of {:.0f} m2, in cells of {:.2g} m",
                                            watch.covered_pct(), watch.area_m2(), watch.cell_m()),
                     .value = watch.covered_pct()};
  if (missing_pct > 0) outcome.numbers += fmt::format(", {} % too low", FormatExcess(missing_pct));
  return outcome;
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

/// Returns an unknown sea where the mission has none, or where a log is judged without the files of
/// its grids.
Ocean KnownOceanOf(const Mission& mission) {
  Result<Ocean> ocean = OceanOf(mission);
  return ocean.ok() ? std::move(*ocean) : Ocean();
}

}  // namespace

Judge::Judge(const Mission& mission) : Judge(mission, KnownOceanOf(mission)) {}

Judge::Judge(const Mission& mission, Ocean ocean)
    : mission_(mission),
      current_grid_(std::move(ocean.current_grid)),
      floor_(std::move(ocean.floor)),
      floor_shallowest_m_(floor_ ? floor_->ShallowestDepth() : 0),
      was_off_grid_(mission.vehicles.size()),
      sightings_(mission.vehicles.size()),
      altitudes_m_(mission.vehicles.size(), -1),
      estimates_m_(mission.vehicles.size()),
      travelled_m_(mission.vehicles.size()),
      helms_(mission.vehicles.size()),
      tally_(NamesOf(mission)),
      swarm_counts_(NamesOf(mission)),
      has_left_park_(mission.vehicles.size()),
      positions_m_(mission.vehicles.size(), Eigen::Vector3d::Zero()),
      collision_watch_(LengthsOf(mission)),
      obstacle_watch_(LengthsOf(mission), PolygonsOfObstacles(mission)),
      grounding_watch_(mission.vehicles.size()),
      has_track_in_ground_(mission.vehicles.size()),
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
  if (current_grid_ && !current_grid_->IsInside(position_m.head<2>()))
    was_off_grid_[vehicle] = true;
  moved_now_.push_back(static_cast<uint32_t>(vehicle));
  return true;
}

void Judge::TakeEstimate(size_t vehicle, const Eigen::Vector2d& position_m) {
  if (position_m.allFinite()) estimates_m_[vehicle] = position_m;
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
    constexpr int64_t kMax = std::numeric_limits<int32_t>::max();
    swarm_counts_.Add(sender, mission_.vehicles[vehicle].name, outcome,
                      static_cast<int32_t>(std::clamp<int64_t>(more, 0, kMax)));
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

void Judge::WatchGroundings(double time_s) {
  if (!floor_) return;
  for (const uint32_t i : moved_now_) {
    const Vehicle& vehicle = mission_.vehicles[i];
    if (std::holds_alternative<BuoyParams>(vehicle.model)) continue;
    const Eigen::Vector3d& position_m = positions_m_[i];
    const double keel_m = position_m.z() + DraughtOf(vehicle);
    // Where the floor is deep enough everywhere, its depth here makes no difference.
    const bool is_safe = floor_shallowest_m_ - keel_m > GroundingWatch::kFreed_m;
    const double floor_m = is_safe ? floor_shallowest_m_ : floor_->DepthAt(position_m.head<2>());
    if (!grounding_watch_.Look(i, floor_m - keel_m)) continue;
    if (std::holds_alternative<TrackOptions>(vehicle.model)) {
      has_track_in_ground_[i] = true;
      continue;
    }
    ++num_groundings_;
    if (groundings_.size() == kMaxGroundings) continue;
    groundings_.push_back(
        {.vehicle = i, .position_m = position_m, .floor_m = floor_m, .time_s = time_s});
  }
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
  WatchGroundings(SecondsSinceStart(utime));
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
    } else if (const auto* error = std::get_if<NavigationErrorExpectation>(&what)) {
      const std::optional<Eigen::Vector2d>& estimate_m = estimates_m_[vehicle];
      if (time_s < error->from_s || !own.seen || !estimate_m) continue;
      each->extremes[i].Look((*estimate_m - own.position_m.head<2>()).norm(), time_s);
    } else if (std::holds_alternative<AltitudeExpectation>(what)) {
      if (own.seen && altitudes_m_[vehicle] >= 0) {
        each->extremes[i].Look(altitudes_m_[vehicle], time_s);
      }
    }
  }
}

std::vector<ExpectationVerdict> Judge::Verdicts() const {
  std::vector<ExpectationVerdict> verdicts;
  for (const Case& each : cases_) {
    Outcome outcome;
    if (const auto* what = std::get_if<SeparationExpectation>(&each.expectation->what)) {
      outcome = FindSeparation(*what);
    } else if (const auto* approach =
                   std::get_if<ClosestApproachExpectation>(&each.expectation->what)) {
      outcome = JudgeClosestApproach(mission_, *approach, encounters_[each.encounters]);
    } else if (const auto* score =
                   std::get_if<EncounterScoreExpectation>(&each.expectation->what)) {
      outcome = JudgeEncounterScore(mission_, *score, encounters_[each.encounters]);
    } else if (const auto* comms = std::get_if<CommsExpectation>(&each.expectation->what)) {
      outcome = FindComms(*comms);
    } else if (const auto* swarm = std::get_if<SwarmExpectation>(&each.expectation->what)) {
      const int from = PlaceInCounts(swarm->from);
      const int to = PlaceInCounts(swarm->to);
      outcome = {.passed = true, .strain = 0, .numbers = {}};
      JudgeShare(*swarm, swarm_counts_.Count(from, to, swarm->outcome),
                 swarm_counts_.CountOffered(from, to), &outcome);
    } else if (const auto* coverage = std::get_if<CoverageExpectation>(&each.expectation->what)) {
      outcome = JudgeCoverage(*each.coverage, coverage->at_least_pct);
    } else {
      outcome = Combine(each, FindForVehicles(each));
    }
    verdicts.push_back({.where = each.expectation->where,
                        .text = Describe(mission_, *each.expectation),
                        .passed = outcome.passed,
                        .numbers = outcome.numbers,
                        .value = outcome.value,
                        .unit = UnitOf(*each.expectation),
                        .margin = MarginOf(mission_, *each.expectation, outcome.value)});
  }
  return verdicts;
}

bool Judge::Passed() const {
  if (num_collisions_ > 0 && mission_.collisions == CollisionVerdict::kFail) return false;
  if (num_groundings_ > 0 && mission_.grounding == GroundingVerdict::kFail) return false;
  const std::vector<ExpectationVerdict> verdicts = Verdicts();
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const ExpectationVerdict& verdict) { return verdict.passed; });
}

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
  const auto warn_of = [&](const std::vector<bool>& those, std::string_view what) {
    std::vector<std::string> names;
    for (size_t i = 0; i < those.size(); ++i) {
      if (those[i]) names.push_back(mission_.vehicles[i].name);
    }
    if (!names.empty()) warnings.push_back(fmt::format("{}: {}", what, Listed(names)));
  };
  warn_of(was_off_grid_, "left the grid of the current, and had the water of its nearest edge");
  warn_of(has_track_in_ground_,
          "a recorded track leads over land, or into the floor, of the mission's map");
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
    if (tally_.fates(Kind::kReport).Count(FateCounts::kAll, place, "delivered") == 0) {
      names.push_back(vehicle.name);
    }
  }
  return names.empty() ? std::string() : Listed(names);
}

Outcome Judge::FindSeparation(const SeparationExpectation& separation) const {
  const Approach& closest = separation_.closest();
  if (closest.first < 0) return {.passed = false, .numbers = "no two vehicles were seen"};
  const double missing_m = separation.min_m - closest.range_m;
  std::string numbers = fmt::format("closest: {}-{} {:.1f} m at {:.1f} s",
                                    mission_.vehicles[static_cast<size_t>(closest.first)].name,
                                    mission_.vehicles[static_cast<size_t>(closest.second)].name,
                                    closest.range_m, SecondsSinceStart(closest.utime));
  if (missing_m > 0) numbers += fmt::format(", {} m too close", FormatExcess(missing_m));
  return {
      .passed = missing_m <= 0, .strain = missing_m, .numbers = numbers, .value = closest.range_m};
}

Outcome Judge::FindComms(const CommsExpectation& comms) const {
  const int from = PlaceInCounts(comms.from);
  const int to = PlaceInCounts(comms.to);
  const int64_t count = tally_.fates(comms.kind).Count(from, to, comms.cause);
  Outcome outcome = {.passed = true, .strain = 0, .numbers = std::to_string(count)};
  if (comms.at_least_pct || comms.at_most_pct) {
    JudgeShare(comms, count, tally_.fates(comms.kind).CountOffered(from, to), &outcome);
  } else {
    outcome.value = static_cast<double>(count);
  }
  if (comms.at_least && count < *comms.at_least) {
    outcome.passed = false;
    outcome.numbers += fmt::format(", {} too few", *comms.at_least - count);
  }
  if (comms.at_most && count > *comms.at_most) {
    outcome.passed = false;
    outcome.numbers += fmt::format(", {} too many", count - *comms.at_most);
  }
  return outcome;
}

Outcome Judge::FindHelm(const HelmExpectation& helm, size_t vehicle) const {
  const std::optional<HelmFacts>& facts = helms_[vehicle];
  if (!facts) {
    return {.passed = false, .strain = 0, .numbers = "no helm state was received", .value = 0};
  }
  const bool state_fits = helm.state.empty() || VehicleKey(helm.state) == VehicleKey(facts->state);
  const bool task_fits = helm.task.empty() || helm.task == facts->task;
  return {.passed = state_fits && task_fits,
          .strain = 0,
          .numbers = fmt::format("{} with {}", facts->state,
                                 facts->task.empty() ? "no task" : "task " + facts->task),
          .value = state_fits && task_fits ? 1 : 0};
}

Outcome Judge::FindLaps(const LapsExpectation& expected, const LapsWatch& watch) const {
  if (!watch.reached_s) {
    return {.passed = false,
            .strain = static_cast<double>(expected.at_least - watch.most),
            .numbers = fmt::format("{}, {} too few", watch.most, expected.at_least - watch.most),
            .value = static_cast<double>(watch.most)};
  }
  const double late_s = *watch.reached_s - LimitSeconds(mission_, expected.by_s);
  std::string numbers = fmt::format("{}, enough at {:.1f} s", watch.most, *watch.reached_s);
  if (late_s > 0) numbers += fmt::format(", {} s late", FormatExcess(late_s));
  return {.passed = late_s <= 0,
          .strain = *watch.reached_s,
          .numbers = numbers,
          .value = static_cast<double>(watch.most)};
}

namespace {

/// Judges the smallest and the largest that a quantity in metres was. Absent limits do not count.
Outcome JudgeExtremes(const ExtremeWatch& watch, std::optional<double> min_m,
                      std::optional<double> max_m, std::string_view quantity) {
  if (!watch.has_seen()) {
    return {.passed = false, .strain = 0, .numbers = fmt::format("no {} was seen", quantity)};
  }
  Outcome outcome = {
      .passed = true, .strain = -std::numeric_limits<double>::infinity(), .numbers = {}};
  const auto add = [&](std::string_view what, const Extreme& extreme, double excess_m) {
    if (!outcome.numbers.empty()) outcome.numbers += ", ";
    outcome.numbers += fmt::format("{} {:.2f} m at {:.1f} s", what, extreme.value, extreme.time_s);
    if (excess_m > 0) outcome.numbers += fmt::format(", {} m beyond", FormatExcess(excess_m));
    outcome.passed = outcome.passed && excess_m <= 0;
    if (excess_m <= outcome.strain) return;
    outcome.strain = excess_m;
    outcome.value = extreme.value;
  };
  if (min_m) add("least", watch.smallest(), *min_m - watch.smallest().value);
  if (max_m) add("most", watch.largest(), watch.largest().value - *max_m);
  return outcome;
}

}  // namespace

std::vector<Outcome> Judge::FindForVehicles(const Case& each) const {
  std::vector<Outcome> outcomes;
  for (size_t i = 0; i < each.vehicles.size(); ++i) {
    if (const auto* helm = std::get_if<HelmExpectation>(&each.expectation->what)) {
      outcomes.push_back(FindHelm(*helm, each.vehicles[i]));
    } else if (const auto* laps = std::get_if<LapsExpectation>(&each.expectation->what)) {
      outcomes.push_back(FindLaps(*laps, each.laps[i]));
    } else if (const auto* track = std::get_if<TrackExpectation>(&each.expectation->what)) {
      outcomes.push_back(JudgeExtremes(each.extremes[i], {}, track->max_m, "track"));
    } else if (const auto* distance = std::get_if<DistanceExpectation>(&each.expectation->what)) {
      outcomes.push_back(
          JudgeExtremes(each.extremes[i], distance->min_m, distance->max_m, "distance"));
    } else if (const auto* altitude = std::get_if<AltitudeExpectation>(&each.expectation->what)) {
      outcomes.push_back(JudgeExtremes(each.extremes[i], altitude->min_m, {}, "altitude"));
    } else if (const auto* error =
                   std::get_if<NavigationErrorExpectation>(&each.expectation->what)) {
      outcomes.push_back(JudgeExtremes(each.extremes[i], {}, error->max_m, "estimate"));
    } else {
      outcomes.push_back(each.arrivals[i].Find());
    }
  }
  return outcomes;
}

/// Returns the number of the vehicle that decides: of laps the fewest; else that of the worst
/// failure, where one without a number is worse than all others, or of the narrowest success.
std::optional<double> Judge::WorstValue(const Case& each, const std::vector<Outcome>& outcomes) {
  const bool by_value = std::holds_alternative<LapsExpectation>(each.expectation->what);
  const auto badness = [&](const Outcome& outcome) {
    const double strain = by_value ? -outcome.value.value_or(0) : outcome.strain;
    return std::tuple(!by_value && !outcome.passed, !outcome.value.has_value(), strain);
  };
  return std::max_element(
             outcomes.begin(), outcomes.end(),
             [&](const Outcome& a, const Outcome& b) { return badness(a) < badness(b); })
      ->value;
}

/// Makes one outcome of many: the failures, or where there are none the narrowest success.
Outcome Judge::Combine(const Case& each, const std::vector<Outcome>& outcomes) const {
  if (outcomes.empty()) return {.passed = false, .strain = 0, .numbers = "no such vehicle"};
  if (outcomes.size() == 1) return outcomes.front();
  const auto with_name = [&](size_t i) {
    return mission_.vehicles[each.vehicles[i]].name + ": " + outcomes[i].numbers;
  };
  size_t num_failed = 0;
  size_t narrowest = 0;
  std::string failures;
  for (size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].strain > outcomes[narrowest].strain) narrowest = i;
    if (outcomes[i].passed || ++num_failed > kMaxFailuresShown) continue;
    failures += (failures.empty() ? "" : "; ") + with_name(i);
  }
  if (num_failed == 0) {
    return {.passed = true,
            .strain = 0,
            .numbers = fmt::format("all {}; narrowest {}", outcomes.size(), with_name(narrowest)),
            .value = WorstValue(each, outcomes)};
  }
  if (num_failed > kMaxFailuresShown) {
    failures += fmt::format("; and {} more", num_failed - kMaxFailuresShown);
  }
  return {.passed = false,
          .strain = 0,
          .numbers = fmt::format("{} of {} failed: {}", num_failed, outcomes.size(), failures),
          .value = WorstValue(each, outcomes)};
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
  return Seconds(utime - mission_.start_utime);
}

}  // namespace shoal
