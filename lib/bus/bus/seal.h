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
//   tag           16 bytes   BLAKE2b with 16 bytes of output and the mission's secret as key, over
//                            the channel's name, a 0, and all bytes before the tag
//   magic         4 bytes    0x53484f32, "SHO2"
//
// The tag shows that a participant of the mission sealed the message, and for this channel. A
// message without a seal comes from outside the step protocol.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/bus/bus/mission_secret.h"

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
  std::optional<Seal> seal;         ///< Absent: from outside; `message` is all of it.
  std::span<const uint8_t> tagged;  ///< What the tag is about: all before it.
  std::span<const uint8_t> tag;
};

/// Appends the seal to `message`, in place.
/// @pre the publisher's name has 1 to 100 bytes
void AppendSeal(const Seal& seal, const MissionSecret& secret, std::string_view channel,
                std::vector<uint8_t>* message);

/// Takes a datagram apart, whatever its tag: a recording needs no secret.
[[nodiscard]] Unsealed Unseal(std::span<const uint8_t> datagram);

/// True where the seal was made with `secret`, for this channel.
[[nodiscard]] bool IsGenuine(const Unsealed& unsealed, const MissionSecret& secret,
                             std::string_view channel);

}  // namespace shoal
