#include "lib/tools/metrics/read_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal {

namespace {

constexpr double kFarthestPoint_m = 1e7;
constexpr double kLongest_s = 1e9;
constexpr size_t kMaxMetrics = 1000;

constexpr std::array<std::pair<std::string_view, MetricKind>, 8> kMetricKinds = {{
    {"delivery_ratio", MetricKind::kDeliveryRatio},
    {"information_age", MetricKind::kInformationAge},
    {"closest_approach", MetricKind::kClosestApproach},
    {"formation_error", MetricKind::kFormationError},
    {"distance_travelled", MetricKind::kDistanceTravelled},
    {"arrival_time", MetricKind::kArrivalTime},
    {"energy", MetricKind::kEnergy},
    {"field", MetricKind::kField},
}};
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
  fields.Choice("reduce", spec->reduction, choices);
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

void ReadTraffic(Fields& fields, MetricSpec* spec) {
  constexpr std::array<std::pair<std::string_view, int>, 5> kTraffic = {{
      {"reports", static_cast<int>(Kind::kReport)},
      {"messages", static_cast<int>(Kind::kMessage)},
      {"acks", static_cast<int>(Kind::kAck)},
      {"packets", static_cast<int>(Kind::kPacket)},
      {"swarm", -1},
  }};
  int traffic = static_cast<int>(Kind::kReport);
  fields.Choice("traffic", traffic, kTraffic);
  spec->traffic.reset();
  if (traffic >= 0) spec->traffic = static_cast<Kind>(traffic);
}

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

void ReadField(Fields& fields, MetricSpec* spec) {
  fields.Require("channel", "channel = \"NAV_ALPHA\"");
  fields.Text("channel", spec->channel, {.min_length = 1, .max_length = 63});
  fields.Require("field", "field = \"speed_mps\"");
  fields.Text("field", spec->field, {.min_length = 1, .max_length = 256});
  ReadReduction<5>(fields, spec);
  ReadTime(fields, spec);
}

void ReadKeysOfKind(Fields& fields, MetricSpec* spec) {
  switch (spec->kind) {
    case MetricKind::kDeliveryRatio:
      ReadTraffic(fields, spec);
      ReadVehicles(fields, "from", spec->from);
      ReadVehicles(fields, "to", spec->to);
      return;
    case MetricKind::kInformationAge:
      ReadVehicles(fields, "vehicle", spec->vehicle);
      ReadVehicles(fields, "to", spec->to);
      fields.Choice("source", spec->source, kAgeSources);
      ReadReduction<3>(fields, spec);
      ReadTime(fields, spec);
      return;
    case MetricKind::kClosestApproach:
      ReadVehicles(fields, "vehicle", spec->vehicle);
      ReadVehicles(fields, "to", spec->to);
      ReadTime(fields, spec);
      return;
    case MetricKind::kFormationError:
      ReadVehicles(fields, "vehicle", spec->vehicle);
      ReadReduction<4>(fields, spec);
      ReadTime(fields, spec);
      return;
    case MetricKind::kDistanceTravelled:
      ReadVehicles(fields, "vehicle", spec->vehicle);
      fields.NoKey("from_s", "the whole way is measured");
      return;
    case MetricKind::kArrivalTime:
      ReadArrival(fields, spec);
      return;
    case MetricKind::kEnergy:
      ReadVehicles(fields, "vehicle", spec->vehicle);
      ReadTime(fields, spec);
      return;
    case MetricKind::kField:
      ReadField(fields, spec);
  }
}

/// Returns why no metric can have this name; empty: it can.
std::string MetricNameProblem(std::string_view name) {
  const bool is_legal =
      !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), IsNameCharacter);
  if (!is_legal) {
    return fmt::format("the name of a metric has 1 to 64 letters, digits and '_', not {}",
                       Quoted(name));
  }
  if (name == "pass" || name.starts_with("expect_")) {
    return fmt::format("{} is the name of what a campaign has without asking: choose another",
                       Quoted(name));
  }
  return "";
}

MetricSpec ReadMetric(const Entry& entry, Problems& problems) {
  TableReader fields(entry.value, fmt::format("metric {}", Quoted(entry.key)), problems);
  MetricSpec spec;
  spec.name = entry.key;
  if (!std::holds_alternative<Table>(entry.value.data)) return spec;
  std::vector<std::string_view> words;
  for (const auto& [word, kind] : kMetricKinds) words.push_back(word);
  std::string word;
  const bool has_channel = fields.Has("channel", false);
  if (!has_channel) fields.Require("kind", "kind = \"closest_approach\"");
  fields.Word("kind", word, words);
  if (word.empty() && has_channel && !fields.Has("kind", false)) word = "field";
  const auto* const found = std::find_if(kMetricKinds.begin(), kMetricKinds.end(),
                                         [&](const auto& each) { return each.first == word; });
  if (found == kMetricKinds.end()) {
    fields.SkipRest();  // Which keys are right depends on the kind.
    return spec;
  }
  spec.kind = found->second;
  ReadKeysOfKind(fields, &spec);
  return spec;
}

}  // namespace

void ReadMetrics(const Value& table, Problems& problems, std::vector<MetricSpec>* metrics) {
  metrics->clear();
  const auto* entries = std::get_if<Table>(&table.data);
  if (entries == nullptr) {
    problems.Add(table.place, "metrics must be a table like [metrics], not " + WhatIs(table));
    return;
  }
  if (entries->size() > kMaxMetrics) {
    problems.Add(table.place,
                 fmt::format("[metrics] has {} metrics; {} at most", entries->size(), kMaxMetrics));
    return;
  }
  for (const Entry& entry : *entries) {
    if (std::string problem = MetricNameProblem(entry.key); !problem.empty()) {
      problems.Add(entry.key_place, std::move(problem));
    }
    metrics->push_back(ReadMetric(entry, problems));
  }
  std::sort(metrics->begin(), metrics->end(),
            [](const MetricSpec& a, const MetricSpec& b) { return a.name < b.name; });
}

}  // namespace shoal
