#include "lib/mission/read_file.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace shoal {

namespace {
constexpr size_t kLargestFile_bytes = 100'000'000;
}  // namespace

FileText ReadFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return {"", "is a directory; name the .toml file in it"};
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (file == nullptr) return {"", std::string("cannot be read: ") + std::strerror(errno)};
  FileText read;
  std::array<char, 65536> buffer;
  while (const size_t size = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    read.text.append(buffer.data(), size);
    if (read.text.size() > kLargestFile_bytes)
      return {"", "is larger than 100 MB: no mission file"};
  }
  if (std::ferror(file.get()) != 0) return {"", "cannot be read to its end"};
  return read;
}

}  // namespace shoal
