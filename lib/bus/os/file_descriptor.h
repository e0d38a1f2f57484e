// An open file that is closed when its owner is destroyed.
#pragma once

#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

namespace shoal {

class FileDescriptor {
 public:
  FileDescriptor() = default;
  explicit FileDescriptor(int fd) : fd_(fd) {}
  FileDescriptor(FileDescriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~FileDescriptor() {
    if (is_open()) ::close(fd_);
  }

  bool is_open() const { return fd_ >= 0; }
  int get() const { return fd_; }

  /// Closes the file; returns false where that failed (errno).
  bool Close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_ = -1;
};

/// Returns the text of an errno.
inline std::string ErrnoText(int error) { return std::generic_category().message(error); }

}  // namespace shoal
