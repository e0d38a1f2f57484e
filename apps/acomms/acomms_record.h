// ACOMMS_<V>: what befell a vehicle's messages of the swarm, beside what SWARM_<V> has of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/acomms/swarm_writer.h"
#include "lib/bus/bus/bus.h"
#include "lib/comms/swarm/swarm_receiver.h"
#include "shoal/acomms_t.hpp"

namespace shoal {

class AcommsRecord {
 public:
  /// @pre `names` outlives it.
  AcommsRecord(std::string_view vehicle, const SwarmWriter& names)
      : vehicle_(vehicle), names_(names) {}

  /// Takes note of what became of a packet. Returns an event's line for each field that was
  /// recovered, or for the message that was rejected.
  std::vector<std::string> Note(const std::string& source, const SwarmReception& reception,
                                int64_t utime);

  /// Returns the message of a step in which something changed, with the events since the last.
  [[nodiscard]] std::optional<acomms_t> TakeChange(const SwarmReceiver& receiver,
                                                   int64_t num_without_nav, int64_t num_missed,
                                                   int64_t utime);

 private:
  [[nodiscard]] acomms_member_t MemberOf(const SwarmContact& contact,
                                         const FrameCounts& frames) const;

  std::string vehicle_;
  const SwarmWriter& names_;
  std::vector<acomms_event_t> events_;  ///< Since the last message.
  Bytes last_;                          ///< The last message without time and events.
};

}  // namespace shoal
