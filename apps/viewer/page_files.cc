#include "apps/viewer/page_files.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <sstream>
#include <utility>

#include "apps/viewer/embedded_web.h"

namespace shoal {

namespace {

namespace fs = std::filesystem;

// cmake/EmbedWeb.cmake embeds files with these endings.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kContentTypes = {{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".json", "application/json; charset=utf-8"},
    {".svg", "image/svg+xml; charset=utf-8"},
    {".txt", "text/plain; charset=utf-8"},
    {".png", "image/png"},
}};

void Add(const std::string& path, std::string bytes, PageFiles* files) {
  const std::string_view type = ContentTypeOf(path);
  if (type.empty()) return;
  PageFile file = {.content_type = std::string(type), .bytes = std::move(bytes)};
  if (path == "/index.html") files->insert_or_assign("/", file);
  files->insert_or_assign(path, std::move(file));
}

}  // namespace

std::string_view ContentTypeOf(std::string_view path) {
  for (const auto& [ending, type] : kContentTypes) {
    if (path.ends_with(ending)) return type;
  }
  return {};
}

PageFiles EmbeddedPageFiles() {
  PageFiles files;
  for (const EmbeddedFile& file : EmbeddedWeb()) {
    Add(std::string(file.path), std::string(file.bytes.begin(), file.bytes.end()), &files);
  }
  return files;
}

Result<PageFiles> LoadPageFiles(const std::string& folder) {
  PageFiles files;
  std::error_code error;
  for (fs::recursive_directory_iterator each(folder, error), end; !error && each != end;
       each.increment(error)) {
    if (!each->is_regular_file(error) || error) continue;
    std::ifstream in(each->path(), std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    Add("/" + each->path().lexically_relative(folder).generic_string(), bytes.str(), &files);
  }
  if (!files.contains("/")) {
    return Error{fmt::format("--web {}: {}; give the folder of the page, web/ in shoal's source",
                             folder, error ? error.message() : "no index.html in it")};
  }
  return files;
}

}  // namespace shoal
