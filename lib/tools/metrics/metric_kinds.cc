// Each kind of metric: its keys in a campaign file, what a mission must have for it, its text, its
// unit, and what measures it. The last table has a row for each.
#include "lib/tools/metrics/metric_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/check/enum_table.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/mission/file/validate.h"
#include "lib/mission/model/names.h"
#include "lib/tools/fields/field_reader.h"
#include "lib/tools/metrics/metric_channel.h"
#include "lib/tools/metrics/metric_vehicles.h"

namespace shoal {

namespace {

constexpr double kFarthestPoint_m = 1e7;
constexpr double kLongest_s = 1e9;

// What several kinds share.

constexpr std::array<std::pair<std::string_view, Reduction>, 5> kReductions = {{
    {"mean", Reduction::kMean},
    {"max", Reduction::kMax},
    {"percentile", Reduction::kPercentile},
    {"min", Reduction::kMin},
    {"last", Reduction::kLast},
}};
constexpr std::array<std::pair<std::string_view, AgeSource>, 3> kAgeSources = {{
    {"auto", AgeSource::kAuto},
    {"swarm", AgeSource::kSwarm},
    {"reports", AgeSource::kReports},
}};

/// reduce and percentile, with the first `kNumReductions` of kReductions.
template <size_t kNumReductions>
void ReadReduction(Fields& fields, MetricSpec* spec) {
  std::array<std::pair<std::string_view, Reduction>, kNumReductions> choices;
  std::copy_n(kReductions.begin(), kNumReductions, choices.begin());
  fields.ChoiceAmong("reduce", spec->reduction, choices);
  const bool has_percentile = fields.Has("percentile", false);
  fields.Number("percentile", spec->percentile, Above(0, 100));
  if (has_percentile && spec->reduction != Reduction::kPercentile) {
    fields.Refuse("percentile",
                  "percentile has an effect only beside reduce = \"percentile\": write that, or "
                  "leave it out");
  }
}

void ReadVehicles(Fields& fields, std::string_view key, std::string& addressees) {
  fields.Text(key, addressees, {.min_length = 1});
}

void ReadTime(Fields& fields, MetricSpec* spec) {
  fields.Number("from_s", spec->from_s, Between(0, kLongest_s));
}

std::string VehiclesText(std::string_view addressees) {
  if (VehicleKey(addressees) == "all") return "every vehicle";
  if (const auto group = GroupNamed(addressees)) return fmt::format("group {}", *group);
  return std::string(addressees);
}

std::string ReductionText(const MetricSpec& spec) {
  switch (spec.reduction) {
    case Reduction::kMin:
      return "least";
    case Reduction::kMax:
      return "largest";
    case Reduction::kMean:
      return "mean";
    case Reduction::kPercentile:
      return fmt::format("{:g} % percentile of", spec.percentile);
    case Reduction::kLast:
      break;
  }
  return "last";
}

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

// Of a link, a group or all: delivered of all decisions.

void ReadTraffic(Fields& fields, MetricSpec* spec) {
  constexpr std::array<std::pair<std::string_view, int>, 5> kTraffic = {{
      {"reports", static_cast<int>(Kind::kReport)},
      {"messages", static_cast<int>(Kind::kMessage)},
      {"acks", static_cast<int>(Kind::kAck)},
      {"packets", static_cast<int>(Kind::kPacket)},
      {"swarm", -1},
  }};
  static_assert(kTraffic.size() == kNumKinds + 1, "each Kind has a word, and the swarm");
  int traffic = static_cast<int>(Kind::kReport);
  fields.ChoiceAmong("traffic", traffic, kTraffic);
  spec->traffic.reset();
  if (traffic >= 0) spec->traffic = static_cast<Kind>(traffic);
}

void ReadDelivery(Fields& fields, MetricSpec* spec) {
  ReadTraffic(fields, spec);
  ReadVehicles(fields, "from", spec->from);
  ReadVehicles(fields, "to", spec->to);
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

std::string DeliveryText(const Mission&, const MetricSpec& spec) {
  return fmt::format("{} from {} to {}",
                     spec.traffic ? fmt::format("delivered {}s", KindText(*spec.traffic))
                                  : std::string("applied swarm messages"),
                     VehiclesText(spec.from), VehiclesText(spec.to));
}

std::unique_ptr<MetricWatch> MakeDeliveryWatch(const Mission& mission, const MetricSpec& spec,
                                               const StepTime&) {
  return WatchDeliveryRatio(mission, spec);
}

// Of what a vehicle knows of others.

void ReadAges(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  ReadVehicles(fields, "to", spec->to);
  fields.Choice("source", spec->source, kAgeSources);
  ReadReduction<3>(fields, spec);
  ReadTime(fields, spec);
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

std::string AgesText(const Mission& mission, const MetricSpec& spec) {
  return fmt::format("{} age of {} of {} at {}", ReductionText(spec),
                     IsOfSwarm(mission, spec.source) ? "swarm contacts" : "node reports",
                     VehiclesText(spec.to), VehiclesText(spec.vehicle));
}

// Closest approach.

void ReadApproach(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  ReadVehicles(fields, "to", spec->to);
  ReadTime(fields, spec);
}

void CheckApproach(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  CheckTwoEnds(place, "to", TakeVehicles(mission, place, "vehicle", &spec->vehicle),
               TakeVehicles(mission, place, "to", &spec->to));
}

std::string ApproachText(const Mission&, const MetricSpec& spec) {
  return fmt::format("least range from {} to {}", VehiclesText(spec.vehicle),
                     VehiclesText(spec.to));
}

// Formation error.

void ReadFormation(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  ReadReduction<4>(fields, spec);
  ReadTime(fields, spec);
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

std::string FormationText(const Mission&, const MetricSpec& spec) {
  return fmt::format("{} formation error of {}", ReductionText(spec), VehiclesText(spec.vehicle));
}

// Distance travelled.

void ReadDistance(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  fields.NoKey("from_s", "the whole way is measured");
}

void CheckVehicles(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  TakeVehicles(mission, place, "vehicle", &spec->vehicle);
}

std::string DistanceText(const Mission&, const MetricSpec& spec) {
  return fmt::format("way of {}", VehiclesText(spec.vehicle));
}

std::unique_ptr<MetricWatch> MakeDistanceWatch(const Mission& mission, const MetricSpec& spec,
                                               const StepTime&) {
  return WatchDistanceTravelled(mission, spec);
}

// Arrival.

void ReadArrival(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  if (fields.Has("point", false)) {
    Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
    fields.Pair("point", point_m, Between(-kFarthestPoint_m, kFarthestPoint_m));
    spec->point_m = point_m;
  }
  fields.Number("within_m", spec->within_m, Above(0, 100'000));
  fields.Flag("stays", spec->stays);
}

std::string ArrivalText(const Mission&, const MetricSpec& spec) {
  const std::string point = spec.point_m
                                ? fmt::format("({:g}, {:g})", spec.point_m->x(), spec.point_m->y())
                                : std::string("its return point");
  return fmt::format("time when {} is within {:g} m of {}{}", VehiclesText(spec.vehicle),
                     spec.within_m, point, spec.stays ? " for good" : "");
}

// Energy.

void ReadEnergy(Fields& fields, MetricSpec* spec) {
  ReadVehicles(fields, "vehicle", spec->vehicle);
  ReadTime(fields, spec);
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

std::string EnergyText(const Mission&, const MetricSpec& spec) {
  return fmt::format("propeller shaft work of {}", VehiclesText(spec.vehicle));
}

// Any field of any channel.

void ReadField(Fields& fields, MetricSpec* spec) {
  fields.Require("channel", "channel = \"NAV_ALPHA\"");
  fields.Text("channel", spec->channel, {.min_length = 1, .max_length = 63});
  fields.Require("field", "field = \"speed_mps\"");
  fields.Text("field", spec->field, {.min_length = 1, .max_length = 256});
  ReadReduction<5>(fields, spec);
  ReadTime(fields, spec);
}

void CheckField(const Mission& mission, const TablePlace& place, MetricSpec* spec) {
  const Result<const ChannelRow*> row = FindMetricChannel(mission, spec->channel);
  if (!row.ok()) {
    place.Refuse("channel", row.error());
    return;
  }
  const auto reader = FieldReader::Find(ShoalTypes(), (*row)->type, spec->field);
  if (!reader.ok()) place.Refuse("field", reader.error());
}

std::string FieldText(const Mission&, const MetricSpec& spec) {
  return fmt::format("{} {} of {}", ReductionText(spec), spec.field, spec.channel);
}

std::string UnitOfField(std::string_view field) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kUnits = {{
      {"m", "m"},
      {"km", "km"},
      {"m2", "m2"},
      {"s", "s"},
      {"us", "us"},
      {"mps", "m/s"},
      {"mps2", "m/s2"},
      {"deg", "deg"},
      {"degps", "deg/s"},
      {"rad", "rad"},
      {"radps", "rad/s"},
      {"pct", "%"},
      {"rpm", "rpm"},
      {"hz", "Hz"},
      {"db", "dB"},
  }};
  if (field.ends_with(']')) field = field.substr(0, field.rfind('['));
  const size_t begin = field.find_last_of("_.");
  if (begin == std::string_view::npos || field[begin] == '.') return "";
  for (const auto& [suffix, unit] : kUnits) {
    if (suffix == field.substr(begin + 1)) return std::string(unit);
  }
  return "";
}

constexpr EnumTable<MetricKind, MetricKindRow> kRows = {
    MetricKindRow{MetricKind::kDeliveryRatio, "delivery_ratio", "%", ReadDelivery, CheckDelivery,
                  DeliveryText, MakeDeliveryWatch},
    MetricKindRow{MetricKind::kInformationAge, "information_age", "s", ReadAges, CheckAges,
                  AgesText, WatchInformationAge},
    MetricKindRow{MetricKind::kClosestApproach, "closest_approach", "m", ReadApproach,
                  CheckApproach, ApproachText, WatchClosestApproach},
    MetricKindRow{MetricKind::kFormationError, "formation_error", "m", ReadFormation,
                  CheckFormation, FormationText, WatchFormationError},
    MetricKindRow{MetricKind::kDistanceTravelled, "distance_travelled", "m", ReadDistance,
                  CheckVehicles, DistanceText, MakeDistanceWatch},
    MetricKindRow{MetricKind::kArrivalTime, "arrival_time", "s", ReadArrival, CheckVehicles,
                  ArrivalText, WatchArrivalTime},
    MetricKindRow{MetricKind::kEnergy, "energy", "J", ReadEnergy, CheckEnergy, EnergyText,
                  WatchEnergy},
    MetricKindRow{MetricKind::kField, "field", "", ReadField, CheckField, FieldText, WatchField},
};

/// A row without one of its functions does not compile either: -Wmissing-field-initializers.
consteval bool AreInPlace() {
  for (size_t i = 0; i < kRows.size(); ++i) {
    const MetricKindRow& row = kRows.At(i);
    if (static_cast<size_t>(row.kind) != i || row.word.empty()) return false;
  }
  return true;
}
static_assert(AreInPlace(), "each MetricKind has a row at its place");

}  // namespace

std::span<const MetricKindRow> MetricKindTable() { return kRows; }

const MetricKindRow& RowOf(MetricKind kind) { return kRows[kind]; }

std::string UnitOfMetric(const MetricSpec& spec) {
  if (spec.kind == MetricKind::kField) return UnitOfField(spec.field);
  return std::string(RowOf(spec.kind).unit);
}

std::string DescribeMetric(const Mission& mission, const MetricSpec& spec) {
  std::string text = RowOf(spec.kind).text(mission, spec);
  if (spec.from_s > 0) text += fmt::format(" from {:g} s on", spec.from_s);
  return text;
}

}  // namespace shoal
