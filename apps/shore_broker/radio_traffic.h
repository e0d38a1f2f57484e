// What the broker sends by radio, in the order in which it arrives.
//
//   RadioTraffic radio;
//   radio.Send(std::make_shared<Shipment>(...), leg, options, draws, sent_utime);
//   radio.Deliver(utime, [&](const LegEnd& end) { ... });
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "apps/shore_broker/shipment.h"

namespace shoal {

class RadioTraffic {
 public:
  /// Sends one leg of a shipment that the medium's rules let pass.
  void Send(std::shared_ptr<const Shipment> shipment, ShipmentLeg leg, const RadioOptions& options,
            const RadioDraws& draws, int64_t sent_utime);

  /// Calls `take` for each leg that has arrived, or was lost, by `utime`: in order of time, then of
  /// sending.
  void Deliver(int64_t utime, const TakeLegEnd& take);

  int64_t num_in_transit() const { return static_cast<int64_t>(queue_.size()); }
  /// Returns when the next leg ends; nothing where none is under way.
  std::optional<int64_t> NextUtime() const;

 private:
  struct UnderWay {
    std::shared_ptr<const Shipment> shipment;
    ShipmentLeg leg;
    int64_t sent_utime = 0;
    bool is_lost = false;
  };

  /// By arrival, and order of sending.
  struct Arrival {
    int64_t utime = 0;
    int64_t order = 0;
    size_t slot = 0;  ///< Into under_way_.
    bool operator>(const Arrival& other) const {
      return std::pair(utime, order) > std::pair(other.utime, other.order);
    }
  };

  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> queue_;
  std::deque<UnderWay> under_way_;  ///< Slots keep their memory and their places.
  std::vector<size_t> free_slots_;
  int64_t num_sent_ = 0;
};

}  // namespace shoal
