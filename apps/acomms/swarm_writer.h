// SWARM_<V>: what a member knows of the others, as a message.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lib/comms/swarm/swarm_receiver.h"
#include "lib/mission/model/mission.h"
#include "shoal/swarm_t.hpp"

namespace shoal {

/// What became of one sender's packets.
struct SourceCounts {
  int64_t received = 0;
  int64_t clean = 0;
  int64_t recovered = 0;
  int64_t rejected = 0;
};

class SwarmWriter {
 public:
  /// Senders that are not in the mission are counted together under this name.
  static constexpr char kOthers[] = "(others)";

  SwarmWriter(const Mission& mission, const Vehicle& vehicle);

  /// Takes note of what became of a packet.
  void Count(const std::string& source, const SwarmReception& reception);

  /// Returns the message for `utime`, but for num_said.
  [[nodiscard]] swarm_t Write(const SwarmReceiver& receiver, int64_t utime) const;

  const std::map<std::string, SourceCounts>& sources() const { return sources_; }

  /// Returns the name of a member; "id 17" where none has the id.
  [[nodiscard]] std::string NameOfId(int64_t id) const;

 private:
  [[nodiscard]] swarm_contact_t WriteContact(const SwarmContact& contact, bool is_target,
                                             int64_t utime) const;

  std::string name_;
  int64_t start_utime_;
  int64_t silent_after_us_;
  std::vector<std::string> vehicles_;  ///< In mission order.
  std::map<uint32_t, std::string> names_;
  std::map<uint32_t, std::vector<std::string>> recovered_;  ///< Of the last message about each.
  std::map<std::string, SourceCounts> sources_;
};

}  // namespace shoal
