// Random paths: each is drawn from a stream of its own, so that no change elsewhere changes it.
#include <cstdint>
#include <variant>

#include "lib/base/random/stream.h"
#include "lib/mission/file/validate.h"

namespace shoal {

void SeedPaths(Mission& mission) {
  for (Vehicle& vehicle : mission.vehicles) {
    for (Task& task : vehicle.tasks) {
      auto* path = std::get_if<PathFollowTask>(&task.what);
      if (path == nullptr) continue;
      for (size_t i = 0; i < path->parts.size(); ++i) {
        auto* random = std::get_if<RandomPart>(&path->parts[i].what);
        if (random == nullptr) continue;
        random->seed = Stream(static_cast<uint64_t>(mission.seed), "path", vehicle.name, task.name,
                              static_cast<int64_t>(i))
                           .Bits();
      }
    }
  }
}

}  // namespace shoal
