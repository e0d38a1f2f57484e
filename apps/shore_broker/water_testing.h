// For tests: a broker with an acoustic network without losses.
#pragma once

#include <gtest/gtest.h>

#include "apps/shore_broker/broker_testing.h"

namespace shoal {

/// One channel for both, 1000 bit/s, no loss, no errors, no jitter.
inline Mission QuietNetwork() {
  Mission mission = TwoVehicles();
  mission.acoustics.is_used = true;
  AcousticOptions& options = mission.acoustics.options;
  options.access_mode = AccessMode::kShared;
  options.jitter = JitterModel::kOff;
  options.packet_loss_model = PacketLossModel::kOff;
  options.bit_error_model = BitErrorModel::kOff;
  return mission;
}

class AcousticFixture : public BrokerFixture {
 protected:
  explicit AcousticFixture(const Mission& mission = QuietNetwork()) : BrokerFixture(mission) {}

  /// alpha at the origin, bravo 150 m from it, known to the broker.
  void Begin() {
    Send(ReportFrom("alpha", 0));
    Send(ReportFrom("bravo", 150));
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
inline Mission AcousticReports() {
  Mission mission = QuietNetwork();
  mission.comms.reports_over = Over("acoustic");
  mission.comms.messages_over = Over("acoustic");
  return mission;
}

}  // namespace shoal
