#include "lib/bus/os/files_below.h"

#include <filesystem>
#include <system_error>

namespace shoal {

namespace {

thread_local const OnlyFilesBelow* innermost_bounds = nullptr;

/// Returns the path absolute and without dots. Links are not looked at.
std::filesystem::path PlainPath(const std::string& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).lexically_normal();
}

}  // namespace

OnlyFilesBelow::OnlyFilesBelow(const std::string& folder)
    : folder_((PlainPath(folder) / "").string()), outer_(innermost_bounds) {
  innermost_bounds = this;
}

OnlyFilesBelow::~OnlyFilesBelow() { innermost_bounds = outer_; }

bool MayReadFile(const std::string& path) {
  if (innermost_bounds == nullptr) return true;
  const std::string plain = PlainPath(path).string();
  for (const OnlyFilesBelow* each = innermost_bounds; each != nullptr; each = each->outer_) {
    if (!plain.starts_with(each->folder_)) return false;
  }
  return true;
}

}  // namespace shoal
