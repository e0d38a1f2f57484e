#include "lib/tools/metrics/trial_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "lib/base/time/seconds.h"
#include "lib/run/verdict/expectation_text.h"
#include "lib/tools/metrics/metric_kinds.h"
#include "lib/tools/metrics/trial.h"

namespace shoal {

namespace {

std::vector<MetricSpec> SortedByName(std::span<const MetricSpec> metrics) {
  std::vector<MetricSpec> sorted(metrics.begin(), metrics.end());
  std::sort(sorted.begin(), sorted.end(),
            [](const MetricSpec& a, const MetricSpec& b) { return a.name < b.name; });
  return sorted;
}

}  // namespace

TrialWatch::TrialWatch(const Mission& mission, std::span<const MetricSpec> metrics)
    : mission_(mission), metrics_(SortedByName(metrics)), now_{.utime = mission.start_utime} {
  for (const MetricSpec& spec : metrics_) {
    watches_.push_back(RowOf(spec.kind).watch(mission, spec, now_));
  }
}

std::vector<MetricName> TrialWatch::Names(const Mission& mission,
                                          std::span<const MetricSpec> metrics) {
  std::vector<MetricName> names;
  for (const Expectation& expectation : mission.expectations) {
    names.push_back({.name = fmt::format("expect_{}", names.size() + 1),
                     .unit = std::string(UnitOf(expectation)),
                     .text = Describe(mission, expectation)});
  }
  for (const MetricSpec& spec : SortedByName(metrics)) {
    names.push_back(
        {.name = spec.name, .unit = UnitOfMetric(spec), .text = DescribeMetric(mission, spec)});
  }
  return names;
}

void TrialWatch::Subscribe(Bus& bus) {
  for (const auto& watch : watches_) watch->Subscribe(bus);
}

void TrialWatch::EndStep(const Judge& judge) {
  for (const auto& watch : watches_) watch->EndStep(judge);
  now_.utime += mission_.tick_us;
  now_.time_s = Seconds(now_.utime - mission_.start_utime);
}

std::vector<double> TrialWatch::Values(const Judge& judge) const {
  std::vector<double> values;
  for (const ExpectationVerdict& verdict : judge.Verdicts()) {
    values.push_back(verdict.value.value_or(TrialResult::kNoValue));
  }
  for (const auto& watch : watches_) values.push_back(watch->Value(judge));
  return values;
}

}  // namespace shoal
