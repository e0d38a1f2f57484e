// What of a mission follows from other tables: names as the vehicles write them, and what the file
// leaves open.
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "lib/comms/routing/destinations.h"
#include "lib/mission/file/validate.h"

namespace shoal {
namespace {

struct ResolveEvent {
  const TablePlace& place;
  const Mission& mission;

  void operator()(CommandEvent& event) const {
    ResolveAddressees(place, "vehicle", event.vehicle, mission);
  }
  void operator()(SimCommandEvent& event) const {
    ResolveAddressees(place, "vehicle", event.vehicle, mission);
  }
  void operator()(RuleEvent& event) const {
    ResolveVehicle(place, "vehicle", event.vehicle, mission, false);
  }
  void operator()(MessageEvent& event) const {
    const TablePlace message = place.Below("message");
    ResolveVehicle(message, "src_node", event.src_node, mission, false);
    // Others can never be reached; the broker takes names in any case, so that they stay as
    // written.
    for (std::string name : ParseDestinations(event.dest_node).names) {
      ResolveVehicle(message, "dest_node", name, mission, true);
    }
  }
};

struct ResolveExpectation {
  const TablePlace& place;
  const Mission& mission;

  template <class OfOneVehicle>
  void operator()(OfOneVehicle& expectation) const {
    ResolveVehicle(place, "vehicle", expectation.vehicle, mission, true);
  }
  void operator()(SeparationExpectation&) const {}
  void operator()(CoverageExpectation& coverage) const {
    for (std::string& name : coverage.vehicles) ResolveAddressees(place, "vehicles", name, mission);
  }
  void operator()(CommsExpectation& comms) const { ResolveLink(comms); }
  void operator()(SwarmExpectation& swarm) const { ResolveLink(swarm); }
  void operator()(DistanceExpectation& distance) const {
    ResolveVehicle(place, "vehicle", distance.vehicle, mission, true);
    ResolveVehicle(place, "to", distance.to, mission, true);
  }

  void operator()(ClosestApproachExpectation& approach) const { ResolvePair(approach); }
  void operator()(EncounterScoreExpectation& score) const { ResolvePair(score); }

  template <class OfPairs>
  void ResolvePair(OfPairs& expectation) const {
    ResolveVehicle(place, "vehicle", expectation.vehicle, mission, true);
    ResolveVehicle(place, "to", expectation.to, mission, true);
  }
  template <class OfLinks>
  void ResolveLink(OfLinks& expectation) const {
    ResolveVehicle(place, "from", expectation.from, mission, true);
    ResolveVehicle(place, "to", expectation.to, mission, true);
  }
};

/// Vehicles whose packets are ranges.
void ResolveBeacons(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.beacons.size(); ++i) {
    ResolveVehicle(file.Below("beacon", i), "sender", mission.beacons[i].sender, mission, false);
  }
}

void ResolveTargets(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    std::vector<Task>& tasks = mission.vehicles[i].tasks;
    for (size_t k = 0; k < tasks.size(); ++k) {
      const TablePlace place = file.Below("vehicle", i).Below("task", k);
      std::vector<std::string>* group = nullptr;
      if (auto* track = std::get_if<TargetTrackTask>(&tasks[k].what)) {
        ResolveVehicle(place, "target", track->target, mission, false);
        group = &track->group;
      }
      if (auto* path = std::get_if<PathFollowTask>(&tasks[k].what)) group = &path->group;
      if (group == nullptr) continue;
      for (std::string& member : *group) ResolveVehicle(place, "group", member, mission, false);
    }
  }
}

/// Contacts that behaviors name.
void ResolveContacts(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    std::vector<BehaviorOptions>& behaviors = mission.vehicles[i].behaviors;
    for (size_t k = 0; k < behaviors.size(); ++k) {
      std::string* contact = ContactOf(behaviors[k].what);
      if (contact == nullptr || contact->empty()) continue;
      ResolveVehicle(file.Below("vehicle", i).Below("behavior", k), "contact", *contact, mission,
                     false);
    }
  }
}

/// Behaviors of vehicles that dive decide about depth, too.
void FillInDomains(Mission& mission) {
  constexpr Axis kDepths = {.first = 0, .step = 1, .count = 101};
  for (Vehicle& vehicle : mission.vehicles) {
    Axis& depth_m = vehicle.domain.depth_m;
    const bool dives = FactsOfModel(vehicle.model).is_underwater;
    if (dives && !vehicle.behaviors.empty() && depth_m.count == 0) depth_m = kDepths;
  }
}

void FillInRadii(const TablePlace& place, double hold_radius_m, Task& task) {
  if (auto* keep = std::get_if<StationKeepTask>(&task.what)) {
    keep->stops_first = true;
    if (place.Has("inner_radius_m") || place.Has("outer_radius_m")) return;
    const StationKeepTask hold = HoldHere(hold_radius_m, std::nullopt);
    keep->inner_radius_m = hold.inner_radius_m;
    keep->outer_radius_m = hold.outer_radius_m;
    if (!place.Has("speed_mps")) keep->speed_mps = hold.speed_mps;
    return;
  }
  if (auto* home = std::get_if<ReturnTask>(&task.what); home && !place.Has("outer_radius_m")) {
    home->outer_radius_m = hold_radius_m;
  }
  if (auto* track = std::get_if<TargetTrackTask>(&task.what);
      track && !place.Has("hold_radius_m")) {
    track->hold_radius_m = hold_radius_m;
  }
}

/// Underwater vehicles turn in a circle: they keep station within one that is as wide, wherever the
/// file leaves the radius open.
void FillInRadii(Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    Vehicle& vehicle = mission.vehicles[i];
    const double turning_diameter_m = FactsOfModel(vehicle.model).turning_diameter_m;
    if (turning_diameter_m <= 0) continue;
    const TablePlace place = file.Below("vehicle", i);
    HelmOptions& options = vehicle.helm_options;
    if (!place.Below("helm_options").Has("hold_radius_m")) {
      options.hold_radius_m = turning_diameter_m;
    }
    if (!place.Below("return").Has("outer_radius_m")) {
      vehicle.return_task.outer_radius_m = options.hold_radius_m;
    }
    for (size_t k = 0; k < vehicle.tasks.size(); ++k) {
      FillInRadii(place.Below("task", k), options.hold_radius_m, vehicle.tasks[k]);
    }
  }
}

bool UsesAcoustics(const RoutingRules& rules) {
  return rules.reports_over.Has(kAcousticMedium) || rules.messages_over.Has(kAcousticMedium);
}

/// Of a channel that states no bottom, that is the sea floor of the mission.
void FillInBottom(const FloorOptions& floor, const TablePlace& channel, AcousticOptions& options) {
  if (!options.rays || channel.Has("bottom_depth_m") || channel.Has("follows_floor")) return;
  if (!options.rays->arrivals_file.empty()) return;
  if (floor.style == "none") {
    channel.Refuse("",
                   "rays need a bottom: write bottom_depth_m = 100, or give the mission a sea "
                   "floor, [environment.floor]");
  } else if (floor.style == "flat") {
    options.rays->bottom_depth_m = std::max(floor.depth_m, 1.0);
  } else {
    options.rays->follows_floor = true;
  }
}

void FillInBottoms(Mission& mission, const TablePlace& file) {
  const FloorOptions& floor = mission.environment.floor;
  FillInBottom(floor, file.Below("acoustics").Below("channel"), mission.acoustics.options);
  for (size_t i = 0; i < mission.media.size(); ++i) {
    FillInBottom(floor, file.Below("medium", i).Below("channel"),
                 mission.media[i].acoustics.options);
  }
}

/// A vehicle's place in the mission, without the address that all receive.
void FillInAddresses(Mission& mission) {
  const int broadcast = mission.acoustics.options.broadcast_address;
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    int& address = mission.vehicles[i].acoustic_address;
    const int place = static_cast<int>(i) + 1;
    if (address == 0) address = place + (broadcast >= 1 && place >= broadcast ? 1 : 0);
  }
}

}  // namespace

void ResolveNames(Mission& mission, const TablePlace& file) {
  ResolveBeacons(mission, file);
  ResolveTargets(mission, file);
  ResolveSurveyShares(mission, file);
  ResolveContacts(mission, file);
  ResolveSwarms(mission, file);
  if (mission.netsim) {
    const TablePlace netsim = file.Below("netsim");
    for (size_t i = 0; i < mission.netsim->vehicles.size(); ++i) {
      ResolveVehicle(netsim.Below("vehicle", i), "name", mission.netsim->vehicles[i].name, mission,
                     false);
    }
  }
  for (size_t i = 0; i < mission.events.size(); ++i) {
    std::visit(ResolveEvent{file.Below("event", i), mission}, mission.events[i].what);
  }
  for (size_t i = 0; i < mission.orders.size(); ++i) {
    ResolveEvent{file.Below("order", i), mission}(mission.orders[i].command);
  }
  for (size_t i = 0; i < mission.expectations.size(); ++i) {
    std::visit(ResolveExpectation{file.Below("expect", i), mission}, mission.expectations[i].what);
  }
}

void CompleteMission(Mission& mission, const TablePlace& file) {
  mission.acoustics.is_used = file.Has("acoustics") || UsesAcoustics(mission.comms);
  FillInTracks(mission, file);
  FillInMedia(mission, file);
  FillInBottoms(mission, file);
  FillInAddresses(mission);
  FillInDomains(mission);
  FillInRadii(mission, file);
  FillInSwarms(mission, file);
}

}  // namespace shoal
