#include "lib/bus/bus/bus.h"

namespace shoal {

void Bus::CountUndecodable(std::string_view channel) {
  ++counters_.undecodable;
  // An outside program may invent any number of channel names; the app's own subscriptions are few.
  const auto found = counters_.undecodable_by_channel.find(channel);
  if (found != counters_.undecodable_by_channel.end()) {
    ++found->second;
  } else if (counters_.undecodable_by_channel.size() < 1000) {
    counters_.undecodable_by_channel.emplace(std::string(channel), 1);
  }
}

}  // namespace shoal
