// The table [[expect]].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/mission/describe.h"
#include "lib/mission/suggest.h"
#include "lib/routing/fate.h"

namespace shoal {
namespace {

/// Tasks that a helm does without being given them by the mission.
constexpr std::array<std::string_view, 4> kOwnTasks = {"return", "station_keep", "goto",
                                                       "end_of_tasks"};
constexpr int64_t kLargestCount = 1'000'000'000'000;

Range UntilTheEnd(const Mission& mission, bool excludes_zero) {
  return {0, mission.duration_s > 0 ? mission.duration_s : kLongest_s, excludes_zero};
}

void DescribeVehicle(Fields& fields, std::string& vehicle, const Mission& mission) {
  fields.Require("vehicle", "vehicle = \"alpha\", or \"all\"");
  fields.Text("vehicle", vehicle, {.min_length = 1});
  ResolveVehicle(fields, "vehicle", vehicle, mission, true);
}

/// Refuses a task that one of the vehicles has not. `own` are the helm's, and right as well.
void CheckTask(Fields& fields, const std::string& vehicle_name, const std::string& task_name,
               const Mission& mission, std::span<const std::string_view> own) {
  if (task_name.empty()) return;
  for (const Vehicle* vehicle : VehiclesNamed(mission, vehicle_name)) {
    std::vector<std::string_view> names;
    for (const Task& task : vehicle->tasks) names.push_back(task.name);
    names.insert(names.end(), own.begin(), own.end());
    if (std::find(names.begin(), names.end(), task_name) != names.end()) continue;
    fields.Refuse("task", fmt::format("{} has no task {}{}", vehicle->name, Quoted(task_name),
                                      DidYouMean(task_name, names)));
    return;
  }
}

void Describe(Fields& fields, ArrivalExpectation& arrival, const Mission& mission) {
  DescribeVehicle(fields, arrival.vehicle, mission);
  if (fields.Has("point", arrival.point_m.has_value())) {
    Eigen::Vector2d point_m = arrival.point_m.value_or(Eigen::Vector2d::Zero());
    fields.Pair("point", point_m, Between(-kFarthest_m, kFarthest_m));
    arrival.point_m = point_m;
  }
  fields.Number("within_m", arrival.within_m, Above(0, 100'000));
  if (fields.reading()) arrival.by_s = mission.duration_s;
  fields.Number("by_s", arrival.by_s, UntilTheEnd(mission, true));
  fields.Flag("stays", arrival.stays);
}

void Describe(Fields& fields, SeparationExpectation& separation, const Mission&) {
  fields.Require("min_m", "min_m = 5");
  fields.Number("min_m", separation.min_m, Above(0, 100'000));
}

/// What an expectation calls the fates of one kind: "reports".
std::string NameOf(Kind kind) { return std::string(KindText(kind)) + "s"; }

void DescribeCount(Fields& fields, std::string_view key, std::optional<int64_t>& count) {
  if (!fields.Has(key, count.has_value())) return;
  int64_t value = count.value_or(0);
  fields.Integer(key, value, 0, kLargestCount);
  count = value;
}

void DescribePercentage(Fields& fields, std::string_view key, std::optional<double>& percentage) {
  if (!fields.Has(key, percentage.has_value())) return;
  double value = percentage.value_or(0);
  fields.Number(key, value, Between(0, 100));
  percentage = value;
}

/// Refuses two limits between which there is nothing.
template <class Number>
void CheckLimits(Fields& fields, std::string_view low_key, const std::optional<Number>& low,
                 std::string_view high_key, const std::optional<Number>& high) {
  if (!low || !high || *low <= *high) return;
  fields.Refuse(high_key, fmt::format("{} = {} is less than {} = {}: this can never hold", high_key,
                                      *high, low_key, *low));
}

/// Refuses numbers of one destination that nobody counts: the far ones of a large fleet.
void CheckFarTogether(Fields& fields, const CommsExpectation& comms, const Mission& mission) {
  const int64_t limit = mission.comms.each_fate_up_to;
  const bool are_together = static_cast<int64_t>(mission.vehicles.size()) > limit;
  if (!are_together || comms.to == "all") return;
  const bool has_percentage = comms.at_least_pct.has_value() || comms.at_most_pct.has_value();
  if (comms.cause != CauseText(Cause::kOutOfRange) && !has_percentage) return;
  fields.Refuse("to", fmt::format("in a fleet of more than each_fate_up_to = {} vehicles, those "
                                  "that are out of range are counted together: leave to out, or "
                                  "raise [comms] each_fate_up_to",
                                  limit));
}

void Describe(Fields& fields, CommsExpectation& comms, const Mission& mission) {
  fields.Text("from", comms.from, {.min_length = 1});
  ResolveVehicle(fields, "from", comms.from, mission, true);
  fields.Text("to", comms.to, {.min_length = 1});
  ResolveVehicle(fields, "to", comms.to, mission, true);
  std::vector<std::string_view> causes;
  for (const CauseRow& row : kCauseTable) {
    if (CanHave(comms.kind, row.cause)) causes.push_back(row.key);
  }
  fields.Word("cause", comms.cause, causes);
  DescribeCount(fields, "at_least", comms.at_least);
  DescribeCount(fields, "at_most", comms.at_most);
  DescribePercentage(fields, "at_least_pct", comms.at_least_pct);
  DescribePercentage(fields, "at_most_pct", comms.at_most_pct);
  CheckFarTogether(fields, comms, mission);
  if (!comms.at_least && !comms.at_most && !comms.at_least_pct && !comms.at_most_pct) {
    fields.Refuse("", fmt::format("an expectation of {} needs one of at_least, at_most, "
                                  "at_least_pct, at_most_pct, or several",
                                  NameOf(comms.kind)));
  }
  CheckLimits(fields, "at_least", comms.at_least, "at_most", comms.at_most);
  CheckLimits(fields, "at_least_pct", comms.at_least_pct, "at_most_pct", comms.at_most_pct);
}

void Describe(Fields& fields, SwarmExpectation& swarm, const Mission& mission) {
  constexpr std::array<std::string_view, 3> kOutcomes = {"clean", "recovered", "rejected"};
  fields.Text("from", swarm.from, {.min_length = 1});
  ResolveVehicle(fields, "from", swarm.from, mission, true);
  fields.Text("to", swarm.to, {.min_length = 1});
  ResolveVehicle(fields, "to", swarm.to, mission, true);
  fields.Word("outcome", swarm.outcome, kOutcomes);
  DescribePercentage(fields, "at_least_pct", swarm.at_least_pct);
  DescribePercentage(fields, "at_most_pct", swarm.at_most_pct);
  if (!swarm.at_least_pct && !swarm.at_most_pct) {
    fields.Refuse("", "an expectation of a swarm needs at_least_pct, at_most_pct or both");
  }
  CheckLimits(fields, "at_least_pct", swarm.at_least_pct, "at_most_pct", swarm.at_most_pct);
  if (!fields.reading()) return;
  if (!mission.swarm.exists) {
    fields.Refuse("kind", "nobody tells what became of a swarm's messages without [swarm]");
    return;
  }
  for (const auto& [key, name] : {std::pair("from", swarm.from), std::pair("to", swarm.to)}) {
    const Vehicle* vehicle = mission.FindVehicle(name);
    if (vehicle != nullptr && !mission.IsInSwarm(*vehicle)) {
      fields.Refuse(key, name + " is not in the swarm: this can never hold");
    }
  }
  if (swarm.from == swarm.to && swarm.from != "all") {
    fields.Refuse("to", swarm.to + " does not hear itself: this can never hold");
  }
}

void Describe(Fields& fields, HelmExpectation& helm, const Mission& mission) {
  constexpr std::array<std::string_view, 3> kStates = {"PARK", "DRIVE", "ALL-STOP"};
  DescribeVehicle(fields, helm.vehicle, mission);
  const bool has_state = fields.Has("state", !helm.state.empty());
  if (has_state) fields.Word("state", helm.state, kStates);
  const bool has_task = fields.Has("task", !helm.task.empty());
  if (has_task) fields.Text("task", helm.task, {.min_length = 1});
  if (!has_state && !has_task) fields.Refuse("", "an expectation of a helm needs state or task");
  CheckTask(fields, helm.vehicle, helm.task, mission, kOwnTasks);
}

/// Returns how often the points of a task can be passed; nothing: without limit.
std::optional<int64_t> MostLaps(const Task& task) {
  if (std::holds_alternative<StationKeepTask>(task.what)) return 0;
  if (std::holds_alternative<ReturnTask>(task.what)) return 1;
  const auto* waypoints = std::get_if<WaypointsTask>(&task.what);
  if (const auto* path = std::get_if<PathFollowTask>(&task.what)) {
    if (path->end == PathTaskEnd::kReturnToFirst) return std::nullopt;
    return 1;
  }
  if (std::holds_alternative<TargetTrackTask>(task.what)) return 0;
  if (waypoints == nullptr || waypoints->laps == 0) return std::nullopt;
  return waypoints->laps;
}

/// Refuses more laps than the task of one of the vehicles has.
void CheckLaps(Fields& fields, const LapsExpectation& laps, const Mission& mission) {
  for (const Vehicle* vehicle : VehiclesNamed(mission, laps.vehicle)) {
    for (const Task& task : vehicle->tasks) {
      const std::optional<int64_t> most = MostLaps(task);
      if (task.name != laps.task || !most || laps.at_least <= *most) continue;
      if (*most == 0) {
        fields.Refuse("task", fmt::format("{} of {} is a {}, which has no laps", Quoted(task.name),
                                          vehicle->name, KindOf(task)));
      } else {
        fields.Refuse("at_least", fmt::format("at_least = {} can never hold: {} of {} ends after "
                                              "{} lap{}",
                                              laps.at_least, Quoted(task.name), vehicle->name,
                                              *most, *most == 1 ? "" : "s"));
      }
      return;
    }
  }
}

void Describe(Fields& fields, LapsExpectation& laps, const Mission& mission) {
  DescribeVehicle(fields, laps.vehicle, mission);
  fields.Require("task", "task = \"survey\"");
  fields.Text("task", laps.task, {.min_length = 1});
  CheckTask(fields, laps.vehicle, laps.task, mission, {});
  fields.Integer("at_least", laps.at_least, 1, kLargestCount);
  CheckLaps(fields, laps, mission);
  fields.Number("by_s", laps.by_s, UntilTheEnd(mission, false));
}

void Describe(Fields& fields, TrackExpectation& track, const Mission& mission) {
  DescribeVehicle(fields, track.vehicle, mission);
  fields.Number("max_m", track.max_m, Above(0, 100'000));
  fields.Number("from_s", track.from_s, UntilTheEnd(mission, false));
}

void Describe(Fields& fields, DistanceExpectation& distance, const Mission& mission) {
  DescribeVehicle(fields, distance.vehicle, mission);
  fields.Require("to", "to = \"alpha\", or \"all\"");
  fields.Text("to", distance.to, {.min_length = 1});
  ResolveVehicle(fields, "to", distance.to, mission, true);
  const auto limit = [&](std::string_view key, std::optional<double>& limit_m) {
    if (!fields.Has(key, limit_m.has_value())) return;
    double value = limit_m.value_or(0);
    fields.Number(key, value, Between(0, 1e7));
    limit_m = value;
  };
  limit("min_m", distance.min_m);
  limit("max_m", distance.max_m);
  if (!distance.min_m && !distance.max_m) {
    fields.Refuse("", "an expectation of a distance needs min_m, max_m or both");
  } else if (distance.min_m && distance.max_m && *distance.min_m > *distance.max_m) {
    fields.Refuse("max_m", "max_m is less than min_m: this can never hold");
  }
  fields.Number("from_s", distance.from_s, UntilTheEnd(mission, false));
}

void Describe(Fields& fields, AltitudeExpectation& altitude, const Mission& mission) {
  DescribeVehicle(fields, altitude.vehicle, mission);
  fields.Require("min_m", "min_m = 5");
  fields.Number("min_m", altitude.min_m, Between(0, 20'000));
  if (fields.reading() && mission.environment.floor.style == "none") {
    fields.Refuse("",
                  "nobody knows an altitude without a sea floor: write [environment] floor = "
                  "{style = \"flat\", depth_m = 50}");
  }
}

}  // namespace

void Describe(Fields& fields, Expectation& expectation, const Mission& mission) {
  // The first ones in the order of Expectation::what.
  constexpr std::array<std::string_view, 12> kKinds = {
      "arrival",  "separation", "reports", "helm",     "laps", "track",
      "distance", "altitude",   "swarm",   "messages", "acks", "packets"};
  std::string kind(fields.reading() ? "" : kKinds.at(expectation.what.index()));
  if (const auto* comms = std::get_if<CommsExpectation>(&expectation.what)) {
    kind = fields.reading() ? "" : NameOf(comms->kind);
  }
  fields.Require("kind", "kind = \"arrival\"");
  fields.Word("kind", kind, kKinds);
  if (fields.reading()) {
    expectation.where = fields.Where();
    if (kind == "separation") expectation.what = SeparationExpectation();
    for (const Kind each : {Kind::kReport, Kind::kMessage, Kind::kAck, Kind::kPacket}) {
      if (kind != NameOf(each)) continue;
      CommsExpectation comms;
      comms.kind = each;
      expectation.what = comms;
    }
    if (kind == "helm") expectation.what = HelmExpectation();
    if (kind == "laps") expectation.what = LapsExpectation();
    if (kind == "track") expectation.what = TrackExpectation();
    if (kind == "distance") expectation.what = DistanceExpectation();
    if (kind == "swarm") expectation.what = SwarmExpectation();
    if (kind == "altitude") expectation.what = AltitudeExpectation();
  }
  if (kind.empty()) {
    fields.SkipRest();  // Without the kind, nobody knows which keys are right.
    return;
  }
  std::visit([&](auto& what) { Describe(fields, what, mission); }, expectation.what);
}

}  // namespace shoal
