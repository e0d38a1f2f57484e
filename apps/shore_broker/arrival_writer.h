// Publishes on COMMS_ARRIVALS by which paths of sound transmissions came, where sound bends.
#pragma once

#include <cstddef>
#include <cstdint>

#include "apps/shore_broker/shipment.h"
#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/channels.h"

namespace shoal {

class ArrivalWriter {
 public:
  /// Fits one datagram, as with fates.
  static constexpr size_t kMaxPerMessage = 150;

  explicit ArrivalWriter(Bus& bus) : bus_(bus), message_{} {}

  /// Adds one fate; publishes when the message is full. @pre end.reception->rays
  void Add(int64_t utime, const Decision& decision, const Shipment& shipment, const LegEnd& end);

  /// Publishes what was added since the last message, if anything.
  void Flush(int64_t utime);

 private:
  Bus& bus_;
  const Channel<comms_arrivals_t> channel_ = channels::CommsArrivals();
  comms_arrivals_t message_;
};

}  // namespace shoal
