#include "lib/mission/read_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace shoal {

namespace {

thread_local FilesRead* list_of_thread = nullptr;

FileText Unreadable() { return {"", std::string("cannot be read: ") + std::strerror(errno)}; }

FileText Read(const std::string& path, bool is_any_kind, size_t most_bytes) {
  const int fd =
      open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | (is_any_kind ? 0 : O_NONBLOCK));
  if (fd < 0) return Unreadable();
  struct stat status {};
  FileText read;
  if (fstat(fd, &status) != 0) {
    read = Unreadable();
  } else if (S_ISDIR(status.st_mode)) {
    read.problem = "is a directory; name the .toml file in it";
  } else if (!is_any_kind && !S_ISREG(status.st_mode)) {
    read.problem = "is not a regular file";
  } else {
    read = ReadOpenFile(fd, most_bytes);
  }
  close(fd);
  return read;
}

}  // namespace

FileText ReadFile(const std::string& path) { return Read(path, true, kLargestFile_bytes); }

FilesRead::FilesRead() : outer_(list_of_thread) { list_of_thread = this; }

FilesRead::~FilesRead() { list_of_thread = outer_; }

FileText ReadRegularFile(const std::string& path, size_t most_bytes) {
  FileText read = Read(path, false, most_bytes);
  if (list_of_thread != nullptr && read.problem.empty()) list_of_thread->paths_.insert(path);
  return read;
}

FileText ReadOpenFile(int fd, size_t most_bytes) {
  FileText file;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t size = read(fd, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return Unreadable();
    if (size == 0) return file;
    file.text.append(buffer.data(), static_cast<size_t>(size));
    if (file.text.size() > most_bytes) {
      return {"", fmt::format("is larger than {} bytes", most_bytes)};
    }
  }
}

}  // namespace shoal
