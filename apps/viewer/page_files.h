// The files of the page, by the path that a request has for them. Nothing else is served, so no
// path leads out of a folder.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

struct PageFile {
  std::string content_type;
  std::string bytes;
};

/// By path, such as "/index.html"; "/" is the same file.
using PageFiles = std::map<std::string, PageFile, std::less<>>;

/// The files of web/ as they were when this program was built.
PageFiles EmbeddedPageFiles();

/// The files in `folder` now, for those who work on the page. Fails where there is no index.html.
[[nodiscard]] Result<PageFiles> LoadPageFiles(const std::string& folder);

/// Returns the type by the name's ending; empty: no file of a page.
[[nodiscard]] std::string_view ContentTypeOf(std::string_view path);

}  // namespace shoal
