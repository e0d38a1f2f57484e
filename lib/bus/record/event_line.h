// One logged message as one line of text.
#pragma once

#include <string>

#include "lib/base/schema/schema.h"
#include "lib/bus/record/log_format.h"

namespace shoal {

/// Returns `12.300 NAV_ALPHA nav_t x_m=1.5 ...`, without newline. Messages that
/// cannot be decoded are shown as such, with their size and the reason.
std::string EventLine(const Schema& schema, const LogEvent& event);

}  // namespace shoal
