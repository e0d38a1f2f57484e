// A whole mission in one process: the header for programs that embed shoal. Same participants, same
// steps, same log, byte for byte, as `shoal run` (examples/embed).
//
//   shoal::Result<shoal::Simulation> opened = shoal::Simulation::Open({.mission_file =
//   "berta.toml"}); if (!opened.ok()) return Fail(opened.error()); shoal::Simulation& simulation =
//   *opened; shoal::Subscribe(simulation.bus(), shoal::channels::Nav("alpha"), [](const
//   shoal::nav_t& nav) {}); while (simulation.Step()) {} std::puts(simulation.Summary().c_str());
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"
#include "lib/bus/record/channel_choice.h"

namespace shoal {

struct Mission;
class DirectorApp;

struct SimulationOptions {
  std::string mission_file;
  std::vector<std::string> overrides = {};  ///< As --set takes them: "comms.comms_range=100".
  std::optional<uint64_t> seed = {};        ///< Absent: the mission file's.
  std::string log_path = {};                ///< Empty: no log.
  ChannelChoice log_channels = {};          ///< What the log takes.
};

class Simulation {
 public:
  /// Loads a mission file. The error holds every error of the file, one per line, or why the
  /// mission needs `shoal run`, or why the log cannot be written.
  [[nodiscard]] static Result<Simulation> Open(const SimulationOptions& options);

  /// `log_path` empty: no log; look at Fault() after this.
  /// @pre CanRunInOneProcess(mission)
  Simulation(const Mission& mission, const std::string& log_path,
             const ChannelChoice& log_channels = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  /// Takes one step of mission time. Returns false after the last, when the mission has ended.
  bool Step();
  /// Ends the mission before its last step: all participants handle what was published last, and
  /// close. Without effect after the end.
  void End();

  /// The bus of the embedding program, which takes part as "embedder". Its handlers run within
  /// Step() and get what was published in the step before; what it publishes between two calls of
  /// Step() reaches the others in the second. Subscribe before the first Step().
  Bus& bus();

  /// Returns why the mission cannot go on (disk full, a participant is lost), or an empty string.
  std::string Fault() const;
  /// Returns a line for each participant that crashed, and what became of it by [mission] on_loss.
  const std::vector<std::string>& losses() const;

  /// The number of the last step taken, from 0; -1 before the first.
  int64_t step() const;
  /// Mission time of the last step, microseconds.
  int64_t utime() const;
  const Mission& mission() const;

  /// Returns true where the mission would pass, should it end now: every expectation met, and no
  /// collision that [mission] collisions does not allow.
  bool Passed() const;
  /// Returns the mission's last page, should it end now; its last line is PASS or FAIL, or
  /// INCOMPLETE where the mission is not `complete`.
  std::string Summary(bool complete = true) const;
  /// Node reports so far, each counted once per destination.
  int64_t num_delivered() const;
  int64_t num_blocked() const;
  /// What watches the mission: sim/director_app.h.
  const DirectorApp& director() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns an error where a participant is not shoal's own and so needs `shoal run`.
[[nodiscard]] Result<bool> CanRunInOneProcess(const Mission& mission);

}  // namespace shoal
