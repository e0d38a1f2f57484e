// Node reports as lines of an .alog, the text log of MOOS's pLogger: time, variable, source, value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lib/bus/record/log_commands.h"
#include "shoal/node_report_t.hpp"

namespace shoal {

/// Returns the lines that an .alog begins with. Times count from 0: mission time.
[[nodiscard]] std::string AlogHeader();

/// Appends a line: the event's time in seconds, the channel as the variable, the app that publishes
/// reports on that channel as the source, the report as comma-separated text.
void AppendAlogLine(int64_t event_utime, std::string_view channel,
                    const shoal::node_report_t& report, std::string* out);

/// Returns what `shoal log csv --moos` writes: node reports, in files that alog tools read.
[[nodiscard]] LogLines NodeReportsAsAlog();

}  // namespace shoal
