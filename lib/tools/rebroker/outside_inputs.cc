#include "lib/tools/rebroker/outside_inputs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "lib/bus/bus/channels.h"
#include "lib/comms/routing/fate.h"
#include "lib/comms/routing/vehicle_name.h"

namespace shoal {

namespace {

/// The broker that received it, kind, source, number.
using TransmissionKey = std::tuple<size_t, std::string, std::string, int64_t>;

/// Returns which of the log's brokers decided at `utime`.
size_t BrokerAt(const CommsLog& log, int64_t utime) {
  size_t broker = 0;
  while (broker + 1 < log.starts.size() && log.starts[broker + 1].utime <= utime) ++broker;
  return broker;
}

/// Returns when the broker decided each transmission.
std::map<TransmissionKey, int64_t> TimesDecided(const CommsLog& log) {
  std::map<TransmissionKey, int64_t> times;
  comms_fates_t message;
  for (const LoggedMessage& fates : log.fates) {
    if (!Decode(log.BytesOf(fates), &message)) continue;
    const size_t broker = BrokerAt(log, fates.utime);
    for (const fate_t& fate : message.fates) {
      // Acoustic traffic was decided when it was sent, a step after it was published.
      const std::optional<int64_t> decided_utime =
          fate.path.empty() ? fates.utime
                            : StepsLater(fate.path.front().sent_utime, 1, log.tick_us);
      if (!decided_utime) continue;  // No mission has such a time.
      times.emplace(TransmissionKey(broker, fate.kind, VehicleKey(fate.source), fate.number),
                    *decided_utime);
    }
  }
  return times;
}

/// Returns kind and source of a report, a message, an ack or a packet.
std::optional<std::pair<Kind, std::string>> SourceOf(const CommsLog& log,
                                                     const LoggedMessage& input) {
  const std::string& channel = BrokerChannels()[input.channel];
  const auto data = log.BytesOf(input);
  if (channel.starts_with(topics::kNodeReport)) {
    node_report_t report;
    if (Decode(data, &report)) return std::pair(Kind::kReport, VehicleKey(report.name));
  } else if (channel.starts_with(topics::kNodeMessage)) {
    node_message_t message;
    if (Decode(data, &message)) return std::pair(Kind::kMessage, VehicleKey(message.src_node));
  } else if (channel == channels::AckMessage().name) {
    ack_message_t ack;
    if (Decode(data, &ack)) return std::pair(Kind::kAck, VehicleKey(ack.src_node));
  } else if (channel == channels::AcousticTx().name) {
    acoustic_tx_t packet;
    if (Decode(data, &packet)) return std::pair(Kind::kPacket, VehicleKey(packet.source));
  } else if (channel == channels::AcousticTxOn().name) {
    acoustic_tx_on_t packet;
    if (Decode(data, &packet)) return std::pair(Kind::kPacket, VehicleKey(packet.source));
  } else if (channel == channels::ModemTx().name) {
    modem_tx_t packet;
    if (Decode(data, &packet)) return std::pair(Kind::kPacket, VehicleKey(packet.source));
  }
  return std::nullopt;
}

/// Moves `input` to `utime` where that is the step before or after its own.
bool Move(LoggedMessage* input, int64_t utime, int64_t tick_us) {
  if (utime != input->utime - tick_us && utime != input->utime + tick_us) return false;
  input->utime = utime;
  return true;
}

int64_t MoveTransmissions(CommsLog* log) {
  const std::map<TransmissionKey, int64_t> decided = TimesDecided(*log);
  std::map<std::tuple<size_t, Kind, std::string>, int64_t> counts;
  int64_t num_moved = 0;
  for (LoggedMessage& input : log->inputs) {
    const auto source = SourceOf(*log, input);
    if (!source) continue;
    const auto& [kind, name] = *source;
    const size_t broker = BrokerAt(*log, input.utime);
    const int64_t number = counts[{broker, kind, name}]++;
    const auto found =
        decided.find(TransmissionKey(broker, std::string(KindText(kind)), name, number));
    if (found != decided.end() && Move(&input, found->second, log->tick_us)) ++num_moved;
  }
  return num_moved;
}

/// A control changes the rules in the step in which it is handled.
int64_t MoveControls(CommsLog* log) {
  const std::set<int64_t> changes(log->rule_changes.begin(), log->rule_changes.end());
  const auto is_control = [](const LoggedMessage& input) {
    return FindControlOnChannel(BrokerChannels()[input.channel]) != nullptr;
  };
  std::set<int64_t> explained;
  for (const LoggedMessage& input : log->inputs) {
    if (is_control(input)) explained.insert(input.utime);
  }
  int64_t num_moved = 0;
  for (LoggedMessage& input : log->inputs) {
    if (!is_control(input) || changes.contains(input.utime)) continue;
    for (const int64_t utime : {input.utime - log->tick_us, input.utime + log->tick_us}) {
      if (!changes.contains(utime) || explained.contains(utime)) continue;
      input.utime = utime;
      explained.insert(utime);
      ++num_moved;
      break;
    }
  }
  return num_moved;
}

}  // namespace

int64_t MoveToTheStepsOfTheBroker(CommsLog* log) {
  if (log->time != LogTime::kMission || !log->gaps.empty()) return 0;
  const int64_t num_moved = MoveTransmissions(log) + MoveControls(log);
  std::stable_sort(
      log->inputs.begin(), log->inputs.end(),
      [](const LoggedMessage& a, const LoggedMessage& b) { return a.utime < b.utime; });
  return num_moved;
}

}  // namespace shoal
