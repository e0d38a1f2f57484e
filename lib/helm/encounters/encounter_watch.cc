#include "lib/helm/encounters/encounter_watch.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lib/base/arithmetic/elementary.h"
#include "lib/base/geometry/angles.h"

namespace shoal {

namespace {

constexpr double kAlteration_deg = 5;
constexpr double kAlterationShare = 0.1;
constexpr double kExtremisAction_deg = 10;
/// A turn is over when the vessel has turned no faster than this for this long.
constexpr double kSteady_degps = 1;
constexpr double kSteady_s = 2;
/// A turn that begins later than this before the closest approach changes that no more.
constexpr double kPassing_s = 3;
constexpr double kExtremisActionShare = 0.2;
/// In extremis begins at this share of the preferred distance.
constexpr double kExtremisShare = 1.5;
/// Vessels that moved faster than this between two looks were put elsewhere (`sim reset`).
constexpr double kFastest_mps = 100;

bool KeepsClear(EncounterRole role) {
  return role == EncounterRole::kGiveWay || role == EncounterRole::kOvertaking ||
         role == EncounterRole::kHeadOn;
}

bool StandsOn(EncounterRole role) {
  return role == EncounterRole::kStandOn || role == EncounterRole::kOvertaken;
}

/// They close, and would pass closer than `risk_m` in some time.
bool IsRisk(const RelativeGeometry& geometry, double risk_m) {
  return geometry.range_rate_mps < 0 && geometry.time_to_cpa_s >= kPassing_s &&
         geometry.cpa_m < risk_m;
}

/// Replaces `largest` by `value` where that is farther from 0.
void KeepLargest(double value, double* largest) {
  if (std::abs(value) > std::abs(*largest)) *largest = value;
}

double BearingFrom(const Eigen::Vector2d& offset_m, double heading_deg) {
  return Wrap360(RadToDeg(HeadingOf(offset_m)) - heading_deg);
}

}  // namespace

void EncounterWatch::Look(double time_s, std::span<const VesselSample> vessels) {
  if (has_looked_ && !(time_s > last_s_)) return;
  FindDuties(vessels.size());
  for (auto it = open_.begin(); it != open_.end();) {
    if (Update(time_s, vessels, &it->second)) {
      ++it;
      continue;
    }
    it->second.encounter.is_over = true;
    Keep(it->second.encounter);
    it = open_.erase(it);
  }
  FindBegins(time_s, vessels);
  last_s_ = time_s;
  has_looked_ = true;
}

std::vector<Encounter> EncounterWatch::Encounters() const {
  std::vector<Encounter> all = ended_;
  for (const auto& [pair, open] : open_) all.push_back(open.encounter);
  std::stable_sort(all.begin(), all.end(), [](const Encounter& a, const Encounter& b) {
    return std::tuple(a.begin_s, a.sides[0].vessel, a.sides[1].vessel) <
           std::tuple(b.begin_s, b.sides[0].vessel, b.sides[1].vessel);
  });
  return all;
}

void EncounterWatch::FindDuties(size_t num_vessels) {
  duties_.assign(num_vessels, {});
  for (const auto& [pair, open] : open_) {
    for (size_t i = 0; i < 2; ++i) {
      const EncounterSide& side = open.encounter.sides[i];
      if (side.vessel >= num_vessels) continue;
      Duties& duties = duties_[side.vessel];
      if (KeepsClear(side.role)) duties.keeps_clear = true;
      if (open.sides[i].is_in_extremis) ++duties.num_in_extremis;
    }
  }
}

/// Returns false where the encounter is over.
bool EncounterWatch::Update(double time_s, std::span<const VesselSample> vessels,
                            Open* open) const {
  Encounter& encounter = open->encounter;
  const size_t places[2] = {encounter.sides[0].vessel, encounter.sides[1].vessel};
  for (const size_t place : places) {
    if (place >= vessels.size() || !vessels[place].is_seen) return false;
  }
  const VesselSample& first = vessels[places[0]];
  const VesselSample& second = vessels[places[1]];
  const Eigen::Vector2d offset_m = second.motion.position_m - first.motion.position_m;
  const Eigen::Vector2d moved_m = offset_m - open->offset_m;
  const double dt_s = time_s - last_s_;
  if (moved_m.norm() > 2 * kFastest_mps * dt_s) return false;

  const RelativeGeometry geometry[2] = {GeometryOf(first.motion, second.motion),
                                        GeometryOf(second.motion, first.motion)};
  for (size_t i = 0; i < 2; ++i) {
    const Duties& duties = duties_[places[i]];
    const bool in_extremis_of_another =
        duties.num_in_extremis > (open->sides[i].is_in_extremis ? 1 : 0);
    UpdateSide(time_s, vessels[places[i]], geometry[i],
               duties.keeps_clear || in_extremis_of_another,
               KeepsClear(encounter.sides[1 - i].role), &encounter.sides[i], &open->sides[i]);
  }

  // Straight from the last look to this one.
  const double moved2 = moved_m.squaredNorm();
  const double share =
      moved2 > 0 ? std::clamp(-open->offset_m.dot(moved_m) / moved2, 0.0, 1.0) : 1.0;
  const Eigen::Vector2d closest_offset_m = open->offset_m + moved_m * share;
  const double closest_m = closest_offset_m.norm();
  if (Hypot(closest_m, first.depth_m - second.depth_m) < encounter.touch_m) {
    encounter.has_touched = true;
  }
  if (closest_m < encounter.closest_m) {
    encounter.closest_m = closest_m;
    encounter.closest_s = last_s_ + share * dt_s;
    for (size_t i = 0; i < 2; ++i) {
      EncounterSide& side = encounter.sides[i];
      const Eigen::Vector2d seen_m = i == 0 ? closest_offset_m : Eigen::Vector2d(-closest_offset_m);
      side.beta_deg = BearingFrom(seen_m, vessels[places[i]].motion.heading_deg);
      side.alpha_deg = BearingFrom(-seen_m, vessels[places[1 - i]].motion.heading_deg);
      side.conduct = open->sides[i].conduct;
    }
  }
  open->offset_m = offset_m;
  encounter.end_s = time_s;

  const bool opens = moved_m.dot(offset_m) >= 0;
  if (!opens) open->opening_since_s = -1;
  if (opens && open->opening_since_s < 0) open->opening_since_s = last_s_;
  return !(opens && offset_m.norm() > options_.end_range_m &&
           time_s - open->opening_since_s >= options_.open_s);
}

void EncounterWatch::UpdateSide(double time_s, const VesselSample& own,
                                const RelativeGeometry& geometry, bool must_keep_clear,
                                bool other_keeps_clear, EncounterSide* side, OpenSide* now) const {
  const double turned_now_deg = Wrap180(own.motion.heading_deg - now->last_heading_deg);
  now->course_change_deg += turned_now_deg;
  if (std::abs(turned_now_deg) > kSteady_degps * (time_s - last_s_)) now->last_turning_s = time_s;
  if (!IsRisk(geometry, options_.risk_m)) {
    now->turns_freely = true;
  } else if (time_s - now->last_turning_s >= kSteady_s) {
    now->turns_freely = false;
  }
  if (now->turns_freely) now->turned_from_deg = now->course_change_deg;
  now->last_heading_deg = own.motion.heading_deg;
  now->speed_change_share = (own.motion.speed_mps - side->entry_speed_mps) /
                            std::max(side->entry_speed_mps, options_.least_speed_mps);
  Conduct& conduct = now->conduct;
  const double course_deg = std::abs(now->course_change_deg);
  const double speed_share = std::abs(now->speed_change_share);
  if (conduct.altered_to == 0 && course_deg >= kAlteration_deg) {
    conduct.altered_to = now->course_change_deg > 0 ? 1 : -1;
  }
  if (!conduct.first_alteration_s &&
      (course_deg >= kAlteration_deg || speed_share >= kAlterationShare)) {
    conduct.first_alteration_s = time_s;
  }
  KeepLargest(now->course_change_deg, &conduct.largest_course_change_deg);
  KeepLargest(now->speed_change_share, &conduct.largest_speed_change_share);

  if (StandsOn(side->role)) {
    if (must_keep_clear && !side->excused_s) side->excused_s = time_s;
    const bool is_extreme = geometry.range_m <= kExtremisShare * options_.preferred_m &&
                            geometry.range_rate_mps < 0 && geometry.cpa_m < options_.acceptable_m;
    now->is_in_extremis = is_extreme;
    if (is_extreme && !conduct.in_extremis_s) {
      conduct.in_extremis_s = time_s;
      now->extremis_course_change_deg = now->course_change_deg;
      now->turned_from_deg = now->course_change_deg;
      now->extremis_speed_change_share = now->speed_change_share;
    }
    if (!conduct.in_extremis_s && !side->excused_s) {
      KeepLargest(course_deg, &conduct.held_course_change_deg);
      KeepLargest(speed_share, &conduct.held_speed_change_share);
    }
    if (conduct.in_extremis_s && !conduct.acted_in_extremis) {
      const double turned_deg = now->course_change_deg - now->extremis_course_change_deg;
      const double slowed = now->speed_change_share - now->extremis_speed_change_share;
      conduct.acted_in_extremis =
          std::abs(turned_deg) >= kExtremisAction_deg || std::abs(slowed) >= kExtremisActionShare;
      conduct.turned_to_port_in_extremis = turned_deg <= -kExtremisAction_deg;
    }
    if (side->role == EncounterRole::kOvertaken && !side->excused_s) {
      KeepLargest(std::max(0.0, now->speed_change_share), &conduct.held_speed_change_share);
    }
    // Rule 17 holds where the other keeps out of the way: not for two that see each other to port.
    if (side->role == EncounterRole::kStandOn && other_keeps_clear && !side->excused_s &&
        Wrap180(geometry.beta_deg) < 0 &&
        now->course_change_deg - now->turned_from_deg <= -kExtremisAction_deg) {
      conduct.turned_to_port_while_standing_on = true;
    }
  }

  const double alpha_deg = Wrap180(geometry.alpha_deg);
  const bool changes_side = (alpha_deg > 0) != (now->last_alpha_deg > 0);
  if (changes_side && std::abs(alpha_deg) < 90 && std::abs(now->last_alpha_deg) < 90) {
    const double share = std::abs(now->last_alpha_deg) / std::abs(alpha_deg - now->last_alpha_deg);
    const double crossed_m = now->last_range_m + share * (geometry.range_m - now->last_range_m);
    side->crossed_ahead_m = std::min(side->crossed_ahead_m.value_or(crossed_m), crossed_m);
  }
  if (changes_side && std::abs(alpha_deg) > 90 && std::abs(now->last_alpha_deg) > 90) {
    side->crossed_astern = true;
  }
  now->last_alpha_deg = alpha_deg;
  now->last_range_m = geometry.range_m;
}

void EncounterWatch::Begin(double time_s, std::span<const VesselSample> vessels, uint32_t first,
                           uint32_t second) {
  const VesselSample* samples[2] = {&vessels[first], &vessels[second]};
  if (std::min(samples[0]->motion.speed_mps, samples[1]->motion.speed_mps) <
          options_.least_speed_mps ||
      std::abs(samples[0]->depth_m - samples[1]->depth_m) > options_.same_depth_m) {
    return;
  }
  const RelativeGeometry geometry[2] = {GeometryOf(samples[0]->motion, samples[1]->motion),
                                        GeometryOf(samples[1]->motion, samples[0]->motion)};
  if (geometry[0].range_m >= options_.entry_range_m || geometry[0].range_rate_mps >= 0 ||
      geometry[0].cpa_m >= options_.risk_m) {
    return;
  }
  if (open_.contains({first, second})) return;
  if (open_.size() >= kMax) {
    is_complete_ = false;
    return;
  }
  Open open;
  Encounter& encounter = open.encounter;
  encounter.begin_s = encounter.end_s = encounter.closest_s = time_s;
  encounter.closest_m = geometry[0].range_m;
  encounter.touch_m = (samples[0]->length_m + samples[1]->length_m) / 2;
  encounter.has_touched =
      Hypot(geometry[0].range_m, samples[0]->depth_m - samples[1]->depth_m) < encounter.touch_m;
  for (size_t i = 0; i < 2; ++i) {
    const VesselMotion& own = samples[i]->motion;
    encounter.sides[i] = {
        .vessel = i == 0 ? first : second,
        .role = Classify(geometry[i], own.speed_mps, samples[1 - i]->motion.speed_mps,
                         options_.risk_m, options_.classify),
        .entry = geometry[i],
        .entry_heading_deg = own.heading_deg,
        .entry_speed_mps = own.speed_mps,
        .beta_deg = geometry[i].beta_deg,
        .alpha_deg = geometry[i].alpha_deg,
        .conduct = {},
        .crossed_ahead_m = {},
        .crossed_astern = false,
        .excused_s = {}};
    open.sides[i].last_heading_deg = own.heading_deg;
    open.sides[i].last_turning_s = time_s;
    open.sides[i].last_alpha_deg = Wrap180(geometry[i].alpha_deg);
    open.sides[i].last_range_m = geometry[i].range_m;
  }
  open.offset_m = samples[1]->motion.position_m - samples[0]->motion.position_m;
  open_.emplace(Pair{first, second}, open);
}

void EncounterWatch::FindBegins(double time_s, std::span<const VesselSample> vessels) {
  places_.clear();
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high = -low;
  for (const VesselSample& vessel : vessels) {
    if (!vessel.is_seen) continue;
    low = low.cwiseMin(vessel.motion.position_m);
    high = high.cwiseMax(vessel.motion.position_m);
  }
  const int axis = high.x() - low.x() >= high.y() - low.y() ? 0 : 1;
  for (size_t i = 0; i < vessels.size(); ++i) {
    if (!vessels[i].is_seen) continue;
    places_.push_back({vessels[i].motion.position_m[axis], static_cast<uint32_t>(i)});
  }
  std::sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) {
    return std::tuple(a.along_m, a.vessel) < std::tuple(b.along_m, b.vessel);
  });
  for (size_t i = 0; i < places_.size(); ++i) {
    for (size_t j = i + 1; j < places_.size(); ++j) {
      if (places_[j].along_m - places_[i].along_m >= options_.entry_range_m) break;
      const auto [first, second] = std::minmax(places_[i].vessel, places_[j].vessel);
      Begin(time_s, vessels, first, second);
    }
  }
}

void EncounterWatch::Keep(Encounter encounter) {
  if (ended_.size() < kMax) {
    ended_.push_back(encounter);
  } else {
    is_complete_ = false;
  }
}

}  // namespace shoal
