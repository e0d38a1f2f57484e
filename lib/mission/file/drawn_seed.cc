#include "lib/mission/file/drawn_seed.h"

#include <random>

namespace shoal {

uint64_t DrawSeed() {
  constexpr uint64_t kLargest = 0x7FFF'FFFF;
  std::random_device system;
  return system() & kLargest;
}

LoadedMission LoadMissionToRun(const std::string& path, const std::function<uint64_t()>& draw,
                               std::vector<std::string>* overrides) {
  LoadedMission loaded = LoadMission(path, *overrides);
  if (!loaded.errors.empty() || !loaded.mission.draws_seed) return loaded;
  overrides->push_back("mission.seed=" + std::to_string(draw()));
  return LoadMission(path, *overrides);
}

}  // namespace shoal
