// What the broker sends by radio, in the order in which it arrives.
//
//   RadioTraffic radio;
//   radio.Send(std::make_shared<Shipment>(...), leg, options, draw, sent_utime);
//   radio.Deliver(utime, [&](const LegEnd& end) { ... });
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "apps/shore_broker/shipment.h"

namespace shoal {

class RadioTraffic {
 public:
  /// Sends one leg of a shipment that the medium's rules let pass.
  void Send(std::shared_ptr<const Shipment> shipment, ShipmentLeg leg, const RadioOptions& options,
            const RadioDraw& draw, int64_t sent_utime);

  /// Calls `take` for each leg that has arrived, or was lost, by `utime`: in order of time, then of
  /// sending.
  void Deliver(int64_t utime, const TakeLegEnd& take);

  int64_t num_in_transit() const { return static_cast<int64_t>(under_way_.size()); }
  /// Returns when the next leg ends; nothing where none is under way.
  std::optional<int64_t> NextUtime() const;

 private:
  struct UnderWay {
    std::shared_ptr<const Shipment> shipment;
    ShipmentLeg leg;
    int64_t sent_utime = 0;
    bool is_lost = false;
  };

  std::map<std::pair<int64_t, int64_t>, UnderWay>
      under_way_;  ///< By arrival, and order of sending.
  int64_t num_sent_ = 0;
};

}  // namespace shoal
