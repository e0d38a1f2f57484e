// Times as the logs of other programs write them: ISO 8601 in its usual forms. What shoal itself
// writes has one form (lib/base/time/utc_time.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace shoal {

/// The Gregorian calendar begins in 1582, and ISO 8601 with the year after it.
inline constexpr int kFirstLoggedYear = 1583;

/// Returns the microseconds since 1970 of "2026-11-23T09:30:00.25Z", "2026-11-23 09:30:00+01:00",
/// "20261123T093000Z", "2026-11-23T09:30"; without an offset it is UTC. Nothing where the text is
/// none, or names a day or an hour that does not exist. Digits beyond microseconds are dropped; a
/// leap second counts as the one after it, 24:00:00 as the next midnight. Years from
/// kFirstLoggedYear to kLastClockYear.
[[nodiscard]] std::optional<int64_t> ParseLoggedTime(std::string_view text);

}  // namespace shoal
