// Ids that are the same in a live view and after seeking in a log.
#pragma once

#include <cstdint>
#include <string_view>

namespace shoal {

/// Returns a hash of both (FNV-1a, then the mixer of splitmix64), below 2^53 so that JavaScript can
/// hold it.
[[nodiscard]] inline int64_t StableId(std::string_view text, int64_t number) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<uint8_t>(c)) * 0x100000001b3;
  hash += 0x9e3779b97f4a7c15 * (static_cast<uint64_t>(number) + 1);
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111eb;
  return static_cast<int64_t>((hash ^ (hash >> 31)) >> 11);
}

}  // namespace shoal
