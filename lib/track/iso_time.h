// Times as logs write them: ISO 8601.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace shoal {

/// Returns the microseconds since 1970 of "2026-11-23T09:30:00.25Z", "2026-11-23 09:30:00+01:00";
/// without an offset it is UTC. Nothing where the text is none, or names a day or an hour that does
/// not exist. Digits beyond microseconds are dropped; a leap second counts as the one after it.
/// Years 1970 to 9999.
[[nodiscard]] std::optional<int64_t> ParseIsoTime(std::string_view text);

}  // namespace shoal
