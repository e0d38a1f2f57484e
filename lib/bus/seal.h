// The seal that a participant puts behind every message it publishes over LCM.
//
// LCM's decoders read what their type holds and ignore what follows, so a sealed message stays
// readable for lcm-spy, lcm-logger and all other programs. Behind the encoded message stand:
//
//   name          n bytes    the publisher's name
//   n             1 byte
//   mission_id    8 bytes    all numbers big-endian, as LCM's own
//   step          8 bytes    in which it was published
//   sequence      4 bytes    counts the publisher's messages of the step from 0, over all channels
//   magic         4 bytes    0x53484f4c, "SHOL"
//
// A message without a seal comes from outside the step protocol.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace shoal {

struct Seal {
  std::string_view publisher;  ///< 1 to 100 bytes.
  int64_t mission_id = 0;
  int64_t step = 0;
  uint32_t sequence = 0;
};

/// A datagram taken apart. The views point into it.
struct Unsealed {
  std::span<const uint8_t> message;
  std::optional<Seal> seal;  ///< Absent: from outside the step protocol; `message` is all of it.
};

/// Appends the seal to `message`, in place.
void AppendSeal(const Seal& seal, std::vector<uint8_t>* message);

[[nodiscard]] Unsealed Unseal(std::span<const uint8_t> datagram);

}  // namespace shoal
