#include "lib/bus/record/frame_table.h"

#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>

#include "lib/base/check/check.h"
#include "lib/bus/record/own_mark.h"

namespace shoal {

namespace {

constexpr uint32_t kFrameMagic = 0xFD2FB528;
constexpr uint32_t kSkippableMagic = 0x184D2A50;  ///< The last four bits are free.
constexpr uint32_t kListMagic = 0x184D2A5E;       ///< Of the skippable frame with the list.
constexpr uint32_t kListEndMagic = 0x8F92EAB1;    ///< The last four bytes of the file.
constexpr size_t kListEnd_bytes = 9;
constexpr size_t kMaxHead_bytes = 18;  ///< Magic, descriptor, window, dictionary, content size.

uint64_t LittleEndian(std::span<const uint8_t> bytes) {
  uint64_t value = 0;
  for (size_t i = bytes.size(); i > 0; --i) value = value << 8 | bytes[i - 1];
  return value;
}

/// Fills `bytes` from `offset` on; false: the file ends before, or cannot be read.
bool ReadAt(int fd, uint64_t offset, std::span<uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t result = ::pread(fd, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (result < 0 && errno == EINTR) continue;
    if (result <= 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(result));
    offset += static_cast<uint64_t>(result);
  }
  return true;
}

/// The head of a frame, by RFC 8878, section 3.1.1.1.
struct Head {
  uint64_t size = 0;  ///< Of the head.
  std::optional<uint64_t> content_size;
  bool has_checksum = false;
};

std::optional<Head> ReadHead(int fd, uint64_t offset, uint64_t file_size) {
  std::array<uint8_t, kMaxHead_bytes> bytes{};
  const auto length = static_cast<size_t>(std::min<uint64_t>(bytes.size(), file_size - offset));
  if (length < 6 || !ReadAt(fd, offset, std::span(bytes).first(length))) return std::nullopt;
  const uint8_t descriptor = bytes[4];
  const bool is_single_segment = (descriptor & 0x20) != 0;
  constexpr std::array<uint64_t, 4> kDictionary_bytes = {0, 1, 2, 4};
  const int size_flag = descriptor >> 6;
  const uint64_t size_bytes =
      size_flag == 0 ? (is_single_segment ? 1 : 0) : uint64_t{1} << size_flag;
  Head head;
  head.size = 5 + (is_single_segment ? 0 : 1) + kDictionary_bytes[descriptor & 3];
  if (head.size + size_bytes > length) return std::nullopt;
  if (size_bytes > 0) {
    head.content_size =
        LittleEndian(std::span(bytes).subspan(head.size, size_bytes)) + (size_bytes == 2 ? 256 : 0);
  }
  head.size += size_bytes;
  head.has_checksum = (descriptor & 4) != 0;
  return head;
}

/// Returns the end of the frame whose blocks begin at `offset`; nothing if the file ends before.
std::optional<uint64_t> EndOfBlocks(int fd, uint64_t offset, uint64_t file_size,
                                    bool has_checksum) {
  for (bool is_last = false; !is_last;) {
    std::array<uint8_t, 3> bytes{};
    if (file_size - offset < bytes.size() || !ReadAt(fd, offset, bytes)) return std::nullopt;
    const uint64_t head = LittleEndian(bytes);
    const bool is_repeated_byte = ((head >> 1) & 3) == 1;
    is_last = (head & 1) != 0;
    offset += bytes.size() + (is_repeated_byte ? 1 : head >> 3);
    if (offset > file_size) return std::nullopt;
  }
  if (has_checksum) offset += 4;
  return offset > file_size ? std::nullopt : std::optional(offset);
}

/// Returns true for a file that begins with the mark of FrameWriter.
bool IsOwnMark(int fd) {
  std::array<uint8_t, 8 + kOwnMark.size()> bytes{};
  return ReadAt(fd, 0, bytes) && LittleEndian(std::span(bytes).first(4)) == kOwnMarkMagic &&
         LittleEndian(std::span(bytes).subspan(4, 4)) == kOwnMark.size() &&
         std::ranges::equal(std::span(bytes).subspan(8), kOwnMark);
}

}  // namespace

bool FrameTable::IsCompressed(std::span<const uint8_t> first_bytes) {
  if (first_bytes.size() < 4) return false;
  const uint64_t magic = LittleEndian(first_bytes.first(4));
  return magic == kFrameMagic || (magic & ~uint64_t{0xF}) == kSkippableMagic;
}

Result<FrameTable> FrameTable::Read(int fd, uint64_t file_size) {
  FrameTable table;
  if (table.TakeList(fd, file_size)) return table;
  table = FrameTable();
  const std::string error = table.TakeHeads(fd, file_size);
  if (!error.empty()) return Error{error};
  return table;
}

FrameTable FrameTable::OfEmptyFile() {
  FrameTable table;
  table.lost_ = "the compressed file is empty: what wrote it was ended before it closed the log";
  return table;
}

void FrameTable::Add(uint64_t file_begin, uint64_t file_size, uint64_t size) {
  if (size == 0) return;
  frames_.push_back(
      {.file_begin = file_begin, .file_size = file_size, .begin = this->size(), .size = size});
}

bool FrameTable::TakeList(int fd, uint64_t file_size) {
  std::array<uint8_t, kListEnd_bytes> end{};
  if (file_size < 8 + end.size() || !ReadAt(fd, file_size - end.size(), end)) return false;
  const uint64_t count = LittleEndian(std::span(end).first(4));
  const size_t row_bytes = (end[4] & 0x80) != 0 ? 12 : 8;
  const uint64_t list_bytes = count * row_bytes + kListEnd_bytes;
  if (LittleEndian(std::span(end).subspan(5)) != kListEndMagic || (end[4] & 0x7C) != 0 ||
      count > kMaxFrames || file_size < 8 + list_bytes) {
    return false;
  }
  std::vector<uint8_t> list(static_cast<size_t>(8 + list_bytes));
  const uint64_t list_begin = file_size - list.size();
  if (!ReadAt(fd, list_begin, list) || LittleEndian(std::span(list).first(4)) != kListMagic ||
      LittleEndian(std::span(list).subspan(4, 4)) != list_bytes) {
    return false;
  }
  uint64_t file_begin = 0;
  for (uint64_t i = 0; i < count; ++i) {
    const auto row = std::span(list).subspan(static_cast<size_t>(8 + i * row_bytes), 8);
    const uint64_t compressed_bytes = LittleEndian(row.first(4));
    const uint64_t size = LittleEndian(row.subspan(4));
    if (size > kMaxFrame_bytes) return false;
    Add(file_begin, compressed_bytes, size);
    file_begin += compressed_bytes;
  }
  return file_begin == list_begin;
}

std::string FrameTable::TakeHeads(int fd, uint64_t file_size) {
  const auto end_inside = [](uint64_t offset) {
    return fmt::format("the compressed file ends inside the frame that begins at its byte {}",
                       offset);
  };
  bool is_own = false;
  for (uint64_t offset = 0; offset < file_size;) {
    if (frames_.size() == kMaxFrames) {
      return fmt::format("has more than {} frames; `zstd -d` makes a log of it", kMaxFrames);
    }
    std::array<uint8_t, 8> bytes{};
    const auto length = static_cast<size_t>(std::min<uint64_t>(bytes.size(), file_size - offset));
    if (!ReadAt(fd, offset, std::span(bytes).first(length))) return "cannot be read";
    const uint64_t magic = LittleEndian(std::span(bytes).first(4));
    if (length >= 4 && (magic & ~uint64_t{0xF}) == kSkippableMagic) {
      // The list is written last: even where it is damaged or cut, all frames are there.
      is_own = magic != kListMagic && (is_own || (offset == 0 && IsOwnMark(fd)));
      const uint64_t end = offset + 8 + LittleEndian(std::span(bytes).subspan(4));
      if (length < bytes.size() || end > file_size) {
        if (magic != kListMagic) lost_ = end_inside(offset);
        return {};
      }
      offset = end;
      continue;
    }
    if (length >= 4 && magic != kFrameMagic) {
      lost_ = fmt::format("no frame begins at byte {} of the compressed file", offset);
      return {};
    }
    const std::optional<Head> head = ReadHead(fd, offset, file_size);
    if (!head) {
      lost_ = end_inside(offset);
      return {};
    }
    const auto end = EndOfBlocks(fd, offset + head->size, file_size, head->has_checksum);
    // The size of a torn frame, or of one whose head has none, is known after reading it.
    uint64_t size = head->content_size.value_or(0);
    if (!end || !head->content_size) {
      FrameDecoder decoder;
      size = decoder.Measure(fd, offset, end.value_or(file_size) - offset);
    }
    if (size > kMaxFrame_bytes) {
      return fmt::format(
          "the frame that begins at byte {} holds more than {} MiB, which must fit into memory: "
          "make a log of it by `zstd -d`",
          offset, kMaxFrame_bytes >> 20);
    }
    Add(offset, end.value_or(file_size) - offset, size);
    if (!end) {
      lost_ = end_inside(offset);
      if (size > 0) frames_.back().is_torn = true;
      return {};
    }
    offset = *end;
  }
  if (is_own) {
    lost_ =
        "the list of frames that ends the compressed file is missing: what wrote it was ended "
        "before it closed the log";
  }
  return {};
}

size_t FrameTable::NumberAt(uint64_t offset) const {
  SHOAL_CHECK(offset < size(), "offset < size()");
  const auto after = std::ranges::upper_bound(frames_, offset, {}, &Frame::begin);
  return static_cast<size_t>(after - frames_.begin()) - 1;
}

FrameDecoder::FrameDecoder() : context_(ZSTD_createDCtx()) {
  SHOAL_CHECK(context_ != nullptr, "zstd has memory for a context");
}

void FrameDecoder::Free::operator()(ZSTD_DCtx_s* context) const { ZSTD_freeDCtx(context); }

template <class Take>
bool FrameDecoder::Stream(int fd, uint64_t file_begin, uint64_t file_size, Take take) {
  ZSTD_DCtx_reset(context_.get(), ZSTD_reset_session_and_parameters);
  compressed_.resize(ZSTD_DStreamInSize());
  std::vector<uint8_t> piece(ZSTD_DStreamOutSize());
  for (uint64_t read = 0; read < file_size;) {
    const auto length =
        static_cast<size_t>(std::min<uint64_t>(compressed_.size(), file_size - read));
    if (!ReadAt(fd, file_begin + read, std::span(compressed_).first(length))) return false;
    read += length;
    ZSTD_inBuffer in = {compressed_.data(), length, 0};
    while (in.pos < in.size) {
      ZSTD_outBuffer out = {piece.data(), piece.size(), 0};
      const size_t left = ZSTD_decompressStream(context_.get(), &out, &in);
      if (ZSTD_isError(left) != 0) return false;
      if (!take(std::span(piece).first(out.pos))) return false;
      if (left == 0) return read == file_size && in.pos == in.size;
    }
  }
  return false;
}

uint64_t FrameDecoder::Measure(int fd, uint64_t file_begin, uint64_t file_size) {
  uint64_t size = 0;
  Stream(fd, file_begin, file_size, [&](std::span<const uint8_t> piece) {
    size += piece.size();
    return size <= kMaxFrame_bytes;
  });
  return std::min(size, kMaxFrame_bytes + 1);
}

bool FrameDecoder::Decode(int fd, const Frame& frame, std::vector<uint8_t>* bytes) {
  bytes->clear();
  if (frame.is_torn) {
    Stream(fd, frame.file_begin, frame.file_size, [&](std::span<const uint8_t> piece) {
      bytes->insert(bytes->end(), piece.begin(), piece.end());
      return bytes->size() < frame.size;
    });
    return bytes->size() == frame.size;
  }
  // zstd makes no frame that is longer: the file is damaged.
  if (frame.file_size > ZSTD_compressBound(static_cast<size_t>(frame.size))) return false;
  compressed_.resize(static_cast<size_t>(frame.file_size));
  if (!ReadAt(fd, frame.file_begin, compressed_)) return false;
  bytes->resize(static_cast<size_t>(frame.size));
  const size_t size = ZSTD_decompressDCtx(context_.get(), bytes->data(), bytes->size(),
                                          compressed_.data(), compressed_.size());
  return ZSTD_isError(size) == 0 && size == frame.size;
}

}  // namespace shoal
