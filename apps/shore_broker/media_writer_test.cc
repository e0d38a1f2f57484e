#include "apps/shore_broker/media_writer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::media_writer_test {

class MediaWriterTest : public testing::Test {
 protected:
  MediaWriterTest() {
    listener_.SubscribeBytes(channels::CommsMedia().name, [this](const Message& message) {
      messages_.emplace_back(message.data.begin(), message.data.end());
    });
    shipment_.source = "alpha";
    shipment_.provenance = {.origin = "delta", .number = 7, .made_utime = 1, .via = "buoy:alpha"};
    leg_.destination = "bravo";
    leg_.medium = {.name = "vhf", .radio = {}, .loss_probability = 0.25, .delay_s = 0.5};
    leg_.medium.radio = {.fault = RadioFault::kNone,
                         .depth_m = 1,
                         .depth_limit_m = 2,
                         .range_m = 3,
                         .limit_m = 4,
                         .horizon_m = 5,
                         .path_loss_db = 6,
                         .path_loss_limit_db = 7};
  }

  void Add(int64_t number) {
    const Decision decision = {.number = number, .kind = Kind::kReport, .cause = Cause::kDelivered};
    writer_.Add(9, decision, shipment_,
                {.shipment = shipment_, .leg = leg_, .cause = Cause::kDelivered});
  }
  void Flush() {
    writer_.Flush(10);
    hub_.NextStep();
    hub_.HandleAll();
  }

  MemoryBus hub_;
  Bus& listener_ = hub_.Join("listener");
  MediaWriter writer_{hub_.Join("broker")};
  Shipment shipment_;
  ShipmentLeg leg_;
  std::vector<Bytes> messages_;
};

TEST_F(MediaWriterTest, WritesTheBytesOfTheMessage) {
  Add(11);
  leg_.medium = {};
  shipment_.provenance.via = "";
  Add(12);
  Flush();
  ASSERT_EQ(messages_.size(), 1U);
  comms_media_t media;
  ASSERT_TRUE(Decode(messages_[0], &media));
  EXPECT_EQ(media.utime, 10);
  ASSERT_EQ(media.media.size(), 2U);
  const fate_medium_t& fate = media.media[0];
  EXPECT_EQ(fate.kind + fate.source + fate.destination + fate.cause + fate.medium + fate.origin,
            "reportalphabravodeliveredvhfdelta");
  EXPECT_EQ(fate.number, 11);
  EXPECT_EQ(fate.hop, 2);
  EXPECT_EQ((std::vector<double>{fate.depth_m, fate.depth_limit_m, fate.range_m, fate.limit_m,
                                 fate.horizon_m, fate.path_loss_db, fate.path_loss_limit_db,
                                 fate.loss_probability, fate.delay_s}),
            (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 0.25, 0.5}));
  EXPECT_EQ(media.media[1].medium, "");
  EXPECT_EQ(media.media[1].hop, 0);
  Bytes again;
  EncodeInto(media, &again);
  EXPECT_EQ(again, messages_[0]);
}

TEST_F(MediaWriterTest, BeginsAnotherMessageWhereOneIsFull) {
  for (int64_t number = 0; number < MediaWriter::kMaxPerMessage + 1; ++number) Add(number);
  Flush();
  Flush();
  ASSERT_EQ(messages_.size(), 2U);
  comms_media_t media;
  ASSERT_TRUE(Decode(messages_[1], &media));
  ASSERT_EQ(media.media.size(), 1U);
  EXPECT_EQ(media.media[0].number, MediaWriter::kMaxPerMessage);
}

}  // namespace shoal::media_writer_test
