#include "lib/comms/swarm/swarm_field.h"

#include <algorithm>

namespace shoal {

std::string_view NameOf(SwarmField field) { return kSwarmFieldNames[static_cast<size_t>(field)]; }

std::string_view NameOf(RecoveryStrategy strategy) {
  return kRecoveryStrategyNames[static_cast<size_t>(strategy)];
}

std::optional<RecoveryStrategy> RecoveryStrategyOf(std::string_view name) {
  const auto found = std::find(kRecoveryStrategyNames.begin(), kRecoveryStrategyNames.end(), name);
  if (found == kRecoveryStrategyNames.end()) return std::nullopt;
  return static_cast<RecoveryStrategy>(found - kRecoveryStrategyNames.begin());
}

}  // namespace shoal
