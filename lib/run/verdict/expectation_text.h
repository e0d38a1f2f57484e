// Describes in words what a mission must achieve.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lib/mission/model/mission.h"

namespace shoal {

/// Returns one line: "alpha within 20 m of its return point by 600 s". A time limit of 0 is the
/// mission's duration.
[[nodiscard]] std::string Describe(const Mission& mission, const Expectation& expectation);

/// Returns the unit of the number that decides: "m", "s", "%", "laps"; empty: a count, a score, or
/// 1 for met and 0 for missed.
[[nodiscard]] std::string_view UnitOf(const Expectation& expectation);

/// Returns by how much `value`, the number that decided, is on the good side of the limit;
/// negative: beyond it. Of two limits the nearer counts. Absent where there is no number, or no
/// limit for it.
[[nodiscard]] std::optional<double> MarginOf(const Mission& mission, const Expectation& expectation,
                                             std::optional<double> value);

/// Returns the time that a limit in an expectation means: 0 is the end of the mission.
[[nodiscard]] double LimitSeconds(const Mission& mission, double by_s);

}  // namespace shoal
