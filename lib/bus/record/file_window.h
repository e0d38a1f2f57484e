// Looks at a file of any length through a buffer of a few megabytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

class FileWindow {
 public:
  /// Opens a regular file. What is appended to it later is not read.
  static Result<FileWindow> Open(const std::string& path);

  static constexpr size_t kBufferSize = size_t{1} << 20;

  /// Returns another window on the same open file, which the path may no longer name. It reads at
  /// least `buffer_size` bytes at a time. Each window may have a thread of its own.
  FileWindow Another(size_t buffer_size = kBufferSize) const;

  uint64_t size() const { return size_; }

  /// Returns the bytes [offset, offset + size), fewer at the end of the file. They live until the
  /// next call. Takes `size` bytes of memory, no more than the file has.
  std::span<const uint8_t> At(uint64_t offset, size_t size);

  /// Returns the big-endian number at `offset` and leaves the views of At() alive.
  std::optional<uint32_t> PeekUint32(uint64_t offset) const;

  /// Returns where the big-endian `value` begins in [begin, end). Ends the life of At()'s views.
  std::optional<uint64_t> FindUint32(uint32_t value, uint64_t begin, uint64_t end);

  /// Why bytes could not be read (the file looks shorter then); empty: they could.
  const std::string& error() const { return error_; }

 private:
  FileWindow(std::shared_ptr<const FileDescriptor> file, uint64_t size, size_t buffer_size)
      : file_(std::move(file)), buffer_size_(buffer_size), size_(size) {}
  void Load(uint64_t offset, size_t size);
  /// Returns some bytes from `begin` on, those that are in memory if there are at least four.
  std::span<const uint8_t> Around(uint64_t begin, uint64_t end);

  std::shared_ptr<const FileDescriptor> file_;
  size_t buffer_size_ = kBufferSize;
  uint64_t size_ = 0;
  uint64_t begin_ = 0;  ///< Of buffer_ in the file.
  size_t filled_ = 0;   ///< Bytes of buffer_ that hold the file's.
  std::vector<uint8_t> buffer_;
  std::string error_;
};

}  // namespace shoal
