#include "lib/mission/file/print_errors.h"

#include <fmt/format.h>

namespace shoal {

bool LoadedWithoutErrors(const LoadedMission& loaded) {
  for (const std::string& error : loaded.errors) fmt::print(stderr, "{}\n", error);
  for (const std::string& warning : loaded.warnings) fmt::print(stderr, "{}\n", warning);
  return loaded.errors.empty();
}

}  // namespace shoal
