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

/// Makes behaviors of the events of a vehicle's own script where behaviors know the variables of
/// its conditions and all of its events set variables. A script that is repeated begins again after
/// its conditions have failed; it stays a list of events where it waits for an order alone, or
/// gives a variable one value after the other.
void MakeScriptTimers(TimerScript* script, VehicleImport* vehicle);

}  // namespace shoal
