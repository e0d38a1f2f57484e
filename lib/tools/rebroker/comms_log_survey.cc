#include "lib/tools/rebroker/comms_log_survey.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {
/// A broker that starts in the midst waits this long for the controls (shore_broker_app.cc).
constexpr int64_t kHold_us = 1'000'000;
}  // namespace

void FindStarts(std::span<const CommsLogItem> items, CommsLog* log) {
  constexpr int64_t kNotAsked = -2 * kLatest_us;
  int64_t asked_utime = kNotAsked;
  std::optional<BrokerRules> any_rules;
  for (const CommsLogItem& item : items) {
    if (item.channel == RequestChannel()) asked_utime = item.utime;
    if (item.channel != RulesChannel()) continue;
    std::optional<BrokerRules> rules = RulesOfItem(*log, item);
    if (!rules) continue;
    if (!any_rules) any_rules = rules;
    if (!rules->is_start) {
      log->rule_changes.push_back(item.utime);
      continue;
    }
    BrokerStart start{.utime = item.utime, .rules_utime = item.utime};
    const bool is_late =
        !log->starts.empty() || (log->time == LogTime::kMission && item.utime > log->first_utime);
    if (item.utime - asked_utime <= 2 * kHold_us) {
      start.utime = asked_utime;
      start.in_the_midst = true;
    } else if (is_late) {
      // Its request was lost, so that no answer came, and it waited to the end.
      const int64_t num_steps = (kHold_us + log->tick_us - 1) / log->tick_us;
      start.utime = StepsLater(item.utime, -num_steps, log->tick_us).value_or(item.utime);
      start.in_the_midst = true;
    }
    asked_utime = kNotAsked;
    if (log->starts.empty()) log->rules = std::move(rules);
    log->starts.push_back(start);
  }
  if (!log->rules) log->rules = std::move(any_rules);
  if (!log->starts.empty() || log->inputs.empty()) return;
  const int64_t utime = log->inputs.front().utime;
  log->starts.push_back({.utime = utime, .rules_utime = utime});
}

void FindGaps(std::span<const CommsLogItem> items, CommsLog* log) {
  struct Run {
    ReportGap gap;
    int64_t last_index = 0;
  };
  std::map<std::string, Run> runs;
  for (const CommsLogItem& item : items) {
    if (item.channel != ReportChannel()) continue;
    const auto report = DecodeItem<node_report_t>(*log, item);
    if (!report || report->index < 0 || !IsLegalVehicleName(report->name)) continue;
    auto [found, is_new] = runs.emplace(VehicleKey(report->name), Run());
    Run& run = found->second;
    if (is_new) run.gap.vehicle = report->name;
    ++run.gap.num_found;
    const int64_t first = is_new || report->index < run.last_index ? 0 : run.last_index + 1;
    // A vehicle that reports to a live broker may have begun long before it.
    const bool may_be_old = is_new && log->time == LogTime::kWall;
    if (report->index > first && !may_be_old) {
      const int64_t missing = report->index - first;
      run.gap.num_missing =
          std::min(run.gap.num_missing, kLatest_us) + std::min(missing, kLatest_us);
    }
    run.last_index = std::min(report->index, std::numeric_limits<int64_t>::max() - 1);
  }
  for (auto& [key, run] : runs) {
    if (run.gap.num_missing > 0) log->gaps.push_back(std::move(run.gap));
  }
}

}  // namespace shoal
