#include "lib/bus/os/scratch_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace shoal {

namespace {

namespace fs = std::filesystem;

/// Opens and locks a folder of this user's, which is not a link. Not open: it is not to be had.
FileDescriptor LockFolder(const std::string& path) {
  FileDescriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (!folder.is_open() || fstat(folder.get(), &status) != 0 || status.st_uid != geteuid() ||
      flock(folder.get(), LOCK_EX | LOCK_NB) != 0) {
    return {};
  }
  return folder;
}

void RemoveLeftOvers(const fs::path& parent, const std::string& prefix) {
  std::error_code error;
  for (fs::directory_iterator each(parent, error), end; !error && each != end;
       each.increment(error)) {
    if (!each->path().filename().string().starts_with(prefix)) continue;
    const FileDescriptor lock = LockFolder(each->path().string());
    std::error_code ignored;
    if (lock.is_open()) fs::remove_all(each->path(), ignored);
  }
}

}  // namespace

ScratchFolder::ScratchFolder(std::string_view name) {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  const std::string prefix = std::string(name) + "-";
  RemoveLeftOvers(parent, prefix);
  constexpr int kMaxAttempts =
      10;  // Another process may take it for left over before it is locked.
  for (int i = 0; i < kMaxAttempts && path_.empty(); ++i) {
    std::string path = (parent / (prefix + "XXXXXX")).string();
    if (mkdtemp(path.data()) == nullptr) return;
    lock_ = LockFolder(path);
    if (lock_.is_open() && fs::is_directory(path, error)) path_ = path;
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

}  // namespace shoal
