// The modems that come with shoal: data/modems, as text inside the programs.
#pragma once

#include <span>
#include <string_view>

namespace shoal {

struct OwnModem {
  std::string_view name;  ///< Of its file, without .toml.
  std::string_view text;
};

/// In alphabetical order. Made by cmake/EmbedModems.cmake.
[[nodiscard]] std::span<const OwnModem> OwnModems();

}  // namespace shoal
