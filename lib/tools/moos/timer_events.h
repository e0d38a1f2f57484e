// What a post of uTimerScript is in a mission file.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/tools/moos/import_timer.h"

namespace shoal {

/// Keys of an [[event]], with their values in TOML.
using EventKeys = std::vector<std::pair<std::string, std::string>>;
/// These; or a part of something that several events make; or the reason why there is nothing.
using ConvertedEvent = std::variant<EventKeys, TrackedPoint, DriftChange, std::string>;

/// The reason of a post that loses nothing.
inline constexpr std::string_view kOnlyDraws = "only draws: the viewer has a way of its own";

inline constexpr std::string_view kOnlySounds = "is only a sound";
inline constexpr std::string_view kNothingReads = "no line and no behavior reads it";

/// Returns what the post of `value` to the variable `posted` is.
[[nodiscard]] ConvertedEvent ConvertEvent(const std::string& posted, const std::string& value,
                                          const TimerContext& context);

}  // namespace shoal
