// Node reports as MOOS apps write them: NAME=alpha,X=5,Y=-20,SPD=1,...
//
//   NAME X Y SPD HDG COG DEP LAT LON TYPE COLOR GROUP MODE ALLSTOP ALTITUDE SPD_OG INDEX TIME
//   LENGTH
//
// are the keys of the fields of node_report_t. The report's extra fields follow, by their own keys;
// one whose key is one of those above, without regard to case, or begins with "extra.", has
// "extra." before it. TIME is seconds, exactly.
#pragma once

#include <string>

#include "shoal/node_report_t.hpp"

namespace shoal {

/// Writes one line with every field, as lib/run/moos_text/fields.h reads it; empty texts but NAME,
/// and an ALTITUDE of -1, are left out. A number that is not finite is written as nan or inf.
[[nodiscard]] std::string FormatNodeReport(const node_report_t& report);

}  // namespace shoal
