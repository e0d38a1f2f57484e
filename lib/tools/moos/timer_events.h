// What a post of uTimerScript is in a mission file.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/tools/moos/import_timer.h"

namespace shoal {

/// Keys of an [[event]], with their values in TOML.
using EventKeys = std::vector<std::pair<std::string, std::string>>;
/// These, or the reason why there are none.
using ConvertedEvent = std::variant<EventKeys, std::string>;

/// The reason of a post that loses nothing.
inline constexpr std::string_view kOnlyDraws = "only draws: the viewer has a way of its own";

inline constexpr std::string_view kOnlySounds = "is only a sound";

/// Returns what the post of `value` to the variable `posted` is. The other arguments are those of
/// ReadTimerScript.
[[nodiscard]] ConvertedEvent ConvertEvent(const std::string& posted, const std::string& value,
                                          std::string_view vehicle,
                                          std::span<const std::string> vehicles,
                                          const HasMoosVariable& has_variable,
                                          const FindMoosBridge& find_bridge);

}  // namespace shoal
