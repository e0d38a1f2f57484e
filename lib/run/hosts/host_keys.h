// Keys by which computers know each other: CURVE key pairs, as `shoal host keygen` writes them.
//
//   ~/.config/shoal/host.key   this computer's pair, mode 0600
//   ~/.config/shoal/host.pub   its public key, to be copied to the others
#pragma once

#include <string>

#include "lib/base/check/result.h"

namespace shoal {

/// A pair of keys, each 40 characters of Z85.
struct HostKey {
  std::string public_key;
  std::string secret_key;
};

/// Returns a new pair.
HostKey MakeHostKey();

/// Writes `prefix`.key (mode 0600, new) and `prefix`.pub. An error where one of them exists, or
/// cannot be written.
[[nodiscard]] Result<bool> WriteHostKey(const HostKey& key, const std::string& prefix);

/// Reads a pair. An error where it is missing (the remedy is `shoal host keygen`), is not a plain
/// file of this user's, or can be read by others.
[[nodiscard]] Result<HostKey> ReadHostKey(const std::string& path);

/// Returns the public key that `text` is, or that the file `text` holds (relative to `folder`).
[[nodiscard]] Result<std::string> FindPublicKey(const std::string& text, const std::string& folder);

/// Returns `wanted`, else $SHOAL_KEY, else ~/.config/shoal/host.key.
std::string HostKeyPath(const std::string& wanted);
/// Returns ~/.config/shoal/host ($XDG_CONFIG_HOME in place of ~/.config where it is set).
std::string DefaultKeyPrefix();

}  // namespace shoal
