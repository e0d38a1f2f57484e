#include "lib/bus/record/frame_writer.h"

#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <memory>

#include "lib/base/check/check.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/bus/record/own_mark.h"

namespace shoal {

namespace {

/// The fastest of zstd's usual levels. Logs become a twentieth of their size; slower levels save a
/// tenth of that. It is fixed, so that equal logs are equal files.
constexpr int kLevel = 1;
/// Larger buffers are freed: one event may be of any size, and the next ones small again.
constexpr size_t kMaxSpare_bytes = size_t{4} << 20;

void PutLittleEndian(uint32_t value, std::vector<uint8_t>* bytes) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes->push_back(static_cast<uint8_t>(value >> shift));
  }
}

void PutOwnMark(std::vector<uint8_t>* bytes) {
  PutLittleEndian(kOwnMarkMagic, bytes);
  PutLittleEndian(static_cast<uint32_t>(kOwnMark.size()), bytes);
  bytes->insert(bytes->end(), kOwnMark.begin(), kOwnMark.end());
}

bool WriteBytes(int fd, std::span<const uint8_t> bytes) {
  return WriteAll(fd, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

struct FreeContext {
  void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};

/// Returns the frame of `bytes`, with size and checksum. It lies in `room`, which grows as needed.
std::span<const uint8_t> Compress(ZSTD_CCtx* context, const std::vector<uint8_t>& bytes,
                                  std::vector<uint8_t>* room) {
  const size_t bound = ZSTD_compressBound(bytes.size());
  if (room->size() < bound) room->resize(bound);
  const size_t size =
      ZSTD_compress2(context, room->data(), room->size(), bytes.data(), bytes.size());
  SHOAL_CHECK(ZSTD_isError(size) == 0, "zstd compresses into a buffer of its bound");
  return std::span<const uint8_t>(*room).first(size);
}

}  // namespace

FrameWriter::FrameWriter(FileDescriptor file)
    : file_(std::move(file)), thread_([this] { Work(); }) {}

FrameWriter::~FrameWriter() { End(); }

bool FrameWriter::Add(std::vector<uint8_t>* bytes, int64_t num_events) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < kMaxWaiting || error_number_ != 0; });
  if (error_number_ != 0) {
    Drop(num_events, bytes->size());
    bytes->clear();
    return false;
  }
  waiting_.push_back({std::exchange(*bytes, {}), num_events});
  if (!spare_.empty()) {
    std::swap(*bytes, spare_.back());
    spare_.pop_back();
  }
  changed_.notify_all();
  return true;
}

void FrameWriter::Work() {
  const std::unique_ptr<ZSTD_CCtx, FreeContext> context(ZSTD_createCCtx());
  SHOAL_CHECK(context != nullptr, "zstd has memory for a context");
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  std::vector<uint8_t> mark;
  PutOwnMark(&mark);
  const int mark_error_number = Write(mark, 0) ? 0 : errno;
  std::unique_lock lock(mutex_);
  error_number_ = mark_error_number;
  while (true) {
    changed_.wait(lock, [&] { return !waiting_.empty() || is_over_; });
    if (waiting_.empty()) return;
    Waiting frame = std::move(waiting_.front());
    waiting_.pop_front();
    if (error_number_ == 0) {
      lock.unlock();
      const auto compressed = Compress(context.get(), frame.bytes, &compressed_);
      const int error_number = Write(compressed, frame.bytes.size()) ? 0 : errno;
      lock.lock();
      error_number_ = error_number;
    }
    if (error_number_ != 0) Drop(frame.num_events, frame.bytes.size());
    frame.bytes.clear();
    if (frame.bytes.capacity() <= kMaxSpare_bytes) spare_.push_back(std::move(frame.bytes));
    changed_.notify_all();
  }
}

/// Writes a frame, which holds `size` bytes of the log; false: errno states why.
bool FrameWriter::Write(std::span<const uint8_t> compressed, size_t size) {
  if (WriteBytes(file_.get(), compressed)) {
    written_.emplace_back(compressed.size(), size);
    file_size_ += compressed.size();
    return true;
  }
  const int error_number = errno;
  // Leaves whole frames; where even that fails (such as on a device), readers find the cut.
  (void)!::ftruncate(file_.get(), static_cast<off_t>(file_size_));
  errno = error_number;
  return false;
}

void FrameWriter::Drop(int64_t num_events, size_t num_bytes) {
  dropped_.events += num_events;
  dropped_.bytes += static_cast<int64_t>(num_bytes);
}

void FrameWriter::End() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

bool FrameWriter::Close() {
  End();
  if (error_number_ != 0) return false;
  std::vector<uint8_t> list;
  PutLittleEndian(0x184D2A5E, &list);
  PutLittleEndian(static_cast<uint32_t>(8 * written_.size() + 9), &list);
  for (const auto& [compressed_bytes, bytes] : written_) {
    PutLittleEndian(compressed_bytes, &list);
    PutLittleEndian(bytes, &list);
  }
  PutLittleEndian(static_cast<uint32_t>(written_.size()), &list);
  list.push_back(0);  // Without checksums in the list: each frame has its own.
  PutLittleEndian(0x8F92EAB1, &list);
  if (!WriteBytes(file_.get(), list)) {
    error_number_ = errno;
    // Readers find the frames without the list.
    (void)!::ftruncate(file_.get(), static_cast<off_t>(file_size_));
    return false;
  }
  if (!file_.Close()) error_number_ = errno;
  return error_number_ == 0;
}

int FrameWriter::error_number() const {
  const std::lock_guard lock(mutex_);
  return error_number_;
}

FrameWriter::Dropped FrameWriter::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace shoal
