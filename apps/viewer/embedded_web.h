// What cmake/EmbedWeb.cmake writes: the files of web/ as bytes of this program.
#pragma once

#include <span>
#include <string_view>

namespace shoal {

struct EmbeddedFile {
  std::string_view path;  ///< "/index.html"
  std::span<const unsigned char> bytes;
};

std::span<const EmbeddedFile> EmbeddedWeb();

}  // namespace shoal
