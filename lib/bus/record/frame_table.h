// A log compressed with zstd: frames that can be read by themselves, and where each of them is. The
// format is zstd's own "seekable" one (contrib/seekable_format in zstd's sources, version 0.1.1):
// frames, then a skippable frame that lists their sizes. `zstd -d` gives the log itself.
//
//   Result<FrameTable> table = FrameTable::Read(fd, file_size);
//   FrameDecoder decoder;
//   if (decoder.Decode(fd, table->frames()[0], &bytes)) ...
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"

struct ZSTD_DCtx_s;

namespace shoal {

/// A frame must fit into memory as a whole: no frame holds more.
inline constexpr uint64_t kMaxFrame_bytes = uint64_t{64} << 20;
/// A damaged file may claim any number of frames; this bounds the memory for its table.
inline constexpr size_t kMaxFrames = size_t{4} << 20;

struct Frame {
  uint64_t file_begin = 0;  ///< In the compressed file.
  uint64_t file_size = 0;
  uint64_t begin = 0;    ///< In the log.
  uint64_t size = 0;     ///< Of what it holds; of a torn frame, of the part that can be read.
  bool is_torn = false;  ///< The file ends inside of it.
};

class FrameTable {
 public:
  /// Returns true for the first bytes of a compressed file.
  static bool IsCompressed(std::span<const uint8_t> first_bytes);

  /// Reads the list at the end of the file. Where it is missing, as after a kill of the writer,
  /// reads the head of each frame instead. The error names the byte, and what to do.
  static Result<FrameTable> Read(int fd, uint64_t file_size);

  /// Returns the table of an empty file: its writer was killed before it wrote anything.
  static FrameTable OfEmptyFile();

  /// The frames that hold something, in the order of the file. Each `begin` is the end of the frame
  /// before.
  const std::vector<Frame>& frames() const { return frames_; }
  /// Bytes of the log.
  uint64_t size() const { return frames_.empty() ? 0 : frames_.back().begin + frames_.back().size; }
  /// Why the end of the log is lost, with the byte; empty: it is not.
  const std::string& lost() const { return lost_; }
  /// Returns the number of the frame with that byte of the log. @pre offset < size()
  size_t NumberAt(uint64_t offset) const;

 private:
  bool TakeList(int fd, uint64_t file_size);
  std::string TakeHeads(int fd, uint64_t file_size);
  void Add(uint64_t file_begin, uint64_t file_size, uint64_t size);

  std::vector<Frame> frames_;
  std::string lost_;
};

class FrameDecoder {
 public:
  FrameDecoder();

  /// Reads a frame of the open file, and checks its size and checksum. Returns false where it is
  /// damaged or cannot be read; `bytes` are undefined then.
  [[nodiscard]] bool Decode(int fd, const Frame& frame, std::vector<uint8_t>* bytes);

  /// Returns how many bytes of the frame can be read before its data end or are damaged; at most
  /// kMaxFrame_bytes + 1.
  uint64_t Measure(int fd, uint64_t file_begin, uint64_t file_size);

 private:
  struct Free {
    void operator()(ZSTD_DCtx_s* context) const;
  };
  /// Calls `take` with each piece that is decompressed, until it returns false or the data end.
  /// Returns true if all of the frame was read.
  template <class Take>
  bool Stream(int fd, uint64_t file_begin, uint64_t file_size, Take take);

  std::unique_ptr<ZSTD_DCtx_s, Free> context_;
  std::vector<uint8_t> compressed_;
};

}  // namespace shoal
