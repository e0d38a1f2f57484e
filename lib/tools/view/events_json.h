// Writes what /api/events answers.
#pragma once

#include <span>
#include <string>

#include "lib/tools/view/event_watch.h"

namespace shoal {

/// Returns the events in their order, numbered from 1; times count from `start_utime`.
[[nodiscard]] std::string EventsJson(std::span<const ViewEvent> events, int64_t start_utime);

}  // namespace shoal
