// For tests: a broker beside calm water.
#pragma once

#include <gtest/gtest.h>

#include "apps/shore_broker/broker_fixture.h"

namespace shoal {

/// One channel for both, 1000 bit/s, no loss, no errors, no jitter.
inline Mission CalmWater() {
  Mission mission = TwoVehicles();
  mission.acoustics.is_used = true;
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.jitter = JitterModel::kOff;
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kOff;
  return mission;
}

class WaterFixture : public BrokerFixture {
 protected:
  explicit WaterFixture(const Mission& mission = CalmWater()) : BrokerFixture(mission) {}

  /// alpha at the origin, bravo 150 m from it, known to the broker.
  void Begin() {
    Say(ReportFrom("alpha", 0));
    Say(ReportFrom("bravo", 150));
    Step();
  }

  /// Steps until something was decided, and returns how many steps that took; 0: nothing was.
  int StepUntilFates(int at_most = 100) {
    for (int i = 1; i <= at_most; ++i) {
      Step();
      if (!fates_.empty()) return i;
    }
    return 0;
  }
};

/// The same, with reports, messages and acks over it.
inline Mission ReportsInWater() {
  Mission mission = CalmWater();
  mission.comms.reports_over = Medium::kAcoustic;
  mission.comms.messages_over = Medium::kAcoustic;
  return mission;
}

}  // namespace shoal
