#include "lib/bus/bus/lcm_assembler.h"

#include <algorithm>
#include <cstring>

#include "lib/bus/bus/big_endian.h"

namespace shoal {

namespace {

constexpr size_t kWholeHeader = 8;
constexpr size_t kFragmentHeader = 20;
/// What a piece costs beside its bytes: a node of a map.
constexpr size_t kPieceBytes = 64;

uint32_t ReadWord(std::span<const uint8_t> datagram, size_t begin) {
  return static_cast<uint32_t>(ReadBigEndian(datagram.subspan(begin, 4)));
}

/// Returns the channel name at the beginning of `bytes`; empty where none of 1 to 63 bytes ends
/// there.
std::string_view ReadChannel(std::span<const uint8_t> bytes) {
  const auto searched = bytes.first(std::min(bytes.size(), LcmAssembler::kMaxChannel + 1));
  const auto end = std::find(searched.begin(), searched.end(), uint8_t{0});
  if (end == searched.end()) return {};
  return {reinterpret_cast<const char*>(bytes.data()), static_cast<size_t>(end - searched.begin())};
}

}  // namespace

struct LcmAssembler::Header {
  uint32_t sequence = 0;
  uint32_t size = 0;    ///< Of the message.
  uint32_t offset = 0;  ///< In the message.
  uint16_t fragment = 0;
  uint16_t num_fragments = 0;
};

std::optional<LcmMessage> LcmAssembler::Add(uint64_t sender, std::span<const uint8_t> datagram) {
  const uint32_t magic = datagram.size() < kWholeHeader ? 0 : ReadWord(datagram, 0);
  if (magic == kLcmFragmentMagic) return AddFragment(sender, datagram);
  const std::string_view channel =
      magic == kLcmWholeMagic ? ReadChannel(datagram.subspan(kWholeHeader)) : std::string_view();
  if (channel.empty()) {
    ++num_malformed_;
    return std::nullopt;
  }
  return LcmMessage{.channel = channel,
                    .data = datagram.subspan(kWholeHeader + channel.size() + 1)};
}

std::optional<LcmMessage> LcmAssembler::AddFragment(uint64_t sender,
                                                    std::span<const uint8_t> datagram) {
  const auto refuse = [&]() -> std::optional<LcmMessage> {
    ++num_malformed_;
    return std::nullopt;
  };
  if (datagram.size() <= kFragmentHeader) return refuse();
  const Header header{
      .sequence = ReadWord(datagram, 4),
      .size = ReadWord(datagram, 8),
      .offset = ReadWord(datagram, 12),
      .fragment = static_cast<uint16_t>(ReadBigEndian(datagram.subspan(16, 2))),
      .num_fragments = static_cast<uint16_t>(ReadBigEndian(datagram.subspan(18, 2)))};
  auto part = datagram.subspan(kFragmentHeader);
  std::string_view channel;
  if (header.fragment == 0) {
    channel = ReadChannel(part);
    if (channel.empty() || header.offset != 0) return refuse();
    part = part.subspan(channel.size() + 1);
  }
  // No fragment is empty, so there are no more of them than bytes.
  if (part.empty() || header.size > kMaxPendingBytes || header.offset > header.size ||
      part.size() > header.size - header.offset || header.fragment >= header.num_fragments ||
      header.num_fragments > header.size) {
    return refuse();
  }
  const auto found = Await(sender, header);
  Pending& pending = found->second;
  if (pending.size != header.size || pending.num_fragments != header.num_fragments) return refuse();
  const auto [piece, is_new] = pending.pieces.try_emplace(header.fragment);
  if (!is_new) return std::nullopt;  // Sent twice.
  piece->second = {.offset = header.offset, .size = static_cast<uint32_t>(part.size())};
  pending.num_bytes += kPieceBytes;
  pending_bytes_ += kPieceBytes;
  if (header.fragment == 0) pending.channel = channel;
  std::memcpy(pending.data.get() + header.offset, part.data(), part.size());
  if (pending.pieces.size() < pending.num_fragments) {
    MakeRoom(0, found->first);
    return std::nullopt;
  }
  // All are there: they must be the message, without gaps or overlaps.
  uint32_t end = 0;
  const bool fills =
      std::all_of(pending.pieces.begin(), pending.pieces.end(), [&](const auto& each) {
        const bool follows = each.second.offset == end;
        end += each.second.size;
        return follows;
      });
  done_ = std::move(pending);
  Forget(found);
  if (!fills || end != done_.size) return refuse();
  return LcmMessage{.channel = done_.channel, .data = {done_.data.get(), done_.size}};
}

/// Returns the message of which `header` is a fragment; begins one where it is the first to come.
LcmAssembler::PendingMap::iterator LcmAssembler::Await(uint64_t sender, const Header& header) {
  const Key key(sender, header.sequence);
  const auto found = pending_.find(key);
  if (found != pending_.end()) return found;
  GiveUpOldestOf(sender);
  MakeRoom(header.size, key);
  pending_bytes_ += header.size;
  return pending_
      .emplace(key, Pending{.size = header.size,
                            .num_fragments = header.num_fragments,
                            .order = order_++,
                            .channel = {},
                            .pieces = {},
                            .num_bytes = header.size,
                            .data = std::make_unique_for_overwrite<uint8_t[]>(header.size)})
      .first;
}

void LcmAssembler::Forget(PendingMap::iterator pending) {
  pending_bytes_ -= pending->second.num_bytes;
  pending_.erase(pending);
}

/// Gives up the oldest message of a sender that has as many as it may.
void LcmAssembler::GiveUpOldestOf(uint64_t sender) {
  const auto begin = pending_.lower_bound({sender, 0});
  size_t num_pending = 0;
  auto oldest = begin;
  for (auto each = begin; each != pending_.end() && each->first.first == sender; ++each) {
    ++num_pending;
    if (each->second.order < oldest->second.order) oldest = each;
  }
  if (num_pending < kMaxPendingOfSender) return;
  ++num_abandoned_;
  Forget(oldest);
}

/// Gives up the oldest messages, until there is room for one more of `num_bytes`. `kept` stays.
void LcmAssembler::MakeRoom(size_t num_bytes, const Key& kept) {
  const size_t num_more = num_bytes == 0 ? 0 : 1;
  while (pending_bytes_ + num_bytes > kMaxPendingBytes ||
         pending_.size() + num_more > kMaxPending) {
    auto oldest = pending_.end();
    for (auto each = pending_.begin(); each != pending_.end(); ++each) {
      if (each->first == kept) continue;
      if (oldest == pending_.end() || each->second.order < oldest->second.order) oldest = each;
    }
    if (oldest == pending_.end()) return;
    ++num_abandoned_;
    Forget(oldest);
  }
}

}  // namespace shoal
