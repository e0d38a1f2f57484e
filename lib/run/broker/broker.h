// A broker as the rebroker sees it (lib/tools/rebroker/rebroker.h): an app that knows when it
// delivers something next. apps/shore_broker is one.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "lib/bus/bus/bus.h"
#include "lib/run/broker/broker_setup.h"
#include "lib/run/run/app.h"

namespace shoal {

class Broker : public App {
 public:
  /// Returns a mission time before which nothing arrives over the acoustic network, unless more is
  /// sent; nothing where nothing is in transit.
  virtual std::optional<int64_t> NextArrivalUtime() const = 0;
};

using MakeBroker = std::function<std::unique_ptr<Broker>(const BrokerSetup& setup, Bus& bus)>;

}  // namespace shoal
