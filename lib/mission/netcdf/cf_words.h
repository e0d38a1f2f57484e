// Words in attributes of NetCDF files.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

/// Returns a name as it may stand in a message: short, and printable.
inline std::string PrintableName(std::string_view name) {
  std::string printable(name.substr(0, 60));
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  return printable;
}

}  // namespace shoal
