// What a log shows of a mission's communication: all that the broker received, in the order in
// which it handled it, and what it decided.
//
//   CommsLogBuilder builder;
//   while (const auto event = reader.Next()) builder.Add(*event);
//   CommsLog log = builder.Build();
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/time/time_units.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/log_format.h"
#include "lib/run/broker/broker_rules.h"

namespace shoal {

/// Where the times of a log come from.
enum class LogTime {
  kMission,  ///< shoal's own recording: events have mission time and are in the fixed order.
  kSeals,    ///< lcm-logger's, of a mission: steps and order are restored from the seals.
  kWall,     ///< lcm-logger's, of a live broker: messages are handled as they came.
};

/// A message for the broker, or COMMS_FATES.
struct LoggedMessage {
  int64_t utime = 0;    ///< When the broker handled it; of COMMS_FATES: when it was published.
  uint8_t channel = 0;  ///< Into BrokerChannels().
  size_t begin = 0;     ///< Of its bytes, in CommsLog::bytes.
  size_t size = 0;
};

/// Where a vehicle was in truth: its NAV_<V>.
struct LoggedTruth {
  int64_t utime = 0;     ///< When the broker handled it.
  uint32_t vehicle = 0;  ///< Into CommsLog::truth_channels.
  size_t begin = 0;      ///< Of its bytes, in CommsLog::bytes.
  size_t size = 0;
};

/// A broker that began to work.
struct BrokerStart {
  int64_t utime = 0;          ///< Of its first step.
  int64_t rules_utime = 0;    ///< When it published COMMS_RULES and so began to decide.
  bool in_the_midst = false;  ///< It asked for the controls that it had missed.
};

/// How many of a vehicle's reports a log holds, and how many are missing by its index.
struct ReportGap {
  std::string vehicle;
  int64_t num_found = 0;
  int64_t num_missing = 0;
};

struct CommsLog {
  LogTime time = LogTime::kMission;
  int64_t tick_us = 100'000;
  bool tick_is_guessed = false;
  std::vector<LoggedMessage> inputs;        ///< As the broker handled them.
  std::vector<LoggedMessage> fates;         ///< As they were published.
  std::vector<LoggedTruth> truths;          ///< As the broker handled them, where it is given them.
  std::vector<std::string> truth_channels;  ///< NAV_<V>, of all vehicles in the log.
  std::vector<BrokerStart> starts;          ///< One at least, unless there are no inputs.
  std::vector<int64_t> rule_changes;        ///< When COMMS_RULES was published again, for a change.
  std::optional<BrokerRules> rules;  ///< The broker's at its first start; or the first that are.
  int64_t first_utime = 0;           ///< Of all events.
  int64_t last_utime = 0;            ///< No step is later.
  int64_t num_events = 0;            ///< On all channels.

  std::vector<ReportGap> gaps;  ///< Of vehicles whose reports are missing.
  int64_t num_backward = 0;     ///< Events earlier than the one before.
  int64_t num_repeated = 0;     ///< Left out: published again, or in two logs.
  int64_t num_foreign = 0;      ///< Left out: of another mission.
  int64_t num_impossible = 0;   ///< Left out: with a time that no mission has.
  int64_t num_unsealed = 0;     ///< kSeals: inputs from outside, whose step is not certain.

  Bytes bytes;

  std::span<const uint8_t> BytesOf(const LoggedMessage& message) const {
    return std::span(bytes).subspan(message.begin, message.size);
  }
  std::span<const uint8_t> BytesOf(const LoggedTruth& truth) const {
    return std::span(bytes).subspan(truth.begin, truth.size);
  }
};

/// The channels that a broker subscribes to and that matter here, then the three that it publishes
/// and that are compared: COMMS_FATES, COMMS_RULES, UNC_CONTROLS_REQ.
const std::vector<std::string>& BrokerChannels();
/// How many of them it subscribes to.
size_t NumBrokerInputs();
/// Return the places of these: COMMS_FATES, COMMS_RULES, UNC_CONTROLS_REQ, NODE_REPORT_LOCAL.
size_t FatesChannel();
size_t RulesChannel();
size_t RequestChannel();
size_t ReportChannel();

/// Stands for NAV_<V> of all vehicles: no place of BrokerChannels().
size_t TruthChannel();

/// Returns the time that is `steps` steps later, or nothing where no mission has it.
[[nodiscard]] std::optional<int64_t> StepsLater(int64_t utime, int64_t steps, int64_t tick_us);

/// A message as it was gathered, before its time and place are known.
struct CommsLogItem {
  int64_t utime = 0;       ///< Of the event; later: when it was published.
  int64_t mission_id = 0;  ///< This and the next two: of its seal.
  int64_t step = 0;        ///< Unsealed: of the last seal before it.
  uint32_t sequence = 0;
  uint32_t publisher = 0;  ///< The builder's number of its name; 0: from outside, without a seal.
  uint8_t channel = 0;     ///< Into BrokerChannels(), or TruthChannel().
  uint32_t vehicle = 0;    ///< Of TruthChannel(): into CommsLog::truth_channels.
  size_t begin = 0;
  size_t size = 0;
};

/// Returns the item's message, nothing where it is not of this type.
template <class T>
[[nodiscard]] std::optional<T> DecodeItem(const CommsLog& log, const CommsLogItem& item) {
  T message{};
  if (!Decode(std::span(log.bytes).subspan(item.begin, item.size), &message)) return std::nullopt;
  return message;
}

/// Returns the item's rules, of any version's log.
[[nodiscard]] std::optional<BrokerRules> RulesOfItem(const CommsLog& log, const CommsLogItem& item);

class CommsLogBuilder {
 public:
  /// What follows comes from another log. Not needed before the first.
  void BeginLog();
  void Add(const LogEvent& event);

  /// Returns what was added. `tick_us` is taken where the log does not show it.
  CommsLog Build(std::optional<int64_t> tick_us = std::nullopt);

 private:
  std::optional<int64_t> UtimeOf(const CommsLogItem& item) const;
  std::optional<int64_t> StepUtimeOf(const CommsLogItem& item) const;
  uint32_t TruthPlaceOf(const std::string& channel);
  LogTime KindOfTime() const;
  void TakeTick(std::optional<int64_t> tick_us);
  void RestoreSteps();
  void GatherRounds();
  void DropRepeated();

  CommsLog log_;
  std::vector<CommsLogItem> items_;
  bool has_words_of_broker_ = false;
  std::map<std::string, uint32_t, std::less<>> publishers_;
  std::map<std::string, uint32_t, std::less<>> truth_places_;  ///< Into truth_channels.
  std::optional<int64_t> previous_utime_;  ///< Of the event before, in the same log.
  int64_t smallest_gap_us_ = 0;            ///< Between different times of events; 0: not known.
  int64_t latest_step_ = 0;
  std::map<int64_t, int64_t> last_steps_;  ///< By mission.
};

}  // namespace shoal
