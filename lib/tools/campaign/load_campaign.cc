#include "lib/tools/campaign/load_campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/toml/override.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/suggest.h"
#include "lib/mission/toml/table_reader.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/tools/campaign/toml_text.h"
#include "lib/tools/metrics/read_metrics.h"

namespace shoal {

namespace {

constexpr int64_t kMaxRepetitions = 100'000'000;
constexpr int64_t kMaxSteps = 10'000;  ///< Of one range.
constexpr size_t kMaxLooks = 20;
constexpr size_t kMaxCases = 100'000;

constexpr std::array<std::string_view, 7> kTables = {"campaign", "set",     "sweep", "sample",
                                                     "policy",   "metrics", "stop"};
constexpr std::array<std::string_view, 3> kRangeKeys = {"from", "to", "steps"};
constexpr std::array<std::string_view, 4> kDistributions = {"uniform", "integer", "normal",
                                                            "choice"};
constexpr std::array<std::string_view, 2> kSpendings = {"obrien_fleming", "pocock"};

/// A key of a mission with what the campaign file gives for it.
struct KeyValue {
  std::string key;
  Place place;  ///< Of the key.
  const Value* value = nullptr;
};

bool IsBareKey(std::string_view part) {
  return !part.empty() && std::all_of(part.begin(), part.end(),
                                      [](char c) { return IsNameCharacter(c) || c == '-'; });
}

bool HasOnly(const Table& table, std::span<const std::string_view> keys) {
  return !table.empty() && std::all_of(table.begin(), table.end(), [&](const Entry& entry) {
    return std::find(keys.begin(), keys.end(), entry.key) != keys.end();
  });
}

class CampaignReader {
 public:
  CampaignReader(const Value& root, Problems& problems, Campaign* campaign)
      : root_(root), problems_(problems), campaign_(*campaign) {}

  void Read(const std::string& folder) {
    const auto& root = std::get<Table>(root_.data);
    for (const Entry& entry : root) {
      if (std::find(kTables.begin(), kTables.end(), entry.key) == kTables.end()) {
        problems_.Add(entry.key_place, fmt::format("unknown table [{}]{}", entry.key,
                                                   DidYouMean(entry.key, kTables)));
      }
    }
    const Value* campaign = Find(root, "campaign");
    if (campaign == nullptr) {
      problems_.Add({.line = 1, .column = 1},
                    "there is no [campaign]: write [campaign] and mission = \"FILE.toml\"");
    } else {
      ReadCampaignTable(*campaign, folder);
    }
    if (const Value* set = Find(root, "set")) ReadSettings(*set, "[set]", &campaign_.settings);
    if (const Value* sweep = Find(root, "sweep")) ReadSweep(*sweep);
    if (const Value* sample = Find(root, "sample")) ReadSamples(*sample);
    ReadPolicies(Find(root, "policy"));
    campaign_.metrics_table.data = Table();
    if (const Value* metrics = Find(root, "metrics")) {
      campaign_.metrics_table = *metrics;
      ReadMetrics(*metrics, problems_, &campaign_.metrics);
    }
    if (const Value* stop = Find(root, "stop")) ReadStop(*stop);
    CheckNumberOfCases();
  }

 private:
  void ReadCampaignTable(const Value& value, const std::string& folder) {
    TableReader reader(value, "[campaign]", problems_);
    constexpr size_t kLongestPath = 4096;
    constexpr double kLongest_s = 1e7;
    std::string mission;
    auto seed = static_cast<int64_t>(campaign_.seed);
    reader.Require("mission", "mission = \"FILE.toml\"");
    reader.Text("mission", mission, {.min_length = 1, .max_length = kLongestPath});
    reader.Integer("seed", seed, 0, INT64_MAX);
    reader.Integer("repetitions", campaign_.repetitions, 1, kMaxRepetitions);
    reader.Integer("latin_hypercube", campaign_.latin_hypercube, 0, kMaxRepetitions);
    reader.Number("timeout_s", campaign_.timeout_s, Above(0, kLongest_s));
    reader.Number("confidence", campaign_.confidence, Between(0.5, 0.9999));
    campaign_.seed = static_cast<uint64_t>(seed);
    campaign_.mission_file = (std::filesystem::path(folder) / mission).lexically_normal().string();
  }

  /// Returns the leaves below `table` with dotted names: what `is_leaf` accepts, or is not a table.
  std::vector<KeyValue> Leaves(const Table& table, const std::string& prefix,
                               std::span<const std::string_view> leaf_keys) {
    std::vector<KeyValue> leaves;
    for (const Entry& entry : table) {
      // A quoted key may hold a whole path; a part with a dot of its own is in quotes there.
      const std::string key = prefix.empty() ? entry.key : prefix + "." + PartOf(entry.key);
      const auto* below = std::get_if<Table>(&entry.value.data);
      if (below == nullptr || HasOnly(*below, leaf_keys)) {
        leaves.push_back({key, entry.key_place, &entry.value});
        continue;
      }
      std::vector<KeyValue> more = Leaves(*below, key, leaf_keys);
      leaves.insert(leaves.end(), more.begin(), more.end());
    }
    return leaves;
  }

  static std::string PartOf(const std::string& part) {
    return IsBareKey(part) ? part : TomlString(part);
  }

  /// Notes a key that one trial would get from two places, that has not the form of `--set`, or
  /// that is the repetition's.
  bool TakeKey(const KeyValue& item, std::string_view where, bool is_of_policy) {
    Problems of_key("", {item.key});
    if (!ParseOverride(item.key + "=0", 1, of_key)) {
      problems_.Add(item.place,
                    fmt::format("{} is not a key of a mission as --set takes it, such as "
                                "\"comms.comms_range\" or \"vehicle.alpha.speed\"",
                                Quoted(item.key)));
      return false;
    }
    if (item.key == "mission.seed") {
      problems_.Add(item.place,
                    "the seed follows from [campaign] seed and the repetition: leave "
                    "mission.seed out");
      return false;
    }
    const auto [known, is_new] = taken_.emplace(item.key, where);
    if (is_new || (is_of_policy && known->second == where)) return true;
    problems_.Add(item.place, fmt::format("'{}' is in {} as well: a trial would have two values",
                                          item.key, known->second));
    return false;
  }

  const Table* AsTable(const Value& value, std::string_view title) {
    const auto* table = std::get_if<Table>(&value.data);
    if (table == nullptr) {
      problems_.Add(value.place, fmt::format("{} is {}; it must be a table", title, WhatIs(value)));
    }
    return table;
  }

  /// The values of one swept key: a list, or a range.
  std::vector<std::string> SweptValues(const KeyValue& item) {
    std::vector<std::string> values;
    if (const auto* list = std::get_if<Array>(&item.value->data)) {
      for (const Value& value : *list) values.push_back(TomlText(value));
      if (list->empty()) problems_.Add(item.value->place, "an empty list: give at least one value");
      return values;
    }
    if (std::get_if<Table>(&item.value->data) == nullptr) {
      problems_.Add(item.value->place,
                    fmt::format("'{}' is {}; a sweep takes a list, [50, 100], or a range, {{from = "
                                "0, to = 0.4, steps = 5}}; for one value use [policy.NAME]",
                                item.key, WhatIs(*item.value)));
      return values;
    }
    double from = 0;
    double to = 0;
    int64_t steps = 2;
    const size_t num_before = problems_.size();
    {
      constexpr double kMax = 1e300;
      TableReader reader(*item.value, "the range of '" + item.key + "'", problems_);
      reader.Require("from", "from = 0");
      reader.Require("to", "to = 1");
      reader.Require("steps", "steps = 5");
      reader.Number("from", from, Between(-kMax, kMax));
      reader.Number("to", to, Between(-kMax, kMax));
      reader.Integer("steps", steps, 2, kMaxSteps);
    }
    if (problems_.size() > num_before) return values;
    for (int64_t i = 0; i < steps; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(steps - 1);
      values.push_back(RangeValue(i == steps - 1 ? to : from + (to - from) * share));
    }
    return values;
  }

  /// Steps such as 0.1 + 0.2 are written as 0.3: twelve digits. Whole numbers stay integers, which
  /// fit keys of either kind.
  static std::string RangeValue(double number) {
    return TomlNumber(ReadNumber<double>(fmt::format("{:.12g}", number)).value_or(number));
  }

  void ReadSweep(const Value& value) {
    const Table* table = AsTable(value, "[sweep]");
    if (table == nullptr) return;
    Table alone = *table;
    std::erase_if(alone, [](const Entry& entry) { return entry.key == "together"; });
    for (const KeyValue& item : Leaves(alone, "", kRangeKeys)) {
      SweepAxis axis{.keys = {item.key}, .values = {}};
      if (!TakeKey(item, "[sweep]", false)) continue;
      for (std::string& text : SweptValues(item)) axis.values.push_back({std::move(text)});
      if (!axis.values.empty()) campaign_.sweep.push_back(std::move(axis));
    }
    const Value* together = Find(*table, "together");
    if (together == nullptr) return;
    const auto* list = std::get_if<Array>(&together->data);
    if (list == nullptr) {
      problems_.Add(together->place,
                    "keys that vary together are in tables [[sweep.together]], one for each set");
      return;
    }
    for (const Value& each : *list) ReadTogether(each);
  }

  void ReadTogether(const Value& value) {
    const Table* table = AsTable(value, "[[sweep.together]]");
    if (table == nullptr) return;
    SweepAxis axis;
    for (const KeyValue& item : Leaves(*table, "", kRangeKeys)) {
      if (!TakeKey(item, "[[sweep.together]]", false)) continue;
      const std::vector<std::string> texts = SweptValues(item);
      if (texts.empty()) continue;
      if (axis.keys.empty()) axis.values.resize(texts.size());
      if (texts.size() != axis.values.size()) {
        problems_.Add(item.place,
                      fmt::format("'{}' has {} values and '{}' has {}: keys that vary "
                                  "together have the same number",
                                  item.key, texts.size(), axis.keys.front(), axis.values.size()));
        continue;
      }
      axis.keys.push_back(item.key);
      for (size_t i = 0; i < texts.size(); ++i) axis.values[i].push_back(texts[i]);
    }
    if (!axis.keys.empty()) campaign_.sweep.push_back(std::move(axis));
  }

  void ReadSamples(const Value& value) {
    const Table* table = AsTable(value, "[sample]");
    if (table == nullptr) return;
    for (const KeyValue& item : Leaves(*table, "", kDistributions)) {
      const auto* distribution = std::get_if<Table>(&item.value->data);
      const auto* numbers = distribution == nullptr || distribution->size() != 1
                                ? nullptr
                                : std::get_if<Array>(&distribution->front().value.data);
      if (numbers == nullptr) {
        problems_.Add(
            item.value->place,
            fmt::format("'{}' needs one distribution: {{uniform = [FROM, TO]}}, {{integer "
                        "= [FROM, TO]}}, {{normal = [MEAN, STANDARD DEVIATION]}} or "
                        "{{choice = [A, B, ...]}}",
                        item.key));
        continue;
      }
      if (!TakeKey(item, "[sample]", false)) continue;
      ReadDistribution(item, distribution->front(), *numbers);
    }
  }

  void ReadDistribution(const KeyValue& item, const Entry& distribution, const Array& values) {
    SampledKey key{.key = item.key};
    if (distribution.key == "choice") {
      key.kind = SampleKind::kChoice;
      for (const Value& value : values) key.choices.push_back(TomlText(value));
      if (values.empty())
        problems_.Add(distribution.value.place, "choice needs at least one value");
      campaign_.samples.push_back(std::move(key));
      return;
    }
    key.kind = distribution.key == "normal" ? SampleKind::kNormal : SampleKind::kUniform;
    std::vector<double> numbers;
    bool all_integers = true;
    for (const Value& value : values) {
      const auto* integer = std::get_if<int64_t>(&value.data);
      const auto* number = std::get_if<double>(&value.data);
      all_integers &= integer != nullptr;
      if (integer != nullptr) numbers.push_back(static_cast<double>(*integer));
      if (number != nullptr && std::isfinite(*number)) numbers.push_back(*number);
    }
    key.is_integer = distribution.key == "integer";
    if (numbers.size() != 2 || values.size() != 2 || (key.is_integer && !all_integers)) {
      problems_.Add(distribution.value.place,
                    key.kind == SampleKind::kNormal
                        ? "normal = [MEAN, STANDARD DEVIATION] takes two finite numbers"
                        : fmt::format("{} = [FROM, TO] takes two {} numbers", distribution.key,
                                      key.is_integer ? "whole" : "finite"));
      return;
    }
    if (key.kind == SampleKind::kNormal ? numbers[1] < 0 : numbers[1] <= numbers[0]) {
      problems_.Add(distribution.value.place,
                    key.kind == SampleKind::kNormal
                        ? "normal: the standard deviation must not be negative"
                        : distribution.key + " = [FROM, TO]: TO must be larger than FROM");
      return;
    }
    key.first = numbers[0];
    key.second = numbers[1];
    campaign_.samples.push_back(std::move(key));
  }

  /// Policies may set the same key, as only one of them is in force.
  void ReadSettings(const Value& value, const std::string& title, std::vector<Setting>* settings) {
    const Table* table = AsTable(value, title);
    if (table == nullptr) return;
    const bool is_of_policy = title != "[set]";
    for (const KeyValue& item : Leaves(*table, "", {})) {
      if (!TakeKey(item, is_of_policy ? "[policy]" : title, is_of_policy)) continue;
      settings->push_back({item.key, TomlText(*item.value)});
    }
  }

  void ReadPolicies(const Value* value) {
    const Table* table = value == nullptr ? nullptr : AsTable(*value, "[policy]");
    if (table != nullptr) {
      for (const Entry& entry : *table) {
        if (!IsBareKey(entry.key)) {
          problems_.Add(entry.key_place, "a policy's name has letters, digits, _ and -");
        }
        Policy policy{.name = entry.key, .settings = {}};
        ReadSettings(entry.value, "[policy." + entry.key + "]", &policy.settings);
        campaign_.policies.push_back(std::move(policy));
      }
    }
    if (campaign_.policies.empty()) campaign_.policies.emplace_back();
  }

  void ReadStop(const Value& value) {
    StopRule rule;
    std::vector<double> looks;
    TableReader reader(value, "[stop]", problems_);
    reader.Require("half_width", "half_width = 0.01");
    reader.Require("looks", "looks = [200, 500, 1000]");
    constexpr double kWidest = 1e12;
    std::string spending(kSpendings[0]);
    reader.Text("metric", rule.metric, {.min_length = 1, .max_length = 64});
    reader.Number("half_width", rule.half_width, Above(0, kWidest));
    reader.Number("confidence", rule.confidence, Between(0.5, 0.9999));
    reader.Numbers("looks", looks, kMaxLooks);
    reader.Word("spending", spending, kSpendings);
    rule.spending = spending == kSpendings[0] ? Spending::kObrienFleming : Spending::kPocock;
    for (const double look : looks) {
      if (look < 2 || look > static_cast<double>(campaign_.repetitions) ||
          look != std::floor(look) ||
          (!rule.looks.empty() && look <= static_cast<double>(rule.looks.back()))) {
        reader.Refuse("looks", fmt::format("looks are whole numbers that rise, from 2 to the "
                                           "campaign's {} repetitions",
                                           campaign_.repetitions));
        break;
      }
      rule.looks.push_back(static_cast<int64_t>(look));
    }
    campaign_.stop = std::move(rule);
  }

  void CheckNumberOfCases() {
    size_t num_cases = campaign_.policies.size();
    for (const SweepAxis& axis : campaign_.sweep) {
      num_cases *= axis.values.size();
      if (num_cases <= kMaxCases) continue;
      problems_.Add({.line = 1, .column = 1},
                    fmt::format("the sweep has more than {} points with its policies: sample some "
                                "of the keys instead, in [sample]",
                                kMaxCases));
      return;
    }
  }

  const Value& root_;
  Problems& problems_;
  Campaign& campaign_;
  std::map<std::string, std::string> taken_;  ///< Keys, and where they stand.
};

}  // namespace

LoadedCampaign LoadCampaignText(std::string_view text, const std::string& name,
                                const std::string& folder) {
  LoadedCampaign loaded;
  loaded.text = text;
  loaded.campaign.file = name;
  Problems problems(name, {});
  if (const std::optional<Value> root = ParseToml(text, problems)) {
    CampaignReader(*root, problems, &loaded.campaign).Read(folder);
  }
  loaded.errors = problems.InOrder();
  return loaded;
}

LoadedCampaign LoadCampaign(const std::string& path) {
  const FileText file = ReadFile(path);
  if (!file.problem.empty()) {
    Problems problems(path, {});
    problems.Add({}, file.problem);
    LoadedCampaign loaded;
    loaded.errors = problems.InOrder();
    return loaded;
  }
  return LoadCampaignText(file.text, path, std::filesystem::path(path).parent_path().string());
}

}  // namespace shoal
