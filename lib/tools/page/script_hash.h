// How a page's security policy names its scripts and styles.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns "'sha256-...'", by which a page's Content-Security-Policy (W3C, level 3) allows this
/// script and no other.
[[nodiscard]] std::string ScriptHash(std::string_view script);

}  // namespace shoal
