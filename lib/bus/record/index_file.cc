#include "lib/bus/record/index_file.h"

#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "lib/base/codec/little_endian.h"
#include "lib/bus/os/read_file.h"
#include "lib/bus/os/replace_file.h"

namespace shoal {

namespace {

constexpr std::string_view kIndexMagic = "SHOALIDX";
constexpr uint32_t kIndexFormat = 1;
constexpr size_t kMaxKey_bytes = 4096;
constexpr size_t kMaxParts = 8;

constexpr int kIndexLevel = 1;

/// A part as it is in the file.
struct KeptPart {
  uint32_t number = 0;
  std::string key;
  uint64_t length = 0;  ///< Of the part; `bytes` are compressed.
  std::vector<uint8_t> bytes;
};

std::vector<uint8_t> HeadOf(const FileStamp& stamp) {
  std::vector<uint8_t> head(kIndexMagic.begin(), kIndexMagic.end());
  AppendLittleEndian(kIndexFormat, &head);
  AppendLittleEndian(stamp.size, &head);
  AppendLittleEndian(stamp.changed_ns, &head);
  AppendLittleEndian(stamp.digest, &head);
  return head;
}

/// Fills `bytes` from `offset` on; false: the file ends before, or cannot be read.
bool ReadFrom(int fd, uint64_t offset, std::span<uint8_t> bytes) {
  return ::pread(fd, bytes.data(), bytes.size(), static_cast<off_t>(offset)) ==
         static_cast<ssize_t>(bytes.size());
}

/// Returns the parts that `is_wanted` takes by their number. An index that does not begin with
/// `head` has none; of a damaged one, those before the damage are returned.
template <class IsWanted>
std::vector<KeptPart> PartsOf(const std::string& path, std::span<const uint8_t> head,
                              IsWanted is_wanted) {
  std::vector<KeptPart> parts;
  const Result<FileDescriptor> file = OpenRegularFile(path);
  struct stat status {};
  if (!file.ok() || ::fstat(file->get(), &status) != 0) return parts;
  const auto file_size = static_cast<uint64_t>(status.st_size);
  std::vector<uint8_t> begin(head.size());
  if (file_size > kMaxIndex_bytes || !ReadFrom(file->get(), 0, begin) ||
      !std::ranges::equal(begin, head)) {
    return parts;
  }
  uint64_t offset = head.size();
  for (size_t i = 0; i < kMaxParts && offset < file_size; ++i) {
    std::vector<uint8_t> row(
        static_cast<size_t>(std::min<uint64_t>(kMaxKey_bytes + 64, file_size - offset)));
    if (!ReadFrom(file->get(), offset, row)) break;
    LittleEndianReader reader(row);
    KeptPart part;
    uint64_t size = 0;
    uint64_t digest = 0;
    if (!reader.Take(&part.number) || !reader.TakeSizedText(&part.key) ||
        !reader.Take(&part.length) || !reader.Take(&size) || !reader.Take(&digest) ||
        part.key.size() > kMaxKey_bytes || part.length > kMaxIndex_bytes) {
      break;
    }
    offset += row.size() - reader.num_left();
    if (size > file_size - offset) break;
    if (is_wanted(part.number)) {
      part.bytes.resize(static_cast<size_t>(size));
      if (!ReadFrom(file->get(), offset, part.bytes) || DigestOf(part.bytes) != digest) break;
      parts.push_back(std::move(part));
    }
    offset += size;
  }
  return parts;
}

/// Returns false for a file that does not begin as an index does: it is another's, and is kept.
bool IsIndexOrAbsent(const std::string& path) {
  std::error_code error;
  if (std::filesystem::status(path, error).type() == std::filesystem::file_type::not_found) {
    return true;
  }
  std::array<char, kIndexMagic.size()> begin{};
  const Result<FileDescriptor> file = OpenRegularFile(path);
  if (!file.ok()) return false;
  const ssize_t length = ::pread(file->get(), begin.data(), begin.size(), 0);
  return length >= 0 && kIndexMagic.starts_with({begin.data(), static_cast<size_t>(length)});
}

std::optional<std::vector<uint8_t>> Decompressed(const KeptPart& part) {
  if (ZSTD_getFrameContentSize(part.bytes.data(), part.bytes.size()) != part.length) return {};
  std::vector<uint8_t> bytes(static_cast<size_t>(part.length));
  const size_t size =
      ZSTD_decompress(bytes.data(), bytes.size(), part.bytes.data(), part.bytes.size());
  return ZSTD_isError(size) == 0 && size == bytes.size() ? std::optional(std::move(bytes))
                                                         : std::nullopt;
}

}  // namespace

std::string IndexPath(const std::string& log) { return log + ".idx"; }

std::optional<std::vector<uint8_t>> ReadIndexPart(const LogReader& log, IndexPart part,
                                                  std::string_view key, uint64_t least_bytes) {
  std::error_code error;
  const std::string path = IndexPath(log.path());
  if (log.size() < least_bytes || !std::filesystem::is_regular_file(path, error)) return {};
  const auto is_it = [&](uint32_t number) { return number == static_cast<uint32_t>(part); };
  for (const KeptPart& kept : PartsOf(path, HeadOf(log.Stamp()), is_it)) {
    if (kept.key == key) return Decompressed(kept);
  }
  return std::nullopt;
}

void KeepIndexPart(const LogReader& log, IndexPart part, std::string_view key,
                   std::span<const uint8_t> bytes, uint64_t least_bytes) {
  if (log.size() < least_bytes || key.size() > kMaxKey_bytes || log.HasChanged()) return;
  const std::string path = IndexPath(log.path());
  if (!IsIndexOrAbsent(path)) return;
  const std::vector<uint8_t> head = HeadOf(log.Stamp());
  const auto is_other = [&](uint32_t number) { return number != static_cast<uint32_t>(part); };
  std::vector<KeptPart> parts = PartsOf(path, head, is_other);
  KeptPart& added = parts.emplace_back();
  added = {.number = static_cast<uint32_t>(part),
           .key = std::string(key),
           .length = bytes.size(),
           .bytes = std::vector<uint8_t>(ZSTD_compressBound(bytes.size()))};
  const size_t size = ZSTD_compress(added.bytes.data(), added.bytes.size(), bytes.data(),
                                    bytes.size(), kIndexLevel);
  if (ZSTD_isError(size) != 0 || bytes.size() > kMaxIndex_bytes) return;
  added.bytes.resize(size);
  std::vector<uint8_t> file = head;
  for (const KeptPart& kept : parts) {
    AppendLittleEndian(kept.number, &file);
    AppendSizedText(kept.key, &file);
    AppendLittleEndian(kept.length, &file);
    AppendLittleEndian(static_cast<uint64_t>(kept.bytes.size()), &file);
    AppendLittleEndian(DigestOf(kept.bytes), &file);
    file.insert(file.end(), kept.bytes.begin(), kept.bytes.end());
  }
  if (file.size() > kMaxIndex_bytes) return;
  // If it cannot be written, the log is read again the next time; nothing else is lost.
  (void)ReplaceFile(path, {reinterpret_cast<const char*>(file.data()), file.size()});
}

}  // namespace shoal
