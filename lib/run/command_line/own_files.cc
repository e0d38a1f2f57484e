#include "lib/run/command_line/own_files.h"

#include <filesystem>
#include <system_error>

namespace shoal {

namespace fs = std::filesystem;

std::optional<std::string> FindOwnFile(std::string_view path, std::string_view program_dir) {
  constexpr std::string_view kPages = "docs/";
  const fs::path dir(program_dir);
  const fs::path root = dir.parent_path().parent_path();
  const fs::path share = root.parent_path() / "share";
  const fs::path installed = path.starts_with(kPages)
                                 ? share / "doc/shoal" / path.substr(kPages.size())
                                 : share / "shoal" / path;
  for (const fs::path& candidate : {root / path, installed}) {
    std::error_code error;
    if (fs::exists(candidate, error)) return candidate.string();
  }
  return std::nullopt;
}

}  // namespace shoal
