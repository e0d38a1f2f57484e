#include "lib/comms/swarm/schedule_repair.h"

#include <bit>
#include <utility>

namespace shoal {

namespace {

int DifferingBits(int64_t a, int64_t b) {
  return std::popcount(static_cast<uint32_t>(a) ^ static_cast<uint32_t>(b));
}

size_t PlacesBetween(size_t a, size_t b) { return a > b ? a - b : b - a; }

}  // namespace

std::optional<std::vector<int64_t>> RepairSchedule(const std::vector<int64_t>& ids,
                                                   const std::vector<int64_t>& reference) {
  const size_t n = ids.size();
  if (n != reference.size() || n == 0) return std::nullopt;
  std::vector<int64_t> repaired = ids;
  std::vector<bool> is_used(n, false);
  std::vector<size_t> elsewhere;
  for (size_t i = 0; i < n; ++i) {
    is_used[i] = ids[i] == reference[i];
    if (!is_used[i]) elsewhere.push_back(i);
  }
  std::vector<size_t> unmatched;
  for (const size_t i : elsewhere) {
    size_t place = 0;
    while (place < n && (is_used[place] || reference[place] != ids[i])) ++place;
    if (place < n) {
      is_used[place] = true;
    } else {
      unmatched.push_back(i);
    }
  }
  if (unmatched.size() > n / 2) return std::nullopt;
  for (const size_t i : unmatched) {
    std::optional<size_t> nearest;
    const auto distance_to = [&](size_t place) {
      return std::pair(DifferingBits(ids[i], reference[place]), PlacesBetween(i, place));
    };
    for (size_t place = 0; place < n; ++place) {
      if (is_used[place]) continue;
      if (!nearest || distance_to(place) < distance_to(*nearest)) nearest = place;
    }
    is_used[*nearest] = true;
    repaired[i] = reference[*nearest];
  }
  return repaired;
}

}  // namespace shoal
