#include "apps/shoal_log/log_helm.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <ostream>

#include "lib/base/check/result.h"
#include "lib/base/text/letters.h"
#include "lib/base/time/seconds.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/bus/seal.h"
#include "lib/bus/bus/waypoint_arrival.h"
#include "lib/bus/record/log_source.h"
#include "lib/run/run/status_page.h"
#include "lib/tools/analysis/decision_words.h"

namespace shoal {

namespace {

int Fail(std::ostream& err, const std::string& why) {
  err << "shoal: " << why << '\n';
  return kExitUsage;
}

std::string Names(const std::map<std::string, helm_decision_t>& last) {
  std::string names;
  for (const auto& [vehicle, decision] : last) names += (names.empty() ? "" : ", ") + vehicle;
  return names;
}

}  // namespace

int LogHelm(const LogHelmOptions& options, std::ostream& out, std::ostream& err) {
  const OnDamage on_damage = options.skip_damage ? OnDamage::kSkip : OnDamage::kStop;
  std::optional<LogReader> reader = OpenLog(options.path, on_damage, err);
  if (!reader) return kExitEnvironment;
  const std::string wanted = UpperCase(options.vehicle);
  std::map<std::string, helm_decision_t> last;  ///< By vehicle, up to at_s; else shown last.
  std::map<std::string, helm_decision_t> all;   ///< The last of each vehicle, whenever.
  std::map<std::string, helm_state_t> states;   ///< Likewise.
  bool has_arrivals = false;
  int64_t num_undecodable = 0;
  while (const auto event = reader->Next()) {
    const std::string vehicle(VehicleOfChannel(event->channel, topics::kHelmDecision));
    if (vehicle.empty()) {
      const std::string of_state(VehicleOfChannel(event->channel, topics::kHelmState));
      const bool is_wanted = !of_state.empty() && (wanted.empty() || of_state == wanted);
      helm_state_t state{};
      if (options.at_s || !is_wanted) continue;
      if (!Decode(Unseal(event->data).message, &state)) {
        ++num_undecodable;
        continue;
      }
      const std::string arrival = ArrivalText(states[of_state], state);
      states[of_state] = state;
      if (arrival.empty()) continue;
      has_arrivals = true;
      out << fmt::format("{:>10.3f}  {:<12} {}\n", Seconds(state.utime), Printable(state.vehicle),
                         Printable(arrival, kLongestSentence));
      continue;
    }
    helm_decision_t decision{};
    if (!Decode(Unseal(event->data).message, &decision)) {
      ++num_undecodable;
      continue;
    }
    all[vehicle] = decision;
    if (!wanted.empty() && vehicle != wanted) continue;
    if (!options.at_s) {
      const auto shown = last.find(vehicle);
      if (options.only_changes && shown != last.end() && !IsChange(decision, shown->second)) {
        continue;
      }
      last[vehicle] = decision;
      out << DecisionLine(decision) << '\n';
    } else if (Seconds(decision.utime) <= *options.at_s) {
      last[vehicle] = decision;
    }
  }
  const bool is_whole = ReportDamage(*reader, err);
  if (num_undecodable > 0) {
    err << fmt::format("shoal: warning: {}: {} messages do not decode; left out\n", options.path,
                       num_undecodable);
  }
  const int code = is_whole ? kExitOk : kExitEnvironment;
  if (all.empty()) {
    if (!is_whole || has_arrivals) return code;
    return Fail(err, fmt::format("{}: holds no HELM_DECISION_*: helms of vehicles with "
                                 "[[vehicle.behavior]] publish it",
                                 options.path));
  }
  if (!wanted.empty() && !all.contains(wanted) && !has_arrivals) {
    return Fail(err, fmt::format("{}: holds no decision of '{}'; it has those of {}", options.path,
                                 options.vehicle, Names(all)));
  }
  if (!options.at_s) return code;
  if (last.empty()) {
    return Fail(err,
                fmt::format("{}: no decision was made up to {} s", options.path, *options.at_s));
  }
  for (const auto& [vehicle, decision] : last) out << DecisionWords(decision);
  return code;
}

}  // namespace shoal
