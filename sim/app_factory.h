// Makes any of shoal's participants: the one place where all apps meet, so that they can run in one
// process.
#pragma once

#include <memory>

#include "lib/bus/bus/bus.h"
#include "lib/mission/model/mission.h"
#include "lib/run/broker/broker.h"
#include "lib/run/broker/report_blocks.h"
#include "lib/run/run/app.h"
#include "lib/run/run/launched_apps.h"
#include "lib/run/run/roster.h"

namespace shoal {

/// Returns the app of a roster entry.
/// @pre entry.app is one of shoal's, and not the recorder
std::unique_ptr<App> MakeApp(const RosterEntry& entry, const Mission& mission, Bus& bus);

/// Returns what lib/run/launch/launcher.h needs of apps: its own participant "shoal" is a
/// DirectorApp.
LaunchedApps AppsToLaunch();

/// Returns the shore_broker alone: for deciding a recorded mission again
/// (lib/tools/rebroker/rebroker.h).
std::unique_ptr<Broker> MakeShoreBroker(const BrokerSetup& setup, Bus& bus);
/// Returns a shore_broker that others share the mission with.
std::unique_ptr<Broker> MakeSharedBroker(const Mission& mission, Bus& bus, BrokerShare share);

}  // namespace shoal
