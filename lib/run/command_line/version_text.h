// What --version of every program prints.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns "<program> 0.2.0 (build 0123456789abcdef, arithmetic 0123456789abcdef)".
[[nodiscard]] std::string VersionText(std::string_view program);

}  // namespace shoal
