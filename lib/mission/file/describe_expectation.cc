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

#include "lib/comms/routing/fate.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/toml/suggest.h"
#include "lib/vehicle/guidance/survey_lanes.h"

namespace shoal {
namespace {

constexpr int64_t kLargestCount = 1'000'000'000'000;

void DescribeVehicle(Fields& fields, std::string& vehicle) {
  fields.Require("vehicle", "vehicle = \"alpha\", or \"all\"");
  fields.Text("vehicle", vehicle, {.min_length = 1});
}

void Describe(Fields& fields, ArrivalExpectation& arrival, double end_s) {
  DescribeVehicle(fields, arrival.vehicle);
  if (fields.Has("point", arrival.point_m.has_value())) {
    Eigen::Vector2d point_m = arrival.point_m.value_or(Eigen::Vector2d::Zero());
    fields.Pair("point", point_m, Between(-kFarthest_m, kFarthest_m));
    arrival.point_m = point_m;
  }
  fields.Number("within_m", arrival.within_m, Above(0, 100'000));
  if (fields.reading()) arrival.by_s = end_s;
  fields.Number("by_s", arrival.by_s, Above(0, end_s));
  fields.Flag("stays", arrival.stays);
}

void Describe(Fields& fields, SeparationExpectation& separation, double /*end_s*/) {
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

void Describe(Fields& fields, CommsExpectation& comms, double /*end_s*/) {
  fields.Text("from", comms.from, {.min_length = 1});
  fields.Text("to", comms.to, {.min_length = 1});
  std::vector<std::string_view> causes;
  for (const CauseRow& row : kCauseTable) {
    if (CanHave(comms.kind, row.cause)) causes.push_back(row.key);
  }
  fields.Word("cause", comms.cause, causes);
  DescribeCount(fields, "at_least", comms.at_least);
  DescribeCount(fields, "at_most", comms.at_most);
  DescribePercentage(fields, "at_least_pct", comms.at_least_pct);
  DescribePercentage(fields, "at_most_pct", comms.at_most_pct);
  if (!comms.at_least && !comms.at_most && !comms.at_least_pct && !comms.at_most_pct) {
    fields.Refuse("", fmt::format("an expectation of {} needs one of at_least, at_most, "
                                  "at_least_pct, at_most_pct, or several",
                                  NameOf(comms.kind)));
  }
  CheckLimits(fields, "at_least", comms.at_least, "at_most", comms.at_most);
  CheckLimits(fields, "at_least_pct", comms.at_least_pct, "at_most_pct", comms.at_most_pct);
}

void Describe(Fields& fields, SwarmExpectation& swarm, double /*end_s*/) {
  constexpr std::array<std::string_view, 3> kOutcomes = {"clean", "recovered", "rejected"};
  fields.Text("from", swarm.from, {.min_length = 1});
  fields.Text("to", swarm.to, {.min_length = 1});
  fields.Word("outcome", swarm.outcome, kOutcomes);
  DescribePercentage(fields, "at_least_pct", swarm.at_least_pct);
  DescribePercentage(fields, "at_most_pct", swarm.at_most_pct);
  if (!swarm.at_least_pct && !swarm.at_most_pct) {
    fields.Refuse("", "an expectation of a swarm needs at_least_pct, at_most_pct or both");
  }
  CheckLimits(fields, "at_least_pct", swarm.at_least_pct, "at_most_pct", swarm.at_most_pct);
}

void Describe(Fields& fields, HelmExpectation& helm, double /*end_s*/) {
  constexpr std::array<std::string_view, 3> kStates = {"PARK", "DRIVE", "ALL-STOP"};
  DescribeVehicle(fields, helm.vehicle);
  const bool has_state = fields.Has("state", !helm.state.empty());
  if (has_state) fields.Word("state", helm.state, kStates);
  const bool has_task = fields.Has("task", !helm.task.empty());
  if (has_task) fields.Text("task", helm.task, {.min_length = 1});
  if (!has_state && !has_task) fields.Refuse("", "an expectation of a helm needs state or task");
}

void Describe(Fields& fields, LapsExpectation& laps, double end_s) {
  DescribeVehicle(fields, laps.vehicle);
  fields.Require("task", "task = \"survey\"");
  fields.Text("task", laps.task, {.min_length = 1});
  fields.Integer("at_least", laps.at_least, 1, kLargestCount);
  fields.Number("by_s", laps.by_s, Between(0, end_s));
}

void Describe(Fields& fields, TrackExpectation& track, double end_s) {
  DescribeVehicle(fields, track.vehicle);
  fields.Number("max_m", track.max_m, Above(0, 100'000));
  fields.Number("from_s", track.from_s, Between(0, end_s));
}

void Describe(Fields& fields, DistanceExpectation& distance, double end_s) {
  DescribeVehicle(fields, distance.vehicle);
  fields.Require("to", "to = \"alpha\", or \"all\"");
  fields.Text("to", distance.to, {.min_length = 1});
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
  fields.Number("from_s", distance.from_s, Between(0, end_s));
}

void Describe(Fields& fields, AltitudeExpectation& altitude, double /*end_s*/) {
  DescribeVehicle(fields, altitude.vehicle);
  fields.Require("min_m", "min_m = 5");
  fields.Number("min_m", altitude.min_m, Between(0, 20'000));
}

void Describe(Fields& fields, NavigationErrorExpectation& error, double end_s) {
  DescribeVehicle(fields, error.vehicle);
  fields.Require("max_m", "max_m = 10");
  fields.Number("max_m", error.max_m, Above(0, kFarthest_m));
  fields.Number("from_s", error.from_s, Between(0, end_s));
}

/// When an encounter begins and ends.
void DescribeEncounter(Fields& fields, EncounterOptions& encounter) {
  fields.Number("entry_range_m", encounter.entry_range_m, Above(0, kFarthest_m));
  fields.Number("risk_m", encounter.risk_m, Above(0, kFarthest_m));
  fields.Number("end_range_m", encounter.end_range_m, Between(0, kFarthest_m));
}

void Describe(Fields& fields, ClosestApproachExpectation& approach, double /*end_s*/) {
  fields.Text("vehicle", approach.vehicle, {.min_length = 1});
  fields.Text("to", approach.to, {.min_length = 1});
  fields.Require("at_least_m", "at_least_m = 10");
  fields.Number("at_least_m", approach.at_least_m, Above(0, 100'000));
  DescribeEncounter(fields, approach.encounter);
}

void Describe(Fields& fields, EncounterScoreExpectation& score, double /*end_s*/) {
  constexpr std::array<std::string_view, 5> kRoles = {"overtaking", "overtaken", "head-on",
                                                      "give-way", "stand-on"};
  fields.Text("vehicle", score.vehicle, {.min_length = 1});
  fields.Text("to", score.to, {.min_length = 1});
  fields.Require("at_least", "at_least = 60");
  fields.Number("at_least", score.at_least, Between(0, 100));
  if (fields.Has("role", !score.role.empty())) fields.Word("role", score.role, kRoles);
  DescribeEncounter(fields, score.encounter);
  EncounterOptions& encounter = score.encounter;
  fields.Number("preferred_m", encounter.preferred_m, Above(0, kFarthest_m));
  fields.Number("acceptable_m", encounter.acceptable_m, Above(0, kFarthest_m));
  fields.Number("near_miss_m", encounter.near_miss_m, Above(0, kFarthest_m));
  if (encounter.near_miss_m > encounter.acceptable_m ||
      encounter.acceptable_m > encounter.preferred_m) {
    fields.Refuse("", "distances must grow from near_miss_m over acceptable_m to preferred_m");
  }
}

void Describe(Fields& fields, CoverageExpectation& coverage, double /*end_s*/) {
  constexpr size_t kMaxCorners = 200;
  constexpr size_t kMaxNames = 10'000;
  if (fields.Has("polygon", !coverage.polygon_m.empty())) {
    fields.Pairs("polygon", coverage.polygon_m, Between(-kFarthest_m, kFarthest_m), kMaxCorners);
    const std::string problem = fields.IsSound() ? PolygonProblem(coverage.polygon_m) : "";
    if (!problem.empty()) fields.Refuse("polygon", problem);
  }
  fields.Require("sensor_width_m", "sensor_width_m = 20");
  fields.Number("sensor_width_m", coverage.sensor_width_m, Above(0, 100'000));
  fields.Require("at_least_pct", "at_least_pct = 95");
  fields.Number("at_least_pct", coverage.at_least_pct, Between(0, 100));
  fields.Texts("vehicles", coverage.vehicles, kMaxNames);
}

}  // namespace

void Describe(Fields& fields, Expectation& expectation, double end_s) {
  // The first ones in the order of Expectation::what.
  constexpr std::array<std::string_view, 16> kKinds = {
      "arrival",         "separation", "reports",          "helm",     "laps",
      "track",           "distance",   "altitude",         "swarm",    "closest_approach",
      "encounter_score", "coverage",   "navigation_error", "messages", "acks",
      "packets"};
  static_assert(kKinds.size() == std::variant_size_v<decltype(Expectation::what)> - 1 + kNumKinds,
                "each expectation has a word, that of deliveries one for each kind");
  std::string kind(fields.reading() ? "" : kKinds.at(expectation.what.index()));
  if (const auto* comms = std::get_if<CommsExpectation>(&expectation.what)) {
    kind = fields.reading() ? "" : NameOf(comms->kind);
  }
  fields.Require("kind", "kind = \"arrival\"");
  fields.Word("kind", kind, kKinds);
  if (fields.reading()) {
    expectation.where = fields.Where();
    if (kind == "separation") expectation.what = SeparationExpectation();
    for (const Kind each : kEnumerators<Kind>) {
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
    if (kind == "closest_approach") expectation.what = ClosestApproachExpectation();
    if (kind == "encounter_score") expectation.what = EncounterScoreExpectation();
    if (kind == "coverage") expectation.what = CoverageExpectation();
    if (kind == "navigation_error") expectation.what = NavigationErrorExpectation();
  }
  if (kind.empty()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return;
  }
  std::visit([&](auto& what) { Describe(fields, what, end_s); }, expectation.what);
}

}  // namespace shoal
