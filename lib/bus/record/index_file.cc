#include "lib/bus/record/index_file.h"

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

struct KeptPart {
  uint32_t number = 0;
  std::string key;
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

/// Returns the parts of an index that begins with `head`; none of one that does not, and those in
/// front of what is damaged.
std::vector<KeptPart> PartsOf(const std::string& path, std::span<const uint8_t> head) {
  const FileText file = ReadRegularFile(path, kMaxIndex_bytes);
  const std::span bytes(reinterpret_cast<const uint8_t*>(file.text.data()), file.text.size());
  if (bytes.size() < head.size() || !std::equal(head.begin(), head.end(), bytes.begin())) return {};
  std::span<const uint8_t> rest = bytes.subspan(head.size());
  std::vector<KeptPart> parts;
  while (parts.size() < kMaxParts) {
    LittleEndianReader reader(rest);
    KeptPart part;
    uint64_t size = 0;
    uint64_t digest = 0;
    if (!reader.Take(&part.number) || !reader.TakeSizedText(&part.key) || !reader.Take(&size) ||
        !reader.Take(&digest) || part.key.size() > kMaxKey_bytes || reader.num_left() < size) {
      break;
    }
    const auto content = rest.subspan(rest.size() - reader.num_left(), static_cast<size_t>(size));
    if (DigestOf(content) != digest) break;
    part.bytes.assign(content.begin(), content.end());
    parts.push_back(std::move(part));
    rest = rest.subspan(rest.size() - reader.num_left() + static_cast<size_t>(size));
  }
  return parts;
}

}  // namespace

std::string IndexPath(const std::string& log) { return log + ".idx"; }

std::optional<std::vector<uint8_t>> ReadIndexPart(const LogReader& log, IndexPart part,
                                                  std::string_view key, uint64_t least_bytes) {
  std::error_code error;
  const std::string path = IndexPath(log.path());
  if (log.size() < least_bytes || !std::filesystem::is_regular_file(path, error)) return {};
  for (KeptPart& kept : PartsOf(path, HeadOf(log.Stamp()))) {
    if (kept.number == static_cast<uint32_t>(part) && kept.key == key) return std::move(kept.bytes);
  }
  return std::nullopt;
}

void KeepIndexPart(const LogReader& log, IndexPart part, std::string_view key,
                   std::span<const uint8_t> bytes, uint64_t least_bytes) {
  if (log.size() < least_bytes || key.size() > kMaxKey_bytes || log.HasChanged()) return;
  const std::string path = IndexPath(log.path());
  const std::vector<uint8_t> head = HeadOf(log.Stamp());
  std::vector<KeptPart> parts = PartsOf(path, head);
  std::erase_if(parts,
                [&](const KeptPart& kept) { return kept.number == static_cast<uint32_t>(part); });
  parts.push_back({.number = static_cast<uint32_t>(part),
                   .key = std::string(key),
                   .bytes = {bytes.begin(), bytes.end()}});
  std::vector<uint8_t> file = head;
  for (const KeptPart& kept : parts) {
    AppendLittleEndian(kept.number, &file);
    AppendSizedText(kept.key, &file);
    AppendLittleEndian(static_cast<uint64_t>(kept.bytes.size()), &file);
    AppendLittleEndian(DigestOf(kept.bytes), &file);
    file.insert(file.end(), kept.bytes.begin(), kept.bytes.end());
  }
  if (file.size() > kMaxIndex_bytes) return;
  // Without it the log is read again the next time, no more.
  (void)ReplaceFile(path, {reinterpret_cast<const char*>(file.data()), file.size()});
}

}  // namespace shoal
