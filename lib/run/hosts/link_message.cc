#include "lib/run/hosts/link_message.h"

#include <fmt/format.h>
#include <sodium.h>

#include <algorithm>
#include <array>

#include "lib/base/check/check.h"
#include "lib/base/text/terminal_text.h"
#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

constexpr uint32_t kLinkMagic = 0x53484c31;
constexpr size_t kDigestSize = 32;
constexpr size_t kLinkHeaderSize = 4 + 1 + 8 + 8 + 8 + 4;
constexpr size_t kPartHeaderSize = 2 + 4;
constexpr size_t kLongestPartName = 65'535;

struct LinkRow {
  LinkKind kind;
  LinkLimits limits;
};

constexpr size_t kNoContent_bytes = 1024;
constexpr size_t kFewTexts_bytes = size_t{64} << 10;
constexpr size_t kTexts_bytes = size_t{1} << 20;
constexpr size_t kPage_bytes = size_t{4} << 20;
/// `shoal doctor --host` sends 4 MiB at a time.
constexpr size_t kLoads_bytes = size_t{5} << 20;

/// Only what carries a step or a mission is large.
constexpr std::array<LinkRow, 13> kLinkRows = {{
    {LinkKind::kOffer, {kLargestLinkMessage_bytes, kMaxLinkParts}},
    {LinkKind::kAccept, {kNoContent_bytes, 0}},
    {LinkKind::kRefuse, {kTexts_bytes, 1}},
    {LinkKind::kTick, {kLargestLinkMessage_bytes, kMaxLinkParts}},
    {LinkKind::kDone, {kLargestLinkMessage_bytes, kMaxLinkParts}},
    {LinkKind::kAside, {kPage_bytes, 1}},
    {LinkKind::kStart, {kFewTexts_bytes, 1}},
    {LinkKind::kSignal, {kFewTexts_bytes, 2}},
    {LinkKind::kExit, {kTexts_bytes, 32}},
    {LinkKind::kAlive, {kNoContent_bytes, 0}},
    {LinkKind::kEnd, {kNoContent_bytes, 0}},
    {LinkKind::kPing, {kLoads_bytes, 1}},
    {LinkKind::kPong, {kLoads_bytes, 2}},
}};
static_assert(kLinkRows.size() == static_cast<size_t>(LinkKind::kPong));

using LinkDigest = std::array<uint8_t, kDigestSize>;

LinkDigest LinkDigestOf(std::span<const uint8_t> bytes) {
  static const int is_ready = sodium_init();
  SHOAL_CHECK(is_ready >= 0, "libsodium works on this machine");
  LinkDigest digest{};
  crypto_generichash(digest.data(), digest.size(), bytes.data(), bytes.size(), nullptr, 0);
  return digest;
}

/// Reads numbers and bytes off the front of a span.
class ByteReader {
 public:
  explicit ByteReader(std::span<const uint8_t> bytes) : rest_(bytes) {}

  std::span<const uint8_t> Take(size_t size) {
    if (size > rest_.size()) {
      is_sound_ = false;
      size = rest_.size();
    }
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }
  uint64_t Number(size_t size) { return ReadBigEndian(Take(size)); }
  bool is_sound() const { return is_sound_; }
  bool empty() const { return rest_.empty(); }
  size_t size() const { return rest_.size(); }

 private:
  std::span<const uint8_t> rest_;
  bool is_sound_ = true;
};

}  // namespace

LinkLimits LimitsOf(LinkKind kind) {
  const auto row = std::ranges::find(kLinkRows, kind, &LinkRow::kind);
  SHOAL_CHECK(row != kLinkRows.end(), "each kind has a row");
  return row->limits;
}

const LinkPart* LinkMessage::Find(std::string_view name) const {
  const auto found = std::find_if(parts.begin(), parts.end(),
                                  [&](const LinkPart& part) { return part.name == name; });
  return found == parts.end() ? nullptr : &*found;
}

std::string LinkMessage::TextOf(std::string_view name) const {
  const LinkPart* part = Find(name);
  if (part == nullptr) return {};
  return TerminalLine({reinterpret_cast<const char*>(part->data.data()), part->data.size()});
}

void LinkMessage::AddText(std::string_view name, std::string_view text) {
  parts.push_back({.name = std::string(name), .data = Bytes(text.begin(), text.end())});
}

Bytes EncodeLinkMessage(const LinkMessage& message, uint64_t sequence) {
  size_t size = kLinkHeaderSize + kDigestSize;
  for (const LinkPart& part : message.parts) {
    SHOAL_CHECK(part.name.size() <= kLongestPartName, "a part's name has at most 65,535 bytes");
    size += kPartHeaderSize + part.name.size() + part.data.size();
  }
  Bytes bytes;
  bytes.reserve(size);
  AppendBigEndian(kLinkMagic, 4, &bytes);
  AppendBigEndian(static_cast<uint64_t>(message.kind), 1, &bytes);
  AppendBigEndian(static_cast<uint64_t>(message.mission_id), 8, &bytes);
  AppendBigEndian(static_cast<uint64_t>(message.step), 8, &bytes);
  AppendBigEndian(sequence, 8, &bytes);
  AppendBigEndian(message.parts.size(), 4, &bytes);
  for (const LinkPart& part : message.parts) {
    AppendBigEndian(part.name.size(), 2, &bytes);
    AppendBigEndian(part.data.size(), 4, &bytes);
    bytes.insert(bytes.end(), part.name.begin(), part.name.end());
    bytes.insert(bytes.end(), part.data.begin(), part.data.end());
  }
  const LinkDigest digest = LinkDigestOf(bytes);
  bytes.insert(bytes.end(), digest.begin(), digest.end());
  return bytes;
}

Result<LinkMessage> LinkIntake::Refuse(std::string why) {
  ++num_refused_;
  return Error{std::move(why)};
}

Result<LinkMessage> LinkIntake::Take(std::span<const uint8_t> bytes) {
  // Without a look at it: what follows a lost one is of no use, however much comes.
  if (has_gap_) return Refuse("a batch that follows a lost one");
  if (bytes.size() > kLargestLinkMessage_bytes) {
    return Refuse(fmt::format("a batch of {} bytes; the largest has {}", bytes.size(),
                              kLargestLinkMessage_bytes));
  }
  if (bytes.size() < kLinkHeaderSize + kDigestSize) {
    return Refuse(fmt::format("a torn batch: {} bytes", bytes.size()));
  }
  const auto content = bytes.first(bytes.size() - kDigestSize);
  ByteReader reader(content);
  if (reader.Number(4) != kLinkMagic) return Refuse("a batch of another program or version");
  if (sodium_memcmp(LinkDigestOf(content).data(), bytes.last(kDigestSize).data(), kDigestSize) !=
      0) {
    return Refuse("a torn batch: its digest does not fit its bytes");
  }
  LinkMessage message;
  const uint64_t kind = reader.Number(1);
  if (kind < 1 || kind > static_cast<uint64_t>(LinkKind::kPong)) {
    return Refuse(fmt::format("a batch of unknown kind {}", kind));
  }
  message.kind = static_cast<LinkKind>(kind);
  message.mission_id = static_cast<int64_t>(reader.Number(8));
  const LinkLimits limits = LimitsOf(message.kind);
  if (bytes.size() > limits.bytes) {
    return Refuse(fmt::format("a batch of kind {} with {} bytes; the largest has {}", kind,
                              bytes.size(), limits.bytes));
  }
  message.step = static_cast<int64_t>(reader.Number(8));
  const uint64_t sequence = reader.Number(8);
  if (sequence < next_sequence_) {
    return Refuse(
        fmt::format("a replayed batch: number {}, where {} is next", sequence, next_sequence_));
  }
  if (sequence > next_sequence_) {
    has_gap_ = true;
    return Refuse(
        fmt::format("batch number {}, where {} is next: one was lost", sequence, next_sequence_));
  }
  if (mission_id_ != 0 && message.mission_id != mission_id_) {
    return Refuse(fmt::format("a batch of another mission ({}, where {} runs)", message.mission_id,
                              mission_id_));
  }
  const uint64_t count = reader.Number(4);
  if (count > limits.parts) {
    return Refuse(fmt::format("a batch of kind {} with {} messages; the most are {}", kind, count,
                              limits.parts));
  }
  // Before room is made for them.
  if (count > reader.size() / kPartHeaderSize) {
    return Refuse(fmt::format("a batch that states {} messages and holds others", count));
  }
  message.parts.reserve(count);
  for (uint64_t i = 0; i < count && reader.is_sound(); ++i) {
    const size_t name_size = reader.Number(2);
    const size_t data_size = reader.Number(4);
    const auto name = reader.Take(name_size);
    const auto data = reader.Take(data_size);
    message.parts.push_back(
        {.name = std::string(name.begin(), name.end()), .data = Bytes(data.begin(), data.end())});
  }
  if (!reader.is_sound() || !reader.empty()) {
    return Refuse(fmt::format("a batch that states {} messages and holds others", count));
  }
  ++next_sequence_;
  return message;
}

}  // namespace shoal
