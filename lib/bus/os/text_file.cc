#include "lib/bus/os/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "lib/bus/os/file_bytes.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

namespace {

/// Makes an empty file beside `path` and gives it that name. Where this fails, the descriptor is
/// not open and errno holds the reason.
FileDescriptor MakeAnew(const std::string& path) {
  constexpr int kMaxDrafts = 100;  // More are there only where they were laid out to be hit.
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  for (int i = 0; i < kMaxDrafts; ++i) {
    const std::string draft = (folder / fmt::format(".shoal-{}-{}", ::getpid(), i)).string();
    FileDescriptor file(
        ::open(draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
    if (!file.is_open() && errno == EEXIST) continue;
    if (!file.is_open() || ::rename(draft.c_str(), path.c_str()) == 0) return file;
    const int error = errno;
    ::unlink(draft.c_str());
    errno = error;
    return {};
  }
  errno = EEXIST;
  return {};
}

}  // namespace

bool TextFile::Flush() {
  if (error_ == 0) {
    FileDescriptor file =
        is_made_
            ? FileDescriptor(::open(path_.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC))
            : MakeAnew(path_);
    is_made_ = true;
    if (!file.is_open() || !WriteAll(file.get(), pending_) || !file.Close()) error_ = errno;
    pending_.clear();
  }
  errno = error_;
  return error_ == 0;
}

}  // namespace shoal
