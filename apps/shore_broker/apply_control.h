// A rule changes while the mission runs.
#pragma once

#include <cstdint>

#include "lib/comms/routing/control.h"
#include "lib/comms/routing/router.h"
#include "lib/run/run/status_page.h"
#include "shoal/unc_control_t.hpp"

namespace shoal {

/// Sets the rule of `row` to the value of `control` and logs it as an event; or leaves it as it is
/// and warns, where the value is impossible or a vehicle is named for a rule of all. Returns true
/// where a value of COMMS_RULES changed.
bool ApplyControl(const ControlRow& row, const unc_control_t& control, int64_t utime,
                  Router* router, StatusLog* log);

}  // namespace shoal
