// A campaign as data: one mission, asked many times over. docs/campaigns/campaigns.md documents
// each key.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/mission/toml/value.h"
#include "lib/tools/metrics/metric.h"

namespace shoal {

/// One key of a mission and a value for it, as `--set` takes them.
struct Setting {
  std::string key;    ///< "comms.comms_range".
  std::string value;  ///< As TOML writes it: "250", "\"nolimit\"".

  [[nodiscard]] std::string AsOverride() const { return key + "=" + value; }
  bool operator==(const Setting&) const = default;
};

/// Keys that are swept together: in step i each has its i-th value. Most axes have one key.
struct SweepAxis {
  std::vector<std::string> keys;
  std::vector<std::vector<std::string>> values;  ///< By step, then by key.
};

enum class SampleKind { kUniform, kNormal, kChoice };

/// A key that is drawn again for each repetition, the same in all cases.
struct SampledKey {
  std::string key;
  SampleKind kind = SampleKind::kUniform;
  double first = 0;                       ///< Uniform: from. Normal: the mean.
  double second = 0;                      ///< Uniform: to. Normal: the standard deviation.
  bool is_integer = false;                ///< Of kUniform: whole numbers, both ends included.
  std::vector<std::string> choices = {};  ///< As TOML writes them.
};

/// Sets of settings to compare.
struct Policy {
  std::string name;  ///< Empty: the campaign has none.
  std::vector<Setting> settings;
};

/// How the error probability is spent over the looks (Lan and DeMets 1983).
enum class Spending { kObrienFleming, kPocock };

/// `[stop]`: when a case needs no more repetitions. It is looked at after the first looks[i]
/// repetitions of a case, in the order of their numbers, and at no other time.
struct StopRule {
  std::string metric = "pass";  ///< Or a metric's name: its mean.
  double half_width = 0.01;     ///< Enough: the interval is this narrow.
  double confidence = 0.95;
  std::vector<int64_t> looks;  ///< Rising; the last is the campaign's repetitions at most.
  Spending spending = Spending::kObrienFleming;
};

struct Campaign {
  std::string file;          ///< As it was given, for messages.
  std::string mission_file;  ///< A path that can be opened.
  uint64_t seed = 1;
  int64_t repetitions = 100;
  int64_t latin_hypercube = 0;  ///< Repetitions in a block of the Latin hypercube; 0: plain draws.
  double timeout_s = 60;        ///< Of wall time, for one trial.
  double confidence = 0.95;     ///< Of the report's intervals.
  std::vector<Setting> settings;  ///< `[set]`: of every trial.
  std::vector<SweepAxis> sweep;
  std::vector<SampledKey> samples;
  std::vector<Policy> policies;     ///< One without a name where the file has none.
  std::vector<MetricSpec> metrics;  ///< As they are written: Plan has them checked.
  Value metrics_table;              ///< What `metrics` was read from, for messages about it.
  std::optional<StopRule> stop;
};

}  // namespace shoal
