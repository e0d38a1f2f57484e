// Finds the metrics of one trial: the numbers of its mission's expectations, and those that the
// campaign file asks for.
//
//   TrialWatch watch(mission, campaign.metrics);
//   watch.Subscribe(simulation.bus());           // before the first step
//   ... once the messages of a step have been handled, and its end judged:
//   watch.EndStep(judge);
//   const std::vector<double> values = watch.Values(judge);   // in the order of Names
//
// sim/run_trial.h does this for a simulation, sim/judge_log.h for a log. It only subscribes: the
// mission and its log are the same with and without it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/verdict/judge.h"
#include "lib/tools/metrics/metric.h"
#include "lib/tools/metrics/metric_watch.h"

namespace shoal {

class TrialWatch {
 public:
  /// `mission` must outlive this; `metrics` need not. Vehicles and channels that the mission does
  /// not have yield no value: CheckMetrics finds them.
  TrialWatch(const Mission& mission, std::span<const MetricSpec> metrics);
  TrialWatch(const TrialWatch&) = delete;
  TrialWatch& operator=(const TrialWatch&) = delete;

  /// Returns the names of all values: expect_1, expect_2, ... in the mission's order, then
  /// `metrics` by name.
  [[nodiscard]] static std::vector<MetricName> Names(const Mission& mission,
                                                     std::span<const MetricSpec> metrics);

  /// Subscribes to the channels that the metrics need, and to no other. The bus and this are used
  /// for one mission.
  void Subscribe(Bus& bus);

  /// Ends a step, from the first one on: all its messages have been handled, and `judge` has taken
  /// them and ended the step too.
  void EndStep(const Judge& judge);

  /// Returns the values, should the mission end now; TrialResult::kNoValue where there is none.
  [[nodiscard]] std::vector<double> Values(const Judge& judge) const;

 private:
  const Mission& mission_;
  std::vector<MetricSpec> metrics_;  ///< By name.
  StepTime now_;
  std::vector<std::unique_ptr<MetricWatch>> watches_;  ///< Of metrics_.
};

}  // namespace shoal
