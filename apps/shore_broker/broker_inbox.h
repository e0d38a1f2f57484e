// What one step brings to the broker, kept until it is decided. The bytes of all messages lie in
// one arena.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/run/run/status_page.h"

namespace shoal {

class BrokerInbox {
 public:
  /// What a packet came as.
  enum class Packet { kAcousticTx, kAcousticTxOn, kModemTx };
  struct Item {
    size_t begin = 0;
    size_t size = 0;
    bool from_outside = false;  ///< Came on the channel of vehicles from outside.
    Packet packet = Packet::kAcousticTx;
  };

  enum class Takes { kAll, kReports };

  /// Subscribes to reports, and to messages, acks, what gateways forward, packets and commands
  /// where it takes all. Both must outlive this.
  BrokerInbox(Takes takes, Bus& bus, StatusLog* log);
  BrokerInbox(const BrokerInbox&) = delete;
  BrokerInbox& operator=(const BrokerInbox&) = delete;

  std::span<const uint8_t> BytesOf(const Item& item) const {
    return std::span(arena_).subspan(item.begin, item.size);
  }

  /// Decodes an item, or counts and warns.
  template <class T>
  bool Read(const Item& item, const Channel<T>& channel, T* message) {
    if (Decode(BytesOf(item), message)) return true;
    bus_.CountUndecodable(channel.name);
    log_.Warn(channel.name + ": undecodable bytes dropped");
    return false;
  }

  // In the order in which they came:
  const std::vector<Item>& reports() const { return reports_; }
  const std::vector<Item>& messages() const { return messages_; }
  const std::vector<Item>& acks() const { return acks_; }
  const std::vector<Item>& relays() const { return relays_; }
  const std::vector<Item>& packets() const { return packets_; }
  const std::vector<Item>& commands() const { return commands_; }

  /// Commands do not wait for the others.
  void ClearCommands() { commands_.clear(); }
  /// Drops all else.
  void Clear();

 private:
  /// Appends what comes on the channel to the list, as `kind` has it.
  void Keep(const std::string& channel, const Item& kind, std::vector<Item>* list);

  Bus& bus_;
  StatusLog& log_;
  Bytes arena_;
  std::vector<Item> reports_;
  std::vector<Item> messages_;
  std::vector<Item> acks_;
  std::vector<Item> relays_;
  std::vector<Item> packets_;
  std::vector<Item> commands_;
};

}  // namespace shoal
