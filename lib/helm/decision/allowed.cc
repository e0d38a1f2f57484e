#include "lib/helm/decision/allowed.h"

#include <cstddef>
#include <utility>

namespace shoal {

void Restrict(AllowedPart* allowed, const AllowedPart& other) {
  if (!other.speeds.empty()) {
    std::vector<IndexRange> both = other.speeds;
    for (size_t i = 0; i < allowed->speeds.size(); ++i) both[i] = both[i].And(allowed->speeds[i]);
    if (AllowsAny(both)) allowed->speeds = std::move(both);
  }
  if (other.depths) {
    const IndexRange both = allowed->depths ? allowed->depths->And(*other.depths) : *other.depths;
    if (!both.empty()) allowed->depths = both;
  }
}

}  // namespace shoal
