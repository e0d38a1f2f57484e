#include "lib/bus/os/replace_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <system_error>

namespace shoal {

std::string PartPath(const std::string& path) {
  constexpr size_t kLongestName = 256;
  char host[kLongestName] = {};
  gethostname(host, sizeof host - 1);
  return fmt::format("{}.{}.{}.part", path, host, getpid());
}

std::string ReplaceFile(const std::string& path, std::string_view text) {
  const std::string part = PartPath(path);
  std::ofstream out(part, std::ios::binary);
  out << text;
  out.close();
  std::error_code error;
  if (out) std::filesystem::rename(part, path, error);
  if (out && !error) return {};
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  return fmt::format("{}: cannot be written: is the disk full, or the folder another user's?",
                     path);
}

}  // namespace shoal
