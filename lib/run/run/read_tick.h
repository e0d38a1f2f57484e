// Reads a tick as one process needs it: with the totals of what it waits for, and no others. Of 50
// vessels a tick has some 500 totals, of two texts each, and a process waits for a few of them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>

#include "shoal/tick_t.hpp"

namespace shoal {

/// Returns whether a process waits for what `publisher` published on `channel`.
using WantsTotal = std::function<bool(std::string_view publisher, std::string_view channel)>;

/// Decodes `message`, an encoded tick_t, but for the totals that are not wanted: they are left out,
/// and `num_totals` counts those that are there. Returns false for exactly those bytes for which
/// Decode (lib/bus/bus/bus.h) does; `tick` is undefined then.
[[nodiscard]] bool ReadTick(std::span<const uint8_t> message, const WantsTotal& wants,
                            tick_t* tick);

}  // namespace shoal
