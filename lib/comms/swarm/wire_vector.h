// Three float32 on the wire, as every message of a swarm carries positions and velocities.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "lib/base/codec/little_endian.h"

namespace shoal {

inline constexpr size_t kWireVectorBytes = 12;

inline void AppendWireVector(const Eigen::Vector3f& vector, std::vector<uint8_t>* bytes) {
  for (const float number : vector) AppendLittleEndian(number, bytes);
}

/// @pre reader->num_left() >= kWireVectorBytes
inline Eigen::Vector3f TakeWireVector(LittleEndianReader* reader) {
  Eigen::Vector3f vector;
  for (float& number : vector) number = reader->Take<float>();
  return vector;
}

}  // namespace shoal
