// Makes any of shoal's participants: the one place where all apps meet, so that they can run in one
// process.
#pragma once

#include <memory>

#include "lib/bus/bus.h"
#include "lib/mission/mission.h"
#include "lib/run/app.h"
#include "lib/run/roster.h"

namespace shoal {

/// Returns the app of a roster entry.
/// @pre entry.app is one of shoal's, and not the recorder
std::unique_ptr<App> MakeApp(const RosterEntry& entry, const Mission& mission, Bus& bus);

}  // namespace shoal
