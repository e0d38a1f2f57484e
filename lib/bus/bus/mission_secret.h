// The secret of one run, which all its participants share and no other user's process knows. With
// it they prove what they publish (lib/bus/bus/seal.h).
//
// `shoal run` makes a new one for each run and hands it on as 64 hexadecimal digits and a line
// break: to the participants that it starts, as an open file whose descriptor SHOAL_SECRET_FD
// numbers; to those that a user starts, in a file of mode 0600 beside the mission's entry in the
// run folder (lib/run/run/run_registry.h), which SHOAL_SECRET_FILE names.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

struct MissionSecret {
  std::array<uint8_t, 32> bytes{};
  bool operator==(const MissionSecret&) const = default;
};

/// Returns a secret from the system's random numbers.
MissionSecret RandomSecret();

/// Returns 64 hexadecimal digits and a line break.
std::string SecretText(const MissionSecret& secret);
/// Reads what SecretText returned. The error states the expected form, never the text.
[[nodiscard]] Result<MissionSecret> ParseSecret(std::string_view text);

/// Reads a secret from the beginning of an open file; its offset stays.
[[nodiscard]] Result<MissionSecret> ReadSecret(int descriptor);
/// The same for a file by name, which must be a plain file of this user's that no other may read.
[[nodiscard]] Result<MissionSecret> ReadSecretFile(const std::string& path);

}  // namespace shoal
