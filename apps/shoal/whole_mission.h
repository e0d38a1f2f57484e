// A mission in one process: the same participants, the same steps, the same log as over LCM.
//
//   WholeMission whole(mission, "run.lcm");
//   while (whole.Step()) {}
//   print(whole.director().Summary());
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/recorder/recorder_app.h"
#include "apps/shoal/director_app.h"
#include "lib/bus/memory_bus.h"
#include "lib/check/result.h"
#include "lib/mission/mission.h"
#include "lib/run/app.h"

namespace shoal {

class WholeMission {
 public:
  /// `log_path` empty: no log.
  /// @pre CanRunInOneProcess(mission)
  WholeMission(const Mission& mission, const std::string& log_path);

  /// Takes one step. Returns false after the last, when all have been told to end.
  bool Step();
  /// Ends before the last step: all handle what was said last, and close.
  void End();

  /// Returns why the mission cannot go on (disk full), or an empty string.
  std::string Fault() const;

  int64_t step() const { return step_; }
  const DirectorApp& director() const { return *director_; }

 private:
  struct Member {
    Bus* bus = nullptr;
    std::unique_ptr<App> app;
  };

  const Mission& mission_;
  MemoryBus hub_;
  std::vector<Member> members_;
  DirectorApp* director_ = nullptr;
  int64_t step_ = -1;
  bool ended_ = false;
};

/// Returns an error where a participant is not shoal's own and so needs `shoal run`.
[[nodiscard]] Result<bool> CanRunInOneProcess(const Mission& mission);

}  // namespace shoal
