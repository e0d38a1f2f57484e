#include "lib/swarm/swarm_field.h"

#include <algorithm>

namespace shoal {

namespace {

template <class Word, size_t n>
std::optional<Word> WordOf(std::string_view name, const std::array<std::string_view, n>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Word>(found - names.begin());
}

}  // namespace

std::string_view NameOf(SwarmField field) { return kSwarmFieldNames[static_cast<size_t>(field)]; }

std::string_view NameOf(RecoveryStrategy strategy) {
  return kRecoveryStrategyNames[static_cast<size_t>(strategy)];
}

std::optional<SwarmField> SwarmFieldOf(std::string_view name) {
  return WordOf<SwarmField>(name, kSwarmFieldNames);
}

std::optional<RecoveryStrategy> RecoveryStrategyOf(std::string_view name) {
  return WordOf<RecoveryStrategy>(name, kRecoveryStrategyNames);
}

}  // namespace shoal
