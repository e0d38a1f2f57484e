// Scripts of uTimerScript that wait for a condition, as behaviors.
//
//   condition = TIME_AT_SURFACE > 3
//   event     = var=GPS_UPDATE_RECEIVED, val=true, time=1
//
// is a behavior of the kind timer with this condition, a duration of 1 s and the end flag
// GPS_UPDATE_RECEIVED=true: as the script's clock, its time runs while the condition holds.
#pragma once

#include "lib/tools/moos/import_timer.h"
#include "lib/tools/moos/import_vehicle.h"

namespace shoal {

/// Turns the events of a vehicle's own script into behaviors, if all of its events set variables
/// and behaviors know the variables of its conditions. A script that is repeated begins again after
/// its conditions have failed. It stays a list of events if it only waits for an order, or gives a
/// variable several values one after the other.
void MakeScriptTimers(TimerScript* script, VehicleImport* vehicle);

}  // namespace shoal
