// Publishes on COMMS_MEDIA by which media and hops transmissions had their fates.
#pragma once

#include <cstdint>
#include <string_view>

#include "apps/shore_broker/shipment.h"
#include "lib/bus/bus.h"
#include "lib/bus/channels.h"

namespace shoal {

class MediaWriter {
 public:
  /// Fits one datagram, as with fates.
  static constexpr int32_t kMaxPerMessage = 200;

  explicit MediaWriter(Bus& bus);

  /// Adds one fate; publishes when the message is full.
  void Add(int64_t utime, const Decision& decision, const Shipment& shipment, const LegEnd& end);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  Bus& bus_;
  const Channel<comms_media_t> channel_ = channels::CommsMedia();
  comms_media_t message_;  ///< Keeps its strings' memory: only the first num_media are meant.
};

}  // namespace shoal
