// Looks at a log of any length through a buffer of a few megabytes, be it a file as it is or a
// compressed one (frame_table.h): offsets are those in the log.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/record/frame_table.h"

namespace shoal {

/// Identifies a file in one state: what is kept about the file (index_file.h) holds while this is
/// the same.
struct FileStamp {
  uint64_t size = 0;
  int64_t changed_ns = 0;
  uint64_t digest = 0;  ///< Of its first and last bytes, and of some pieces between.

  bool operator==(const FileStamp&) const = default;
};

/// Returns the FNV-1a digest of 64 bits, by words. It finds damage; it does not stop an attacker.
[[nodiscard]] uint64_t DigestOf(std::span<const uint8_t> bytes);

class FileWindow {
 public:
  /// Opens a regular file. What is appended to it later is not read. Damaged frames of a compressed
  /// file read as zeros.
  static Result<FileWindow> Open(const std::string& path);

  static constexpr size_t kBufferSize = size_t{1} << 20;

  /// Returns another window on the same open file, even if the path names another file by now. It
  /// reads at least `buffer_size` bytes at a time. Each window may have a thread of its own.
  FileWindow Another(size_t buffer_size = kBufferSize) const;

  uint64_t size() const { return size_; }

  /// Returns the stamp of the file as it was opened.
  const FileStamp& Stamp() const { return source_->stamp; }
  /// Returns true if the file was changed since it was opened.
  bool HasChanged() const;

  /// Returns the bytes [offset, offset + size), fewer at the end of the file. They live until the
  /// next call. It needs `size` bytes of memory, but never more than the file's size.
  std::span<const uint8_t> At(uint64_t offset, size_t size);

  /// Returns the big-endian number at `offset` and leaves the views of At() alive.
  std::optional<uint32_t> PeekUint32(uint64_t offset);

  /// Returns where the big-endian `value` begins in [begin, end). Ends the life of At()'s views.
  std::optional<uint64_t> FindUint32(uint32_t value, uint64_t begin, uint64_t end);

  /// Why bytes could not be read (the file looks shorter then); empty: they could.
  const std::string& error() const { return error_; }

  /// Why the end of a compressed log is lost; empty: it is not.
  std::string_view lost() const {
    return source_->frames ? std::string_view(source_->frames->lost()) : std::string_view();
  }
  /// Returns what is wrong with the compressed frame that has the byte `offset`, and where the
  /// frame is in the file; empty: nothing is wrong, as far as it has been read.
  std::string DamageAt(uint64_t offset) const;

 private:
  struct Source {
    FileDescriptor file;
    FileStamp stamp;
    std::optional<FrameTable> frames;  ///< Of a compressed log.
  };

  FileWindow(std::shared_ptr<const Source> source, uint64_t size, size_t buffer_size)
      : source_(std::move(source)), buffer_size_(buffer_size), size_(size) {}
  void Load(uint64_t offset, size_t size);
  void LoadFrames(uint64_t offset, size_t size);
  /// Sets `bytes` to what the frame holds; zeros where it is damaged.
  void Decode(size_t number, std::vector<uint8_t>* bytes);
  /// Returns some bytes from `begin` on, those that are in memory if there are at least four.
  std::span<const uint8_t> Around(uint64_t begin, uint64_t end);

  std::shared_ptr<const Source> source_;
  size_t buffer_size_ = kBufferSize;
  uint64_t size_ = 0;
  uint64_t begin_ = 0;  ///< Of buffer_ in the file.
  size_t filled_ = 0;   ///< Bytes of buffer_ that hold the file's.
  std::vector<uint8_t> buffer_;
  FrameDecoder decoder_;
  size_t peeked_frame_ = SIZE_MAX;  ///< The one in peeked_.
  std::vector<uint8_t> peeked_;
  std::set<size_t> damaged_frames_;
  std::string error_;
};

}  // namespace shoal
