// Keeps near the mean of its last headings.
#pragma once

#include <string_view>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "memory_turn_limit". Keeps near the mean of its last headings.
struct MemoryTurnLimitOptions {
  static constexpr std::string_view kKind = "memory_turn_limit";

  double memory_time = 0;  ///< s; > 0.
  double turn_range = 0;   ///< Degrees; > 0.

  bool operator==(const MemoryTurnLimitOptions&) const = default;
};

}  // namespace shoal
