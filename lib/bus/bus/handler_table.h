// The subscriptions of one participant.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"

namespace shoal {

class HandlerTable {
 public:
  /// Returns true for the first subscription to this channel: the transport must listen to it.
  bool Add(const std::string& channel, Bus::Handler handler);
  /// Adds a handler for every channel.
  void AddForAll(Bus::Handler handler);

  bool Wants(std::string_view channel) const {
    return !for_all_.empty() || by_channel_.contains(channel);
  }
  bool empty() const { return for_all_.empty() && by_channel_.empty(); }

  /// Calls the channel's handlers, then those of every channel. Returns how many there were.
  int64_t Call(const Message& message) const;

 private:
  std::map<std::string, std::vector<Bus::Handler>, std::less<>> by_channel_;
  std::vector<Bus::Handler> for_all_;
};

}  // namespace shoal
