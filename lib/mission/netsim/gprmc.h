// A GPS receiver's sentence for a simulated vehicle.
#pragma once

#include <cstdint>
#include <string>

#include "lib/mission/netsim/netsim_request.h"

namespace shoal {

/// Returns $GPRMC with its checksum and end, as netsim writes it: minutes cut to four decimals,
/// knots and heading as given (359.96 is "360.0", negative values stay), always valid, at any
/// depth. Time and date are `unix_us`, microseconds since 1970 UTC; nav.time_s is not used. Speed
/// and heading are held to five digits.
/// @pre lat and lon are finite and below 1000, as accepted navs' are.
[[nodiscard]] std::string GprmcSentence(const NetsimNav& nav, int64_t unix_us);

}  // namespace shoal
