// Publishes on COMMS_MEDIA by which media and hops transmissions had their fates.
#pragma once

#include <cstdint>

#include "apps/shore_broker/shipment.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

class MediaWriter {
 public:
  /// Fits one datagram, as with fates.
  static constexpr int32_t kMaxPerMessage = 200;

  explicit MediaWriter(Bus& bus) : bus_(bus) {}

  /// Adds one fate; publishes when the message is full.
  void Add(int64_t utime, const Decision& decision, const Shipment& shipment, const LegEnd& end);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  Bus& bus_;
  const Channel<comms_media_t> channel_ = channels::CommsMedia();
  static constexpr size_t kHead_bytes = 20;  ///< Hash, utime, count.

  /// The message, whose fates are encoded as they come: with comms_media_t in between they would
  /// take as long as all else that the broker does with a fate.
  Bytes message_;
  size_t num_bytes_ = kHead_bytes;  ///< Of it that are valid.
  int32_t num_fates_ = 0;
};

}  // namespace shoal
