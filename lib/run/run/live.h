// The main loop of an app that works without a mission's clock: it takes messages as they come, and
// its time is the wall's.
//
// Overload: what has arrived is handed to the app in rounds of about a tenth of a second
// (lib/run/run/round_size.h). What has waited for half a second when its turn comes is dropped,
// counted and shown: a position as old as that is not worth the time that fresh ones need. A few
// messages of each channel are handled in each round however late they are, so that a flood of
// reports does not block a command. What the kernel dropped before, since it was not read in time,
// is counted and shown too.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/layout.h"
#include "lib/mission/model/mission.h"
#include "lib/run/run/app.h"

namespace shoal {

inline constexpr int64_t kLongestWait_us = 500'000;

struct LiveOptions {
  std::string name;  ///< On its pages.
  PortPlan ports;
  int64_t tick_us = 100'000;      ///< A round comes at least this often.
  std::function<bool()> stopped;  ///< True where a signal asks for the end.
};

/// Runs the app of `mission` until `stopped`, and enters it among the running missions, where
/// `shoal send` and `shoal status` find it. Its time is microseconds since 1970 at the beginning,
/// and never jumps. Returns the exit code.
int RunLive(const LiveOptions& options, Mission mission,
            const std::function<std::unique_ptr<App>(const Mission&, Bus&)>& make);

}  // namespace shoal
