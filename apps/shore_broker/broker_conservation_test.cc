// Any traffic, by any rules: every transmission has one fate, or is still in transit.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "apps/shore_broker/water_testing.h"

namespace shoal::broker_conservation_test {

RC_GTEST_PROP(BrokerAcoustics, LosesTrackOfNothing, ()) {
  Mission mission = AcousticReports();
  AcousticOptions& options = mission.acoustics.options;
  const auto choose = [](auto* choice, int num) {
    *choice = static_cast<std::remove_pointer_t<decltype(choice)>>(*rc::gen::inRange(0, num));
  };
  choose(&options.jitter, 2);
  choose(&options.collisions, 3);
  choose(&options.packet_loss_model, 4);
  choose(&options.bit_error_model, 4);
  options.packet_loss = 0.3;
  options.half_duplex = *rc::gen::arbitrary<bool>();
  mission.acoustics.crc = *rc::gen::arbitrary<bool>();
  mission.comms.reports_over = *rc::gen::element(Over("direct"), Over("acoustic"));
  mission.comms.stale_forget_s = 3;
  mission.comms.min_msg_interval_s = -1;
  MemoryBus hub;
  Bus& broker_bus = hub.Join("shore_broker");
  Bus& others = hub.Join("others");
  ShoreBrokerApp broker(mission, broker_bus);
  std::array<int64_t, kNumKinds> num_published = {};
  int64_t num_handed_over = 0;
  Subscribe(others, channels::CommsFates(), [&](const comms_fates_t& message) {
    for (const fate_t& fate : message.fates) {
      for (int kind = 0; kind < kNumKinds; ++kind) {
        if (fate.kind == KindText(static_cast<Kind>(kind))) {
          num_published[static_cast<size_t>(kind)] += fate.count;
        }
      }
      if (fate.cause == "delivered" || fate.cause == "damaged") ++num_handed_over;
    }
  });
  int64_t num_received = 0;
  others.SubscribeAll([&](const Message& message) {
    const bool is_for_a_vehicle =
        message.channel.ends_with("_ALPHA") || message.channel.ends_with("_BRAVO") ||
        message.channel.ends_with("_NEMO") || message.channel.ends_with("_DORY");
    if (message.publisher == "shore_broker" && is_for_a_vehicle) ++num_received;
  });
  const std::vector<std::string> names = {"alpha", "bravo", "nemo", "dory"};
  const auto name = [&] { return *rc::gen::elementOf(names); };
  for (int step = 0; step < 60; ++step) {
    const int num_inputs = *rc::gen::inRange(0, 4);
    for (int i = 0; i < num_inputs; ++i) {
      switch (*rc::gen::inRange(0, 4)) {
        case 0:
          Publish(others, channels::NodeReportLocal(),
                  ReportFrom(name(), *rc::gen::inRange(0, 300)));
          break;
        case 1:
          Publish(others, channels::NodeMessageLocal(), MessageFrom(name(), name()));
          break;
        case 2: {
          acoustic_tx_t packet = {};
          packet.source = name();
          packet.num_bytes = *rc::gen::inRange(0, 60);
          packet.payload.resize(static_cast<size_t>(packet.num_bytes));
          Publish(others, channels::AcousticTx(), packet);
          break;
        }
        default:
          break;
      }
    }
    hub.NextStep();
    hub.HandleAll();
    broker.Tick(kStart_utime + step * kStep_us);
    hub.NextStep();
    hub.HandleAll();
    for (int kind = 0; kind < kNumKinds; ++kind) {
      const CauseCounts& counts = broker.router().counts(static_cast<Kind>(kind));
      const int64_t in_transit = counts[static_cast<size_t>(Cause::kInTransit)];
      RC_ASSERT(std::accumulate(counts.begin(), counts.end(), int64_t{0}) - in_transit ==
                num_published[static_cast<size_t>(kind)]);
    }
    RC_ASSERT(num_received == num_handed_over);
  }
}

}  // namespace shoal::broker_conservation_test
