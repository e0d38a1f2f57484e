#include "sim/sim_ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "lib/base/check/result.h"
#include "lib/base/time/seconds.h"

namespace shoal {

int PrintEnding(const SimEnding& ending) {
  const double mission_s = Seconds(ending.step * ending.mission.tick_us);
  for (const std::string& loss : ending.losses) fmt::print(stderr, "shoal: {}\n", loss);
  fmt::print("{:.1f} s of mission in {:.3f} s ({:.0f} x real time), {}\n", mission_s, ending.wall_s,
             mission_s / std::max(ending.wall_s, 1e-6), ending.where);
  if (!ending.log_path.empty() && ending.fault.empty()) fmt::print("Log: {}\n", ending.log_path);
  fmt::print("\n{}", ending.director.Summary(!ending.was_interrupted && ending.fault.empty()));
  if (!ending.fault.empty()) {
    fmt::print(stderr, "shoal: {}\n", ending.fault);
    return kExitEnvironment;
  }
  if (ending.was_interrupted) {
    fmt::print(stderr, "shoal: interrupted; the mission did not run to its end\n");
    return kExitMissionFailed;
  }
  return ending.director.Passed() ? kExitOk : kExitMissionFailed;
}

}  // namespace shoal
