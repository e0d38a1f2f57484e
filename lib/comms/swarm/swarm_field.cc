#include "lib/comms/swarm/swarm_field.h"

namespace shoal {

std::string_view NameOf(SwarmField field) { return kSwarmFieldNames[field]; }

std::string_view NameOf(RecoveryStrategy strategy) { return kRecoveryStrategyNames[strategy]; }

std::optional<RecoveryStrategy> RecoveryStrategyOf(std::string_view name) {
  return kRecoveryStrategyNames.Find(name);
}

}  // namespace shoal
