#include "lib/tools/view/packet_book.h"

#include <algorithm>
#include <cmath>

#include "lib/tools/view/stable_id.h"
#include "lib/tools/view/view_limits.h"

namespace shoal {

namespace {

int64_t InMicroseconds(double seconds) {
  constexpr double kLongest_s = 1e6;
  return std::isfinite(seconds)
             ? static_cast<int64_t>(std::clamp(seconds, -kLongest_s, kLongest_s) * 1e6)
             : 0;
}

/// One number for both. The product is unsigned, since numbers of any size come.
int64_t KindAndNumber(const FateFacts& facts) {
  return static_cast<int64_t>(kNumKinds * static_cast<uint64_t>(facts.number) +
                              static_cast<uint64_t>(facts.kind));
}

}  // namespace

void PacketBook::Add(const FateView& fate, const std::optional<std::pair<double, double>>& from_m) {
  const FateFacts& facts = fate.facts;
  if (!facts.has_path) return;
  while (!packets_.empty() && packets_.front().last_fate_utime + kMemory_us < facts.utime) {
    packets_.pop_front();
  }
  const std::string_view source = fate.source.substr(0, kMaxNameBytes);
  auto packet = std::find_if(packets_.rbegin(), packets_.rend(), [&](const AcousticPacket& known) {
    return known.number == facts.number && known.kind == facts.kind && known.source == source;
  });
  if (packet == packets_.rend()) {
    if (packets_.size() == kMaxPackets) packets_.pop_front();
    packets_.push_back({.id = StableId(source, KindAndNumber(facts)),
                        .source = std::string(source),
                        .kind = facts.kind,
                        .number = facts.number,
                        .sent_utime = facts.sent_utime,
                        .air_s = facts.air_s,
                        .last_fate_utime = facts.utime,
                        .from_m = from_m});
    packet = packets_.rbegin();
  }
  packet->order = ++last_order_;
  packet->last_fate_utime = facts.utime;
  if (packet->to.size() == kMaxArrivals) return;
  const double way_s = static_cast<double>(facts.travel_s) + static_cast<double>(facts.jitter_s) +
                       static_cast<double>(facts.air_s);
  packet->to.push_back({.name = std::string(fate.destination.substr(0, kMaxNameBytes)),
                        .utime = facts.sent_utime + InMicroseconds(way_s),
                        .cause = facts.cause});
}

std::vector<const AcousticPacket*> PacketBook::Since(int64_t order, int64_t utime) const {
  std::vector<const AcousticPacket*> found;
  for (const AcousticPacket& packet : packets_) {
    if (packet.order > order && utime <= packet.last_fate_utime + kMemory_us)
      found.push_back(&packet);
  }
  return found;
}

}  // namespace shoal
