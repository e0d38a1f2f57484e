// Messages of [[event]] that no medium on their way can carry.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/base/text/letters.h"
#include "lib/mission/file/load_media.h"
#include "lib/mission/file/task_way.h"
#include "lib/mission/file/validate.h"

namespace shoal {

namespace {

constexpr int64_t kAnyLength = std::numeric_limits<int64_t>::max();

/// Returns how long the message is on the air at least (its text in MOOS's form): gateways add
/// their names, and characters may need quotes.
int64_t LeastLength_bytes(const MessageEvent& message, double at_s) {
  int64_t length_bytes = -1;  // Fields are parted by commas.
  const auto add = [&](std::string_view key, std::string_view value) {
    if (!value.empty()) length_bytes += std::ssize(key) + std::ssize(value) + 2;
  };
  add("src_node", message.src_node);
  add("src_app", "shoal");
  add("dest_node", message.dest_node);
  add("dest_group", message.dest_group);
  add("var_name", message.var_name);
  add(message.double_val ? "double_val" : "string_val",
      message.double_val ? fmt::format("{}", *message.double_val) : message.string_val);
  if (message.ack) {
    add("ack", "true");
    add("ack_id", fmt::format("{}-{:.0f}-0", message.src_node, std::floor(1000 * at_s)));
  }
  return length_bytes;
}

/// The media of a mission, and where a message of some length gets over them.
class MessageWays {
 public:
  explicit MessageWays(const Mission& mission) : mission_(mission), media_(MediaOf(mission)) {}

  /// Returns the vehicles that a message of this length can reach from `source`, by gateways too,
  /// at any range, and where those that dive are under water.
  std::set<const Vehicle*> ReachedBy(const Vehicle& source, int64_t length_bytes) const {
    std::set<const Vehicle*> reached;
    std::vector<std::pair<const Vehicle*, std::vector<std::string>>> senders;
    const MediaChoice& over = mission_.comms.messages_over;
    senders.emplace_back(&source,
                         over.is_direct() ? std::vector<std::string>{"direct"} : over.names);
    std::set<const Vehicle*> forwarded = {&source};
    while (!senders.empty()) {
      const auto [sender, names] = senders.back();
      senders.pop_back();
      for (const std::string& name : names) {
        if (length_bytes > LimitOf(name) || !Has(*sender, name)) continue;
        for (const Vehicle& receiver : mission_.vehicles) {
          if (&receiver == sender || !Has(receiver, name)) continue;
          reached.insert(&receiver);
          const GatewayOptions& gateway = receiver.media.gateway;
          const bool goes_on = gateway.exists && gateway.messages &&
                               std::ranges::find(gateway.from, name) != gateway.from.end();
          if (goes_on && forwarded.insert(&receiver).second) {
            senders.emplace_back(&receiver, gateway.to);
          }
        }
      }
    }
    return reached;
  }

  /// Returns the most that a packet of any medium with such a limit holds, and the medium; nothing
  /// where none has a limit.
  std::optional<std::pair<int64_t, std::string>> LargestLimit() const {
    std::optional<std::pair<int64_t, std::string>> largest;
    for (const std::string& name : media_.Names()) {
      const int64_t limit_bytes = LimitOf(name);
      const bool counts = limit_bytes < kAnyLength && (!largest || limit_bytes > largest->first);
      if (counts) largest = {limit_bytes, name};
    }
    return largest;
  }

 private:
  /// Radio counts for what stays at the surface alone.
  bool Has(const Vehicle& vehicle, std::string_view medium) const {
    if (medium == kDirectMedium) return true;
    if (!vehicle.HasMedium(medium)) return false;
    const auto found = std::ranges::find(media_.media, medium, &MediumOptions::name);
    return found == media_.media.end() || found->kind != MediumKind::kRadio ||
           DeepestOf_m(vehicle) <= found->radio.surface_depth_m;
  }

  /// Returns how many bytes a packet of the medium holds.
  int64_t LimitOf(std::string_view name) const {
    const Acoustics* acoustics = name == kAcousticMedium ? &media_.acoustics : nullptr;
    for (const MediumOptions& medium : media_.media) {
      if (medium.name == name && medium.kind == MediumKind::kAcoustic) {
        acoustics = &medium.acoustics;
      }
    }
    if (acoustics == nullptr || !acoustics->options.modem) return kAnyLength;
    const int64_t limit_bytes = acoustics->options.modem->max_packet_bytes;
    return limit_bytes > 0 ? limit_bytes : kAnyLength;
  }

  const Mission& mission_;
  MediaSetup media_;
};

/// Returns true where the message is for the vehicle.
bool IsFor(const MessageEvent& message, const Vehicle& vehicle) {
  const std::string group = LowerCase(message.dest_group);
  if (group == "all" || (!group.empty() && group == LowerCase(vehicle.group))) return true;
  const std::string names = ":" + LowerCase(message.dest_node) + ":";
  return names == ":all:" || names.find(":" + LowerCase(vehicle.name) + ":") != std::string::npos;
}

void WarnOfLength(const Mission& mission, const MessageWays& ways, const Event& event,
                  const TablePlace& place) {
  const auto& message = std::get<MessageEvent>(event.what);
  const int64_t limit_bytes = mission.comms.max_msg_length_bytes;
  if (limit_bytes > 0 && std::ssize(message.string_val) > limit_bytes) {
    place.Warn("string_val",
               fmt::format("string_val has {} bytes, and the broker passes on at most {}: shorten "
                           "it, or raise max_msg_length in [comms]",
                           message.string_val.size(), limit_bytes));
    return;
  }
  const auto source = std::ranges::find_if(mission.vehicles, [&](const Vehicle& vehicle) {
    return LowerCase(vehicle.name) == LowerCase(message.src_node);
  });
  if (source == mission.vehicles.end()) return;
  const int64_t length_bytes = LeastLength_bytes(message, event.at_s);
  const std::set<const Vehicle*> at_any_length = ways.ReachedBy(*source, 0);
  const std::set<const Vehicle*> reached = ways.ReachedBy(*source, length_bytes);
  std::vector<std::string> lost;
  for (const Vehicle& vehicle : mission.vehicles) {
    const bool is_lost = at_any_length.contains(&vehicle) && !reached.contains(&vehicle);
    if (is_lost && IsFor(message, vehicle)) lost.push_back(vehicle.name);
  }
  const auto largest = ways.LargestLimit();
  if (lost.empty() || !largest) return;
  place.Warn(
      message.double_val ? "double_val" : "string_val",
      fmt::format(
          "the message cannot reach {} under water: it takes {} bytes or more on the air, and a "
          "packet of {} holds at most {}; shorten names and text, or choose another "
          "modem or medium",
          fmt::join(lost, ", "), length_bytes, largest->second, largest->first));
}

/// Acks that may come when their sender has already repeated the message.
void WarnOfLateAcks(const Mission& mission, const TablePlace& file) {
  for (size_t i = 0; i < mission.vehicles.size(); ++i) {
    const double jitter_s = mission.vehicles[i].message_options.ack_jitter_s;
    for (const Vehicle& sender : mission.vehicles) {
      const double timeout_s = sender.message_options.ack_timeout_s;
      if (&sender == &mission.vehicles[i] || jitter_s < timeout_s) continue;
      file.Below("vehicle", i)
          .Below("messages")
          .Warn("ack_jitter_s",
                fmt::format("its acks may take {:g} s, and {} sends a message again after "
                            "ack_timeout_s = {:g}: write a shorter ack_jitter_s, or a longer "
                            "ack_timeout_s there",
                            jitter_s, sender.name, timeout_s));
      break;
    }
  }
}

}  // namespace

void WarnOfMessages(const Mission& mission, const TablePlace& file) {
  if (!file.IsSound()) return;
  WarnOfLateAcks(mission, file);
  const MessageWays ways(mission);
  for (size_t i = 0; i < mission.events.size(); ++i) {
    if (!std::holds_alternative<MessageEvent>(mission.events[i].what)) continue;
    WarnOfLength(mission, ways, mission.events[i], file.Below("event", i).Below("message"));
  }
}

}  // namespace shoal
