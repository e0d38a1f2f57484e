// What finds one metric of one trial, from messages and from what the trial's judge knows.
#pragma once

#include <cstdint>
#include <memory>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/verdict/judge.h"
#include "lib/tools/metrics/metric.h"

namespace shoal {

/// The step whose messages are being handled.
struct StepTime {
  int64_t utime = 0;
  double time_s = 0;  ///< Since the mission's start.
};

class MetricWatch {
 public:
  virtual ~MetricWatch() = default;

  /// Subscribes to what it needs beside the judge; nothing by default.
  virtual void Subscribe(Bus& /*bus*/) {}
  /// Called once all messages of a step have been handled, by the judge too.
  virtual void EndStep(const Judge& /*judge*/) {}
  /// Returns the metric, should the mission end now; TrialResult::kNoValue where there is none.
  [[nodiscard]] virtual double Value(const Judge& judge) const = 0;
};

/// Return what finds a metric of each kind; all arguments must outlive it. Vehicles and channels
/// that the mission does not have yield no value.
std::unique_ptr<MetricWatch> WatchDeliveryRatio(const Mission& mission, const MetricSpec& spec);
std::unique_ptr<MetricWatch> WatchInformationAge(const Mission& mission, const MetricSpec& spec,
                                                 const StepTime& now);
std::unique_ptr<MetricWatch> WatchClosestApproach(const Mission& mission, const MetricSpec& spec,
                                                  const StepTime& now);
std::unique_ptr<MetricWatch> WatchFormationError(const Mission& mission, const MetricSpec& spec,
                                                 const StepTime& now);
std::unique_ptr<MetricWatch> WatchDistanceTravelled(const Mission& mission, const MetricSpec& spec);
std::unique_ptr<MetricWatch> WatchArrivalTime(const Mission& mission, const MetricSpec& spec,
                                              const StepTime& now);
std::unique_ptr<MetricWatch> WatchEnergy(const Mission& mission, const MetricSpec& spec,
                                         const StepTime& now);
std::unique_ptr<MetricWatch> WatchField(const Mission& mission, const MetricSpec& spec,
                                        const StepTime& now);

}  // namespace shoal
