// What else a log tells once its messages are in order: who brokered when, and what is missing.
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "lib/analysis/comms_log.h"
#include "lib/routing/vehicle_name.h"

namespace shoal {

namespace {
/// So long does a broker that starts in the midst wait for the controls (shore_broker_app.cc).
constexpr int64_t kHold_us = 1'000'000;
}  // namespace

void CommsLogBuilder::FindStarts() {
  constexpr int64_t kNotAsked = -2 * kLatest_us;
  int64_t asked_utime = kNotAsked;
  std::optional<comms_rules_t> any_rules;
  for (const Item& item : items_) {
    if (item.channel == RequestChannel()) asked_utime = item.utime;
    if (item.channel != RulesChannel()) continue;
    std::optional<comms_rules_t> rules = DecodeItem<comms_rules_t>(item);
    if (!rules) continue;
    if (!any_rules) any_rules = rules;
    if (rules->is_start == 0) {
      log_.rule_changes.push_back(item.utime);
      continue;
    }
    BrokerStart start{.utime = item.utime, .rules_utime = item.utime};
    const bool is_late =
        !log_.starts.empty() || (log_.time == LogTime::kMission && item.utime > log_.first_utime);
    if (item.utime - asked_utime <= 2 * kHold_us) {
      start.utime = asked_utime;
      start.in_the_midst = true;
    } else if (is_late) {
      // What it asked was lost, so that nobody answered, and it waited to the end.
      const int64_t num_steps = (kHold_us + log_.tick_us - 1) / log_.tick_us;
      start.utime = StepsLater(item.utime, -num_steps, log_.tick_us).value_or(item.utime);
      start.in_the_midst = true;
    }
    asked_utime = kNotAsked;
    if (log_.starts.empty()) log_.rules = std::move(rules);
    log_.starts.push_back(start);
  }
  if (!log_.rules) log_.rules = std::move(any_rules);
  if (!log_.starts.empty() || log_.inputs.empty()) return;
  const int64_t utime = log_.inputs.front().utime;
  log_.starts.push_back({.utime = utime, .rules_utime = utime});
}

/// A vehicle counts its reports. One that begins again has been started again.
void CommsLogBuilder::FindGaps() {
  struct Run {
    ReportGap gap;
    int64_t last_index = 0;
  };
  std::map<std::string, Run> runs;
  for (const Item& item : items_) {
    if (item.channel != ReportChannel()) continue;
    const auto report = DecodeItem<node_report_t>(item);
    if (!report || report->index < 0 || !IsLegalVehicleName(report->name)) continue;
    auto [found, is_new] = runs.emplace(VehicleKey(report->name), Run());
    Run& run = found->second;
    if (is_new) run.gap.vehicle = report->name;
    ++run.gap.num_found;
    const int64_t first = is_new || report->index < run.last_index ? 0 : run.last_index + 1;
    // Who reports to a live broker may have begun long before it.
    const bool may_be_old = is_new && log_.time == LogTime::kWall;
    if (report->index > first && !may_be_old) {
      const int64_t missing = report->index - first;
      run.gap.num_missing =
          std::min(run.gap.num_missing, kLatest_us) + std::min(missing, kLatest_us);
    }
    run.last_index = std::min(report->index, std::numeric_limits<int64_t>::max() - 1);
  }
  for (auto& [key, run] : runs) {
    if (run.gap.num_missing > 0) log_.gaps.push_back(std::move(run.gap));
  }
}

}  // namespace shoal
