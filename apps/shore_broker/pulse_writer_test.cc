#include "apps/shore_broker/pulse_writer.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::pulse_writer_test {

class PulseWriterTest : public testing::Test {
 protected:
  PulseWriterTest() {
    Subscribe(listener_, channels::ViewCommsPulse(),
              [this](const comms_pulses_t& message) { received_.push_back(message); });
  }
  void Deliver() {
    writer_.Flush(7);
    hub_.NextStep();
    hub_.HandleAll();
  }
  static Pulse PulseOfRange(double range_m) {
    return {.source = "james",
            .destination = "Ike",
            .from_m = {109.63, -60.06, 3},
            .to_m = {30.96, -60.22, 0},
            .range_m = range_m,
            .of_message = false,
            .color = "red"};
  }

  MemoryBus hub_;
  Bus& broker_ = hub_.Join("shore_broker");
  Bus& listener_ = hub_.Join("listener");
  std::vector<comms_pulses_t> received_;
  PulseWriter writer_{broker_};
};

TEST_F(PulseWriterTest, PublishesAllThatTheManualsExampleShows) {
  writer_.Add(7, PulseOfRange(78.67), 10);
  Deliver();
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_EQ(received_[0].utime, 7);
  ASSERT_EQ(received_[0].num_pulses, 1);
  const comms_pulse_t& pulse = received_[0].pulses[0];
  EXPECT_EQ(pulse.sx_m, 109.63);
  EXPECT_EQ(pulse.sy_m, -60.06);
  EXPECT_EQ(pulse.tx_m, 30.96);
  EXPECT_EQ(pulse.ty_m, -60.22);
  EXPECT_DOUBLE_EQ(pulse.beam_width_m, 7.867);
  EXPECT_EQ(pulse.duration_s, 10);
  EXPECT_EQ(pulse.fill, 0.35);
  EXPECT_EQ(pulse.label, "JAMES2IKE");
  EXPECT_EQ(pulse.ptype, "nrep");
  EXPECT_EQ(pulse.fill_color, "red");
  EXPECT_EQ(pulse.edge_color, "red");
  EXPECT_EQ(pulse.edge_size, 1);
}

TEST_F(PulseWriterTest, MakesNoBeamNarrowerThanFiveMetres) {
  for (const double range_m : {0.0, 49.9, 50.0, 50.1}) writer_.Add(7, PulseOfRange(range_m), 10);
  Deliver();
  EXPECT_EQ(received_.at(0).pulses.at(0).beam_width_m, 5);
  EXPECT_EQ(received_.at(0).pulses.at(1).beam_width_m, 5);
  EXPECT_EQ(received_.at(0).pulses.at(2).beam_width_m, 5);
  EXPECT_DOUBLE_EQ(received_.at(0).pulses.at(3).beam_width_m, 5.01);
}

TEST_F(PulseWriterTest, LetsAMessageReplaceNoReport) {
  Pulse pulse = PulseOfRange(1);
  pulse.of_message = true;
  writer_.Add(7, pulse, 10);
  Deliver();
  EXPECT_EQ(received_.at(0).pulses.at(0).label, "JAMES2IKE_MSG");
  EXPECT_EQ(received_.at(0).pulses.at(0).fill, 0.6);
  EXPECT_EQ(received_.at(0).pulses.at(0).ptype, "msg");
}

TEST_F(PulseWriterTest, PublishesNothingWithoutDurationOrColor) {
  writer_.Add(7, PulseOfRange(1), 0);
  for (const std::string_view color : {"off", "invisible"}) {
    Pulse pulse = PulseOfRange(1);
    pulse.color = color;
    writer_.Add(7, pulse, 10);
  }
  Deliver();
  EXPECT_TRUE(received_.empty());
}

TEST_F(PulseWriterTest, SplitsWhatIsTooLongForOneMessage) {
  for (int32_t i = 0; i < PulseWriter::kMaxPulsesPerMessage + 1; ++i) {
    writer_.Add(7, PulseOfRange(1), 10);
  }
  Deliver();
  ASSERT_EQ(received_.size(), 2U);
  EXPECT_EQ(received_[1].num_pulses, 1);
  Bytes bytes;
  EncodeInto(received_[0], &bytes);
  EXPECT_LT(bytes.size(), 65'000U) << "one datagram";
}

TEST_F(PulseWriterTest, KeepsPlacesOfAVehicleAndNamesOfTwoCasesApart) {
  Pulse moved = PulseOfRange(60);
  moved.to_m.x() += 1;
  Pulse back = PulseOfRange(60);
  std::swap(back.source, back.destination);
  std::swap(back.from_m, back.to_m);
  Pulse small = PulseOfRange(60);
  small.source = "JAMES";
  for (const Pulse& pulse : {PulseOfRange(60), moved, PulseOfRange(60), back, small}) {
    writer_.Add(7, pulse, 10);
  }
  writer_.Add(7, PulseOfRange(60), 3);
  Deliver();
  ASSERT_EQ(received_.size(), 1U);
  const auto& pulses = received_[0].pulses;
  ASSERT_EQ(pulses.size(), 6U);
  EXPECT_EQ(pulses[1].tx_m, pulses[0].tx_m + 1);
  EXPECT_EQ(pulses[2].tx_m, pulses[0].tx_m);
  EXPECT_EQ(pulses[3].label, "IKE2JAMES");
  EXPECT_EQ(pulses[3].sx_m, pulses[0].tx_m);
  EXPECT_EQ(pulses[3].ty_m, pulses[0].sy_m);
  EXPECT_EQ(pulses[4].label, "JAMES2IKE");
  EXPECT_EQ(pulses[4].duration_s, 10);
  EXPECT_EQ(pulses[5].duration_s, 3);
}

TEST_F(PulseWriterTest, NeedsAFewBytesForAPulseOfManyVehicles) {
  constexpr int kVehicles = 19;
  std::vector<std::string> names;
  for (int i = 0; i < kVehicles; ++i) names.push_back("vehicle_" + std::to_string(i));
  size_t num_bytes = 0;
  MemoryBus hub;
  hub.Join("bytes").SubscribeAll([&](const Message& message) { num_bytes += message.data.size(); });
  PulseWriter writer(hub.Join("shore_broker"));
  for (const std::string& source : names) {
    for (const std::string& destination : names) {
      if (source == destination) continue;
      Pulse pulse = PulseOfRange(80);
      pulse.source = source;
      pulse.destination = destination;
      writer.Add(7, pulse, 10);
    }
  }
  writer.Flush(7);
  hub.NextStep();
  hub.HandleAll();
  EXPECT_LT(num_bytes / (kVehicles * (kVehicles - 1)), 18U) << "115 as a list";
}

TEST(ReportColor, DistinguishesTwelveVehiclesAndIsNoMessagesDefault) {
  std::set<std::string_view> colors;
  for (int32_t index = 0; index < 12; ++index) colors.insert(ReportColor(index));
  EXPECT_EQ(colors.size(), 12U);
  EXPECT_FALSE(colors.contains("white"));
  EXPECT_FALSE(colors.contains("light_green"));
  EXPECT_EQ(ReportColor(12), ReportColor(0));
}

}  // namespace shoal::pulse_writer_test
