// The main loop of an app that works without a mission's clock: it takes messages as they come, and
// its time is the wall's.
//
// Overload: what has arrived is handed to the app in rounds. A round takes of each channel what the
// app can handle in a quarter of a second (lib/run/round_size.h); what has arrived beyond that is
// dropped at once, counted and shown, so that the app is never further behind than about two
// rounds, and a flood of reports does not keep a command waiting. What the kernel dropped before,
// because nobody read it in time, is counted and shown too.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "lib/bus/bus.h"
#include "lib/bus/layout.h"
#include "lib/mission/mission.h"
#include "lib/run/app.h"

namespace shoal {

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
