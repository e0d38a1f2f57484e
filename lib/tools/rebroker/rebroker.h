// Decides again what a log's broker decided, by the same rules or by others.
//
//   RebrokerOutcome outcome = Rebroker(log, {.setup = *SetupOf(*log.rules)}, make_broker, nullptr);
//   print(outcome.comparison.num_reproduced(), outcome.links.Text(50));
//
// The broker, which `make_broker` makes, is on a bus in memory. It is given what the recorded one
// received, in the order and at the times at which that one handled it. Where the recorded broker
// was started again, a new one takes over, which knows no vehicle yet.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/run/broker/broker.h"
#include "lib/tools/rebroker/comms_log.h"
#include "lib/tools/rebroker/decision_comparison.h"
#include "lib/tools/rebroker/link_table.h"

namespace shoal {

/// A time in which the recorded broker published nothing, before another was started or to the
/// log's end.
struct BrokerAbsence {
  int64_t after_utime = 0;    ///< Of its last decision.
  int64_t before_utime = 0;   ///< Of the new one's first step.
  bool to_the_end = false;    ///< No other was started; before_utime is behind the last step.
  int64_t num_decisions = 0;  ///< That would have been made; they are counted nowhere else.
};

struct RebrokerSettings {
  BrokerSetup setup;          ///< At the mission's start; start_utime is not asked for.
  bool with_controls = true;  ///< Recorded messages on UNC_* change the rules.
  /// The times whose decisions are counted apart: AbsencesIn(log).
  std::vector<BrokerAbsence> absences = {};
};

struct RebrokerOutcome {
  LinkTable links;  ///< Recorded and now.
  DecisionComparison comparison{SameDecision::kWhole};
  std::vector<BrokerAbsence> absences;  ///< Those that cost decisions.
  int64_t num_too_early = 0;            ///< Inputs published before the first broker began.
  int64_t num_undecodable = 0;          ///< Recorded COMMS_FATES.
};

/// Takes the events of a new log, in its order.
using EventSink =
    std::function<void(int64_t utime, std::string_view channel, std::span<const uint8_t> data)>;

/// Returns the times in which the recorded broker may have been away. None where it left no
/// COMMS_FATES at all.
[[nodiscard]] std::vector<BrokerAbsence> AbsencesIn(const CommsLog& log);

/// Runs the broker. `sink`, where given, takes what the broker was given and what it published as
/// a log of mission time in the fixed order, from which Rebroker decides the same.
RebrokerOutcome Rebroker(const CommsLog& log, const RebrokerSettings& settings,
                         const MakeBroker& make_broker, const EventSink& sink);

}  // namespace shoal
