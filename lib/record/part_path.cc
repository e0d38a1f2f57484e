#include "lib/record/part_path.h"

#include <fmt/format.h>
#include <unistd.h>

namespace shoal {

std::string PartPath(const std::string& path) {
  constexpr size_t kLongestName = 256;
  char host[kLongestName] = {};
  gethostname(host, sizeof host - 1);
  return fmt::format("{}.{}.{}.part", path, host, getpid());
}

}  // namespace shoal
