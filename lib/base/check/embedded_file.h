// A file that is part of a program: cmake/EmbedWeb.cmake writes them.
#pragma once

#include <span>
#include <string_view>

namespace shoal {

struct EmbeddedFile {
  std::string_view path;  ///< "/index.html"
  std::span<const unsigned char> bytes;
};

}  // namespace shoal
