#include "lib/bus/record/file_window.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace shoal {

Result<FileWindow> FileWindow::Open(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return Error{"cannot read " + path + ": " + ErrnoText(errno)};
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) {
    return Error{"cannot read " + path + ": " + ErrnoText(errno)};
  }
  if (!S_ISREG(status.st_mode)) return Error{"cannot read " + path + ": not a regular file"};
  return FileWindow(std::make_shared<FileDescriptor>(std::move(file)),
                    static_cast<uint64_t>(status.st_size), kBufferSize);
}

FileWindow FileWindow::Another(size_t buffer_size) const {
  return {file_, size_, std::max<size_t>(buffer_size, 64)};
}

std::span<const uint8_t> FileWindow::At(uint64_t offset, size_t size) {
  if (offset >= size_) return {};
  size = static_cast<size_t>(std::min<uint64_t>(size, size_ - offset));
  if (offset < begin_ || offset + size > begin_ + filled_) Load(offset, size);
  if (offset >= size_) return {};
  size = static_cast<size_t>(std::min<uint64_t>(size, size_ - offset));
  return std::span(buffer_).subspan(static_cast<size_t>(offset - begin_), size);
}

std::span<const uint8_t> FileWindow::Around(uint64_t begin, uint64_t end) {
  const uint64_t buffered_end = begin_ + filled_;
  if (begin >= begin_ && begin + 4 <= buffered_end) end = std::min(end, buffered_end);
  return At(begin, static_cast<size_t>(std::min<uint64_t>(buffer_size_, end - begin)));
}

void FileWindow::Load(uint64_t offset, size_t size) {
  const size_t wanted =
      static_cast<size_t>(std::min<uint64_t>(std::max(size, buffer_size_), size_ - offset));
  if (buffer_.size() < wanted) buffer_.resize(wanted);
  begin_ = offset;
  filled_ = 0;
  while (filled_ < wanted) {
    const ssize_t result = ::pread(file_->get(), buffer_.data() + filled_, wanted - filled_,
                                   static_cast<off_t>(offset + filled_));
    if (result < 0 && errno == EINTR) continue;
    if (result <= 0) {
      if (result < 0) error_ = ErrnoText(errno);
      size_ = offset + filled_;  // the file was cut, or the disk is damaged here
      return;
    }
    filled_ += static_cast<size_t>(result);
  }
}

std::optional<uint32_t> FileWindow::PeekUint32(uint64_t offset) const {
  std::array<uint8_t, 4> bytes;
  if (offset > size_ || size_ - offset < bytes.size()) return std::nullopt;
  if (offset >= begin_ && offset + bytes.size() <= begin_ + filled_) {
    std::copy_n(buffer_.begin() + static_cast<ptrdiff_t>(offset - begin_), 4, bytes.begin());
  } else if (::pread(file_->get(), bytes.data(), 4, static_cast<off_t>(offset)) != 4) {
    return std::nullopt;
  }
  return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | bytes[3];
}

std::optional<uint64_t> FileWindow::FindUint32(uint32_t value, uint64_t begin, uint64_t end) {
  const std::array<uint8_t, 4> pattern = {
      static_cast<uint8_t>(value >> 24), static_cast<uint8_t>(value >> 16),
      static_cast<uint8_t>(value >> 8), static_cast<uint8_t>(value)};
  end = std::min(end, size_);
  while (begin + pattern.size() <= end) {
    const auto bytes = Around(begin, end);
    if (bytes.size() < pattern.size()) return std::nullopt;
    const void* found = ::memmem(bytes.data(), bytes.size(), pattern.data(), pattern.size());
    if (found != nullptr) {
      return begin + static_cast<uint64_t>(static_cast<const uint8_t*>(found) - bytes.data());
    }
    begin += bytes.size() - (pattern.size() - 1);
  }
  return std::nullopt;
}

}  // namespace shoal
