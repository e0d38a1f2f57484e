#include "apps/shore_broker/media_writer.h"

#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string_view>

#include "lib/sea/media/relay_path.h"

namespace shoal {

namespace {

/// Writes the members of an LCM message, in their order, into bytes that have room for them.
class WireWriter {
 public:
  explicit WireWriter(uint8_t* next) : next_(next) {}

  static size_t SizeOf(std::string_view text) { return sizeof(int32_t) + text.size() + 1; }

  void Int32(int32_t value) { Write(__builtin_bswap32(static_cast<uint32_t>(value))); }
  void Int64(int64_t value) { Write(__builtin_bswap64(static_cast<uint64_t>(value))); }
  void Double(double value) { Write(__builtin_bswap64(std::bit_cast<uint64_t>(value))); }
  void Text(std::string_view text) {
    Int32(static_cast<int32_t>(text.size()) + 1);
    if (!text.empty()) std::memcpy(next_, text.data(), text.size());
    next_ += text.size();
    *next_++ = 0;
  }

 private:
  static_assert(std::endian::native == std::endian::little);
  template <class T>
  void Write(T value) {
    std::memcpy(next_, &value, sizeof(T));
    next_ += sizeof(T);
  }

  uint8_t* next_;
};

}  // namespace

void MediaWriter::Add(int64_t utime, const Decision& decision, const Shipment& shipment,
                      const LegEnd& end) {
  if (num_fates_ == kMaxPerMessage) Flush(utime);
  ++num_fates_;
  const LegMedium& medium = end.leg.medium;
  const RadioLink& radio = medium.radio;
  double range_m = radio.range_m;
  double delay_s = medium.delay_s;
  if (end.reception != nullptr) {
    range_m = end.reception->range_m;
    if (end.reception->travel_s >= 0) delay_s = end.reception->end_s - end.reception->sent_s;
  }
  const std::array<std::string_view, 4> texts = {KindText(decision.kind), shipment.source,
                                                 end.leg.destination, CauseText(decision.cause)};
  const std::array<std::string_view, 2> more_texts = {medium.name, shipment.provenance.origin};
  const std::array<double, 9> numbers = {radio.depth_m,
                                         radio.depth_limit_m,
                                         range_m,
                                         radio.limit_m,
                                         radio.horizon_m,
                                         radio.path_loss_db,
                                         radio.path_loss_limit_db,
                                         medium.loss_probability,
                                         delay_s};
  size_t size = sizeof(int64_t) + sizeof(int32_t) + sizeof(numbers);
  for (const std::string_view text : texts) size += WireWriter::SizeOf(text);
  for (const std::string_view text : more_texts) size += WireWriter::SizeOf(text);
  if (message_.size() < num_bytes_ + size) message_.resize(2 * (num_bytes_ + size));
  WireWriter fate(message_.data() + num_bytes_);
  num_bytes_ += size;
  fate.Text(texts[0]);
  fate.Text(texts[1]);
  fate.Text(texts[2]);
  fate.Int64(decision.number);
  fate.Text(texts[3]);
  fate.Text(more_texts[0]);
  fate.Text(more_texts[1]);
  fate.Int32(NumHops(shipment.provenance.via));
  for (const double number : numbers) fate.Double(number);
}

void MediaWriter::Flush(int64_t utime) {
  if (num_fates_ == 0) return;
  WireWriter head(message_.data());
  head.Int64(comms_media_t::getHash());
  head.Int64(utime);
  head.Int32(num_fates_);
  bus_.PublishBytes(channel_.name, std::span(message_).first(num_bytes_));
  num_bytes_ = kHead_bytes;
  num_fates_ = 0;
}

}  // namespace shoal
