#include "lib/bus/os/replace_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "lib/bus/os/cannot_write.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

std::string PartPath(const std::string& path) {
  constexpr size_t kLongestName = 256;
  char host[kLongestName] = {};
  gethostname(host, sizeof host - 1);
  return fmt::format("{}.{}.{}.part", path, host, getpid());
}

std::string ReplaceFile(const std::string& path, std::string_view text) {
  const std::string part = PartPath(path);
  std::error_code error;
  std::filesystem::remove(part,
                          error);  // What a killed process left, or a link laid out to be hit.
  constexpr mode_t kMode = 0644;
  FileDescriptor out(
      ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kMode));
  int error_number = errno;
  if (out.is_open()) {
    const bool is_written = WriteAll(out.get(), text) && out.Close();
    error_number = errno;
    if (is_written) {
      std::filesystem::rename(part, path, error);
      if (!error) return {};
      error_number = error.value();
    }
  }
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  return CannotWrite(path, error_number).message;
}

}  // namespace shoal
