#include "lib/bus/record/file_window.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "lib/bus/record/log_writer.h"

namespace shoal {

namespace {

FileStamp StampOf(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) != 0) return {};
  constexpr int64_t kNanoseconds = 1'000'000'000;
  FileStamp stamp{.size = static_cast<uint64_t>(status.st_size),
                  .changed_ns = status.st_mtim.tv_sec * kNanoseconds + status.st_mtim.tv_nsec};
  // Pieces from the begin to the end, evenly spread.
  constexpr size_t kPiece_bytes = 4096;
  constexpr uint64_t kPieces = 16;
  std::array<uint8_t, kPiece_bytes> piece{};
  for (uint64_t i = 0; i < kPieces; ++i) {
    const uint64_t last = stamp.size > kPiece_bytes ? stamp.size - kPiece_bytes : 0;
    const uint64_t place = last / (kPieces - 1) * i + last % (kPieces - 1) * i / (kPieces - 1);
    const ssize_t length = ::pread(fd, piece.data(), piece.size(), static_cast<off_t>(place));
    if (length > 0) {
      stamp.digest =
          stamp.digest * 31 + DigestOf(std::span(piece).first(static_cast<size_t>(length)));
    }
  }
  return stamp;
}

}  // namespace

uint64_t DigestOf(std::span<const uint8_t> bytes) {
  constexpr uint64_t kBasis = 0xcbf29ce484222325;
  constexpr uint64_t kPrime = 0x100000001b3;
  uint64_t digest = kBasis;
  for (; bytes.size() >= 8; bytes = bytes.subspan(8)) {
    uint64_t word = 0;
    for (size_t i = 0; i < 8; ++i) word |= uint64_t{bytes[i]} << (8 * i);
    digest = (digest ^ word) * kPrime;
    digest ^= digest >> 32;
  }
  for (const uint8_t byte : bytes) digest = (digest ^ byte) * kPrime;
  return digest;
}

bool FileWindow::HasChanged() const { return StampOf(source_->file.get()) != Stamp(); }

Result<FileWindow> FileWindow::Open(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open()) return Error{"cannot read " + path + ": " + ErrnoText(errno)};
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) {
    return Error{"cannot read " + path + ": " + ErrnoText(errno)};
  }
  if (!S_ISREG(status.st_mode)) return Error{"cannot read " + path + ": not a regular file"};
  auto source = std::make_shared<Source>();
  // Before all else is read: of a file that grows meanwhile the stamp is that of no later one.
  source->stamp = StampOf(file.get());
  uint64_t size = source->stamp.size;
  std::array<uint8_t, 4> magic{};
  if (::pread(file.get(), magic.data(), magic.size(), 0) == 4 && FrameTable::IsCompressed(magic)) {
    Result<FrameTable> table = FrameTable::Read(file.get(), size);
    if (!table.ok()) return Error{"cannot read " + path + ": " + table.error()};
    size = table->size();
    source->frames = std::move(*table);
  } else if (size == 0 && path.ends_with(kCompressedSuffix)) {
    source->frames = FrameTable::OfEmptyFile();
  }
  source->file = std::move(file);
  return FileWindow(std::move(source), size, kBufferSize);
}

FileWindow FileWindow::Another(size_t buffer_size) const {
  return {source_, size_, std::max<size_t>(buffer_size, 64)};
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
  if (source_->frames) return LoadFrames(offset, size);
  const size_t wanted =
      static_cast<size_t>(std::min<uint64_t>(std::max(size, buffer_size_), size_ - offset));
  if (buffer_.size() < wanted) buffer_.resize(wanted);
  begin_ = offset;
  filled_ = 0;
  while (filled_ < wanted) {
    const ssize_t result = ::pread(source_->file.get(), buffer_.data() + filled_, wanted - filled_,
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

void FileWindow::LoadFrames(uint64_t offset, size_t size) {
  const FrameTable& table = *source_->frames;
  begin_ = table.frames()[table.NumberAt(offset)].begin;
  filled_ = 0;
  for (size_t number = table.NumberAt(offset); begin_ + filled_ < offset + size; ++number) {
    const auto frame_bytes = static_cast<size_t>(table.frames()[number].size);
    if (filled_ == 0) {
      if (number == peeked_frame_) {
        std::swap(buffer_, peeked_);
        peeked_frame_ = SIZE_MAX;
      } else {
        Decode(number, &buffer_);
      }
    } else {
      std::vector<uint8_t> more;
      Decode(number, &more);
      buffer_.resize(filled_);
      buffer_.insert(buffer_.end(), more.begin(), more.end());
    }
    filled_ += frame_bytes;
  }
}

void FileWindow::Decode(size_t number, std::vector<uint8_t>* bytes) {
  const Frame& frame = source_->frames->frames()[number];
  if (decoder_.Decode(source_->file.get(), frame, bytes)) return;
  damaged_frames_.insert(number);
  bytes->assign(static_cast<size_t>(frame.size), 0);
}

std::string FileWindow::DamageAt(uint64_t offset) const {
  if (!source_->frames || offset >= source_->frames->size()) return {};
  const size_t number = source_->frames->NumberAt(offset);
  if (!damaged_frames_.contains(number)) return {};
  return "the frame that begins at byte " +
         std::to_string(source_->frames->frames()[number].file_begin) +
         " of the compressed file is damaged";
}

std::optional<uint32_t> FileWindow::PeekUint32(uint64_t offset) {
  std::array<uint8_t, 4> bytes;
  if (offset > size_ || size_ - offset < bytes.size()) return std::nullopt;
  if (offset >= begin_ && offset + bytes.size() <= begin_ + filled_) {
    std::copy_n(buffer_.begin() + static_cast<ptrdiff_t>(offset - begin_), 4, bytes.begin());
  } else if (source_->frames) {
    for (size_t i = 0; i < bytes.size(); ++i) {
      const size_t number = source_->frames->NumberAt(offset + i);
      if (number != peeked_frame_) Decode(number, &peeked_);
      peeked_frame_ = number;
      const uint64_t begin = source_->frames->frames()[number].begin;
      bytes[i] = peeked_[static_cast<size_t>(offset + i - begin)];
    }
  } else if (::pread(source_->file.get(), bytes.data(), 4, static_cast<off_t>(offset)) != 4) {
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
