// A network in which sound bends: fates, and COMMS_ARRIVALS beside them.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_rays_test {

/// A modem over a bottom that swallows all, below water that bends sound down.
Mission BentWater() {
  Mission mission = QuietNetwork();
  AcousticOptions& options = mission.acoustics.options;
  mission.comms.comms_range_m = 10'000;
  options.modem = ModemPreset{.name = "test",
                              .low_khz = 24,
                              .high_khz = 32,
                              .data_rate_bps = 463,
                              .max_packet_bytes = 64,
                              .source_level_db = 168,
                              .typical_range_m = 2000,
                              .modulation = Modulation::kCoherentPsk,
                              .fading = Fading::kNone,
                              .code = {.block_bits = 127, .data_bits = 92, .corrected_bits = 5},
                              .sources = {}};
  options.packet_loss_model = PacketLossModel::kModem;
  options.rays.emplace();
  options.rays->profile = {{0, 1520}, {100, 1490}};
  options.rays->bottom = {1490, 1, 0};
  return mission;
}

class BentSound : public AcousticFixture {
 protected:
  BentSound() : AcousticFixture(BentWater()) {
    Subscribe(listener_, channels::CommsArrivals(),
              [this](const comms_arrivals_t& message) { arrivals_.push_back(message); });
  }

  /// alpha, and bravo so far from it, both 20 m deep, known to the broker.
  void BeginAt(double range_m) {
    for (const auto& [name, x_m] : {std::pair("alpha", 0.0), {"bravo", range_m}}) {
      node_report_t report = ReportFrom(name, x_m);
      report.depth_m = 20;
      Send(report);
    }
    Step();
  }

  /// Steps until a packet from alpha to bravo has a fate; returns what arrived.
  fate_arrivals_t ArrivalsOfOnePacket() {
    SendPacket("alpha", {1, 2, 3});
    EXPECT_GT(StepUntilFates(), 0);
    EXPECT_EQ(arrivals_.size(), 1U);
    if (arrivals_.empty() || arrivals_[0].arrivals.empty()) return {};
    return arrivals_[0].arrivals[0];
  }

  std::vector<comms_arrivals_t> arrivals_;
};

TEST_F(BentSound, PublishesThePathsOfAFate) {
  BeginAt(150);
  const fate_arrivals_t paths = ArrivalsOfOnePacket();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo delivered"});
  EXPECT_EQ(paths.kind, "packet");
  EXPECT_EQ(paths.source, "alpha");
  EXPECT_EQ(paths.destination, "bravo");
  EXPECT_EQ(paths.cause, "delivered");
  EXPECT_GT(paths.num_arrivals, 0);
  EXPECT_EQ(paths.shadow, "");
  EXPECT_LT(paths.signal_db, -40);
  EXPECT_GE(paths.delay_spread_s, 0);
}

TEST_F(BentSound, HasShadowsWithTheirReason) {
  BeginAt(4000);
  const fate_arrivals_t paths = ArrivalsOfOnePacket();
  EXPECT_EQ(Fates(), std::vector<std::string>{"alpha>bravo shadow_zone"});
  EXPECT_EQ(paths.cause, "shadow_zone");
  EXPECT_EQ(paths.shadow, "sound is slower below and bends down");
  EXPECT_EQ(paths.bottom_bounces, paths.num_arrivals > 0 ? 0 : -1);
}

class StraightSound : public AcousticFixture {};

TEST_F(StraightSound, PublishesNoPaths) {
  int num_messages = 0;
  Subscribe(listener_, channels::CommsArrivals(),
            [&](const comms_arrivals_t& /*message*/) { ++num_messages; });
  Begin();
  SendPacket("alpha", {1});
  EXPECT_GT(StepUntilFates(), 0);
  Step();
  EXPECT_EQ(num_messages, 0);
}

}  // namespace shoal::broker_rays_test
