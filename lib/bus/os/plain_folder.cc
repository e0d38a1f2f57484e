#include "lib/bus/os/plain_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#include "lib/bus/os/file_bytes.h"

namespace shoal {

namespace {

constexpr char kLinkProblem[] =
    "is a link, which may lead to any file of yours: look where it leads, and remove it";

Error IsALink(const std::string& path) { return Error{fmt::format("{}: {}", path, kLinkProblem)}; }

}  // namespace

Result<PlainFolder> PlainFolder::Open(const std::string& path) {
  FileDescriptor fd(::open(path.empty() ? "." : path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd.is_open()) return Error{fmt::format("{}: {}", path, ErrnoText(errno))};
  return PlainFolder(std::move(fd), path);
}

Result<PlainFolder> PlainFolder::Below(const std::string& name) const {
  const std::string path = path_ + "/" + name;
  if (mkdirat(fd_.get(), name.c_str(), 0777) != 0 && errno != EEXIST) {
    return Error{fmt::format("{}: cannot be made: {}", path, ErrnoText(errno))};
  }
  return Existing(name);
}

Result<PlainFolder> PlainFolder::Existing(const std::string& name) const {
  const std::string path = path_ + "/" + name;
  FileDescriptor fd(
      openat(fd_.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (fd.is_open()) return PlainFolder(std::move(fd), path);
  const int error = errno;
  struct stat status {};
  if (fstatat(fd_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
      S_ISLNK(status.st_mode)) {
    return IsALink(path);
  }
  return Error{fmt::format("{}: cannot be opened as a folder: {}", path, ErrnoText(error))};
}

Result<FileDescriptor> PlainFolder::OpenFile(const std::string& name, int flags) const {
  const std::string path = path_ + "/" + name;
  constexpr mode_t kMode = 0644;
  // Without O_NONBLOCK, to open a pipe would wait for its other end.
  FileDescriptor file(openat(fd_.get(), name.c_str(),
                             O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | flags,
                             kMode));
  struct stat status {};
  if (!file.is_open() && errno == ELOOP) return IsALink(path);
  if (!file.is_open() || fstat(file.get(), &status) != 0) {
    return Error{fmt::format("{}: cannot be written: {}", path, ErrnoText(errno))};
  }
  if (!S_ISREG(status.st_mode)) return Error{fmt::format("{}: is not a regular file", path)};
  if (status.st_nlink > 1) {
    return Error{fmt::format(
        "{}: has another name as well (a hard link), under which it may be any file of yours: put "
        "a copy in its place",
        path)};
  }
  return file;
}

Result<FileDescriptor> PlainFolder::FileToRead(const std::string& name) const {
  FileDescriptor file(
      openat(fd_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() && errno == ELOOP) return Error{kLinkProblem};
  if (!file.is_open() || fstat(file.get(), &status) != 0) {
    return Error{"cannot be read: " + ErrnoText(errno)};
  }
  if (!S_ISREG(status.st_mode)) return Error{"is not a regular file"};
  return file;
}

FileText PlainFolder::ReadText(const std::string& name, size_t most_bytes) const {
  const Result<FileDescriptor> file = FileToRead(name);
  return file.ok() ? ReadOpenFile(file->get(), most_bytes) : FileText{"", file.error()};
}

bool PlainFolder::Has(const std::string& name) const {
  struct stat status {};
  return fstatat(fd_.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0;
}

std::vector<std::string> PlainFolder::Names() const {
  std::vector<std::string> names;
  std::error_code error;
  // By the open folder, whatever bears its path by now.
  const std::filesystem::directory_iterator all(fmt::format("/proc/self/fd/{}", fd_.get()), error);
  for (const auto& entry : all) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string PlainFolder::Remove(const std::string& name) const {
  std::error_code error;
  // By the open folder, whatever bears its path by now.
  std::filesystem::remove_all(fmt::format("/proc/self/fd/{}/{}", fd_.get(), name), error);
  return error ? fmt::format("{}/{}: cannot be removed: {}", path_, name, error.message())
               : std::string();
}

}  // namespace shoal
