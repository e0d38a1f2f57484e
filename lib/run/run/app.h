// Base class of the apps that run in the processes of shoal: they are given messages and time.
//
//   class HelmApp : public App {
//     HelmApp(const Mission& mission, const Vehicle& vehicle, Bus& bus);   // subscribes
//     void Tick(int64_t utime) override;                                    // decides, publishes
//   };
//
// The same class runs in a process of its own over LCM (lib/run/run/run_app.h) and with all others
// in one process (sim/simulation.h). It never reads a clock.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/run/run/status_page.h"

namespace shoal {

class App {
 public:
  virtual ~App() = default;

  /// Advances to mission time `utime` (microseconds). The handlers of all messages of the step
  /// before have run. What is published here is received by others in the next step.
  virtual void Tick(int64_t utime) = 0;

  /// Called before Tick whenever it changes: the demanded mission seconds per wall second; 0: as
  /// fast as possible, which also holds before the first call. For what people watch only:
  /// a mission's result does not depend on it.
  virtual void OnWarp(double) {}

  /// A descriptor that is readable when Serve has something to do; -1: it serves no clients.
  virtual int ServedFd() const { return -1; }

  /// Serves clients from outside of the mission, between steps too: when ServedFd is readable, and
  /// several times a second. `now_us` is a clock that never goes back, `utc_us` microseconds since
  /// 1970. What comes of it is published in Tick.
  virtual void Serve(int64_t /*now_us*/, int64_t /*utc_us*/) {}

  /// Ends: the last messages have been handled, nothing may be published any more.
  virtual void End() {}

  /// Returns why the app cannot go on (disk full), or an empty string. Ends the mission.
  virtual std::string Fault() const { return {}; }

  /// Returns why the app crashes now, for tests of missions, or an empty string. Its own process
  /// aborts, within a simulation it alone is lost: [mission] on_loss decides what becomes of the
  /// mission.
  virtual std::string Crash() const { return {}; }

  /// The channels of requests that Answer answers, at the tick port.
  virtual std::vector<std::string> RequestChannels() const { return {}; }

  /// What is published in answer to a request.
  struct RequestAnswer {
    std::string channel;  ///< One for which IsAnswer() is true.
    Bytes data;
  };
  /// Answers a request at once, outside stepping, as APPCAST_REQ is answered: neither request nor
  /// answer is part of the mission, and neither changes it. Nothing where `data` is not a request.
  virtual std::optional<RequestAnswer> Answer(std::string_view /*channel*/,
                                              std::span<const uint8_t> /*data*/) const {
    return std::nullopt;
  }

  /// Returns what `shoal status` and the terminal show.
  virtual StatusPage Status() const = 0;
};

}  // namespace shoal
