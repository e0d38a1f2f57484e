#include "lib/sea/acoustics/transmission_store.h"

namespace shoal {

namespace {

/// Larger buffers are given back when their packet is gone.
constexpr size_t kKeptBufferBytes = 4096;

}  // namespace

void TransmissionStore::Recycle() {
  for (const int32_t index : unused_) {
    std::vector<uint8_t>& bytes = places_[index].bytes;
    if (bytes.capacity() > kKeptBufferBytes) bytes = {};
    places_.Free(index);
  }
  unused_.clear();
}

}  // namespace shoal
