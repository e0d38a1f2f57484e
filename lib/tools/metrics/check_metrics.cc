// Whether a mission has what metrics ask for.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lib/mission/file/validate.h"
#include "lib/mission/toml/table_place.h"
#include "lib/tools/metrics/field_reader.h"
#include "lib/tools/metrics/metric_channel.h"
#include "lib/tools/metrics/metric_vehicles.h"
#include "lib/tools/metrics/read_metrics.h"

namespace shoal {

namespace {

/// Returns the vehicles under `key`, which it writes as the mission does; refuses other names.
std::vector<size_t> TakeVehicles(const Mission& mission, const TablePlace& place,
                                 std::string_view key, std::string* addressees) {
  ResolveAddressees(place, key, *addressees, mission);
  return PlacesOf(mission, *addressees);
}

/// Refuses two ends that are the same vehicle, and no other.
void CheckTwoEnds(const TablePlace& place, std::string_view key, const std::vector<size_t>& one,
                  const std::vector<size_t>& other) {
  if (!place.IsSound() || one.size() != 1 || one != other) return;
  place.Refuse(key, "both ends are the same vehicle: there is nothing to measure between them");
}

void CheckDelivery(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  const std::vector<size_t> from = TakeVehicles(mission, place, "from", &spec->from);
  const std::vector<size_t> to = TakeVehicles(mission, place, "to", &spec->to);
  CheckTwoEnds(place, "to", from, to);
  if (!spec->traffic && mission.swarms.empty()) {
    place.Refuse("traffic", "there are swarm messages only where the mission has a [swarm]");
  }
  const int64_t limit = mission.comms.each_fate_up_to;
  if (spec->traffic && spec->to != "all" && static_cast<int64_t>(mission.vehicles.size()) > limit) {
    place.Refuse("to", fmt::format("in a fleet of more than each_fate_up_to = {} vehicles, those "
                                   "that are out of range are counted together: leave to out, or "
                                   "raise [comms] each_fate_up_to",
                                   limit));
  }
}

void CheckAges(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  const std::vector<size_t> vehicles = TakeVehicles(mission, place, "vehicle", &spec->vehicle);
  const std::vector<size_t> contacts = TakeVehicles(mission, place, "to", &spec->to);
  CheckTwoEnds(place, "to", vehicles, contacts);
  if (spec->source == AgeSource::kSwarm && mission.swarms.empty()) {
    place.Refuse("source",
                 "there are contacts of a swarm only where the mission has a [swarm]: "
                 "write source = \"reports\"");
  }
  if (!place.IsSound() || !IsOfSwarm(mission, spec->source)) return;
  for (const auto& [key, named] : {std::pair("vehicle", &vehicles), std::pair("to", &contacts)}) {
    if (std::any_of(named->begin(), named->end(),
                    [&](size_t i) { return mission.SwarmOf(mission.vehicles[i]) != nullptr; })) {
      continue;
    }
    place.Refuse(key,
                 "no such vehicle is in the [swarm]: write source = \"reports\", or name "
                 "members of it");
  }
}

void CheckFormation(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  const std::vector<size_t> vehicles = TakeVehicles(mission, place, "vehicle", &spec->vehicle);
  if (!place.IsSound()) return;
  const bool follows = std::any_of(vehicles.begin(), vehicles.end(), [&](size_t i) {
    const std::vector<Task>& tasks = mission.vehicles[i].tasks;
    return std::any_of(tasks.begin(), tasks.end(), [](const Task& task) {
      const auto* track = std::get_if<TargetTrackTask>(&task.what);
      return track != nullptr && FollowZoneOf(*track).has_value();
    });
  });
  if (follows) return;
  place.Refuse("vehicle",
               "a formation error is that of a vehicle with a task of kind \"target_track\" that "
               "keeps a distance (layer \"formation\", or constant bearing); here none has one");
}

void CheckEnergy(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  const std::vector<size_t> vehicles = TakeVehicles(mission, place, "vehicle", &spec->vehicle);
  for (const size_t i : vehicles) {
    const Vehicle& vehicle = mission.vehicles[i];
    const std::string_view model = FactsOfModel(vehicle.model).name;
    if (std::holds_alternative<Remus100Options>(vehicle.model)) {
      if (vehicle.sim != Provider::kNone) continue;
      place.Refuse("vehicle", fmt::format("{} is not simulated here: how it moves through the "
                                          "water is not known",
                                          vehicle.name));
    } else {
      place.Refuse("vehicle",
                   fmt::format("{} is a {}, whose model has no power: name vehicles with model = "
                               "\"remus100\", or take kind = \"field\" of {}, field = "
                               "\"thrust_pct\"",
                               vehicle.name, model, channels::Actuators(vehicle.name).name));
    }
    return;
  }
}

void CheckField(const Mission& mission, const TablePlace& place, const MetricSpec& spec) {
  const Result<const ChannelRow*> row = FindMetricChannel(mission, spec.channel);
  if (!row.ok()) {
    place.Refuse("channel", row.error());
    return;
  }
  const auto reader = FieldReader::Find(ShoalTypes(), (*row)->type, spec.field);
  if (!reader.ok()) place.Refuse("field", reader.error());
}

void CheckMetric(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  if (spec->from_s >= mission.duration_s) {
    place.Refuse("from_s", fmt::format("from_s = {} is not before the end of the mission, {} s: "
                                       "there is nothing left to measure",
                                       spec->from_s, mission.duration_s));
  }
  switch (spec->kind) {
    case MetricKind::kDeliveryRatio:
      CheckDelivery(mission, place, spec);
      return;
    case MetricKind::kInformationAge:
      CheckAges(mission, place, spec);
      return;
    case MetricKind::kClosestApproach:
      CheckTwoEnds(place, "to", TakeVehicles(mission, place, "vehicle", &spec->vehicle),
                   TakeVehicles(mission, place, "to", &spec->to));
      return;
    case MetricKind::kFormationError:
      CheckFormation(mission, place, spec);
      return;
    case MetricKind::kDistanceTravelled:
    case MetricKind::kArrivalTime:
      TakeVehicles(mission, place, "vehicle", &spec->vehicle);
      return;
    case MetricKind::kEnergy:
      CheckEnergy(mission, place, spec);
      return;
    case MetricKind::kField:
      CheckField(mission, place, *spec);
  }
}

}  // namespace

void CheckMetrics(const Value& table, const Mission& mission, Problems& problems,
                  std::vector<MetricSpec>* metrics) {
  const TablePlace place(table, problems);
  for (MetricSpec& spec : *metrics) {
    const TablePlace own = place.Below(spec.name);
    if (own.IsSound()) CheckMetric(mission, own, &spec);
  }
}

}  // namespace shoal
