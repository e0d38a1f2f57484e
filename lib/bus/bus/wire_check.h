// Guards decoding against false lengths: LCM's generated code allocates what an array length states
// before it checks that this many bytes are there.
#pragma once

#include <cstdint>
#include <span>

namespace shoal {

/// Returns true where `data` is one whole message of shoal's type with this fingerprint, with no
/// byte too few or too many. Types without arrays and strings are compared by size alone. Unknown
/// fingerprints: false.
[[nodiscard]] bool WireLengthsAreSane(int64_t fingerprint, std::span<const uint8_t> data);

}  // namespace shoal
