#include "sim/run_trial.h"

#include "lib/tools/metrics/trial_result.h"
#include "lib/tools/metrics/trial_watch.h"
#include "sim/director_app.h"
#include "sim/simulation.h"

namespace shoal {

TrialResult RunTrial(const Mission& mission, std::span<const MetricSpec> metrics,
                     const std::function<void(int64_t step)>& progress,
                     const std::string& log_path) {
  constexpr int64_t kStepsBetweenChecks = 100;  // Of a fault of an app: each is asked.
  TrialWatch watch(mission, metrics);
  Simulation simulation(mission, log_path);
  watch.Subscribe(simulation.bus());
  std::string fault = simulation.Fault();
  const Judge& judge = simulation.director().judge();
  while (fault.empty() && simulation.Step()) {
    // A step handles the messages of the one before.
    if (simulation.step() > 0) watch.EndStep(judge);
    if (progress) progress(simulation.step());
    if (simulation.step() % kStepsBetweenChecks == 0) fault = simulation.Fault();
  }
  if (fault.empty()) fault = simulation.Fault();
  if (!fault.empty()) return {.outcome = TrialOutcome::kError, .why = fault, .metrics = {}};
  watch.EndStep(judge);
  return ResultOf(mission, judge, watch);
}

}  // namespace shoal
