// What a ping of a forward-looking sonar saw, turned from the body's axes into the world's.
#pragma once

#include <vector>

#include "lib/vehicle/guidance/surroundings.h"
#include "shoal/nav_t.hpp"
#include "shoal/sonar_t.hpp"

namespace shoal {

/// Seconds for which a ping counts.
inline constexpr double kSonarMemory_s = 1;

/// Returns the echoes of `ping` as seen with the attitude of `own`: none where it is too old.
/// Invalid ones are passed over.
[[nodiscard]] std::vector<SonarEcho> EchoesOf(const sonar_t& ping, const nav_t& own);

}  // namespace shoal
