// Looks at a file of any length through a buffer of a few megabytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lib/check/result.h"
#include "lib/record/file_descriptor.h"

namespace shoal {

class FileWindow {
 public:
  /// Opens a regular file, which has from now on the length that it has now.
  static Result<FileWindow> Open(const std::string& path);

  uint64_t size() const { return size_; }

  /// Returns the bytes [offset, offset + size), fewer at the end of the file. They live until the
  /// next call. Takes as much memory as `size` says, no more than the file has.
  std::span<const uint8_t> At(uint64_t offset, size_t size);

  /// Returns the big-endian number at `offset` and leaves the views of At() alive.
  std::optional<uint32_t> PeekUint32(uint64_t offset) const;

  /// Returns where the big-endian `value` begins in [begin, end). Ends the life of At()'s views.
  std::optional<uint64_t> FindUint32(uint32_t value, uint64_t begin, uint64_t end);

  /// Why bytes could not be read (the file looks shorter then); empty: they could.
  const std::string& error() const { return error_; }

 private:
  FileWindow(FileDescriptor file, uint64_t size) : file_(std::move(file)), size_(size) {}
  void Load(uint64_t offset, size_t size);
  /// Returns some bytes from `begin` on, those that are in memory if there are at least four.
  std::span<const uint8_t> Around(uint64_t begin, uint64_t end);

  FileDescriptor file_;
  uint64_t size_ = 0;
  uint64_t begin_ = 0;  ///< Of buffer_ in the file.
  size_t filled_ = 0;   ///< Bytes of buffer_ that hold the file's.
  std::vector<uint8_t> buffer_;
  std::string error_;
};

}  // namespace shoal
