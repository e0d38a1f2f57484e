#include "apps/shore_broker/fate_writer.h"

#include <gtest/gtest.h>

#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::fate_writer_test {

class FateWriterTest : public testing::Test {
 protected:
  FateWriterTest() {
    Subscribe(listener_, channels::CommsFates(),
              [this](const comms_fates_t& message) { received_.push_back(message); });
  }
  void Deliver() {
    hub_.NextStep();
    hub_.HandleAll();
  }

  MemoryBus hub_;
  Bus& broker_ = hub_.Join("shore_broker");
  Bus& listener_ = hub_.Join("listener");
  std::vector<comms_fates_t> received_;
  FateWriter writer_{broker_};
};

TEST_F(FateWriterTest, PublishesNothingWhereNothingWasDecided) {
  writer_.Flush(0);
  Deliver();
  EXPECT_TRUE(received_.empty());
}

TEST_F(FateWriterTest, PublishesTheCauseAndTheNumbersThatDecided) {
  writer_.Add(7,
              {.number = 3,
               .cause = Cause::kOutOfRange,
               .range_m = 251,
               .limit_m = 250,
               .age_s = 0.5,
               .age_limit_s = 5},
              "alpha", "bravo");
  writer_.Flush(7);
  Deliver();
  ASSERT_EQ(received_.size(), 1U);
  EXPECT_EQ(received_[0].utime, 7);
  ASSERT_EQ(received_[0].num_fates, 1);
  const fate_t& fate = received_[0].fates[0];
  EXPECT_EQ(fate.kind, "report");
  EXPECT_EQ(fate.source, "alpha");
  EXPECT_EQ(fate.destination, "bravo");
  EXPECT_EQ(fate.number, 3);
  EXPECT_EQ(fate.cause, "out_of_range");
  EXPECT_EQ(fate.range_m, 251);
  EXPECT_EQ(fate.limit_m, 250);
  EXPECT_EQ(fate.age_s, 0.5);
  EXPECT_EQ(fate.age_limit_s, 5);
}

TEST_F(FateWriterTest, SplitsWhatIsTooLongForOneMessage) {
  constexpr int64_t kNumSent = 4000;  // Each with a sender of its own.
  for (int64_t number = 0; number < kNumSent; ++number) {
    writer_.Add(7, {.number = number}, "alpha", "bravo");
  }
  writer_.Flush(7);
  Deliver();
  ASSERT_EQ(received_.size(), 3U);
  int64_t next = 0;
  for (const comms_fates_t& message : received_) {
    for (const fate_t& fate : message.fates) EXPECT_EQ(fate.number, next++);
  }
  EXPECT_EQ(next, kNumSent);
}

/// Keeps the sizes of messages on COMMS_FATES.
class SizesOfFates : public testing::Test {
 protected:
  SizesOfFates() {
    listener_.SubscribeBytes(channels::CommsFates().name, [this](const Message& message) {
      sizes_.push_back(message.data.size());
    });
  }

  MemoryBus hub_;
  Bus& broker_ = hub_.Join("shore_broker");
  Bus& listener_ = hub_.Join("listener");
  FateWriter writer_{broker_};
  std::vector<size_t> sizes_;
};

TEST_F(SizesOfFates, IsBelowTwentyBytesEachForTheReportsOfAFleet) {
  constexpr int32_t kNumVehicles = 50;
  const auto name = [](int32_t i) { return "boat_" + std::to_string(10 + i); };
  for (int32_t from = 0; from < kNumVehicles; ++from) {
    for (int32_t to = 0; to < kNumVehicles; ++to) {
      if (to == from) continue;
      writer_.Add(7,
                  {.source = from,
                   .destination = to,
                   .cause = to % 3 == 0 ? Cause::kOutOfRange : Cause::kDelivered,
                   .range_m = 1.0 * from + to,
                   .limit_m = 500,
                   .age_s = 0.01 * to,
                   .age_limit_s = 5},
                  name(from), name(to));
    }
  }
  writer_.Flush(7);
  hub_.NextStep();
  hub_.HandleAll();
  ASSERT_EQ(sizes_.size(), 1U);
  EXPECT_LT(sizes_[0], 20U * kNumVehicles * (kNumVehicles - 1));
  EXPECT_LT(sizes_[0], FateWriter::kMaxMessage_bytes);
}

TEST_F(SizesOfFates, NeverExceedsADatagram) {
  const std::string name(300, 'n');
  acoustic_path_t path{};
  path.colliders = {"alpha 12", "bravo 7"};
  path.num_named = 2;
  for (int32_t i = 0; i < 2000; ++i) {
    writer_.Add(7, {.destination = i, .age_s = 0.5 * i}, name + std::to_string(i),
                name + std::to_string(2 * i), i % 2 == 0 ? &path : nullptr);
  }
  writer_.Flush(7);
  hub_.NextStep();
  hub_.HandleAll();
  ASSERT_GT(sizes_.size(), 10U);
  for (const size_t size : sizes_) EXPECT_LE(size, FateWriter::kMaxMessage_bytes);
}

TEST_F(FateWriterTest, GivesBackEachNumberOfADecision) {
  const Decision decision = {.destination = kOthers,
                             .count = 12,
                             .number = 5,
                             .kind = Kind::kMessage,
                             .cause = Cause::kTooSoon,
                             .override_rule = OverrideRule::kFullReport,
                             .range_m = 1.5,
                             .limit_m = 2.5,
                             .age_s = 3.5,
                             .age_limit_s = 4.5,
                             .wait_s = 5.5,
                             .loss_pct = 6.5,
                             .length_bytes = 7,
                             .length_limit_bytes = 8};
  acoustic_path_t path{};
  path.packet = 9;
  writer_.Add(7, decision, "alpha", "", &path);
  writer_.Add(7, {.number = 5, .kind = Kind::kMessage}, "alpha", "bravo");
  writer_.Flush(7);
  Deliver();
  ASSERT_EQ(received_.size(), 1U);
  ASSERT_EQ(received_[0].num_fates, 2);
  const fate_t& fate = received_[0].fates[0];
  EXPECT_EQ(fate.kind, "message");
  EXPECT_EQ(fate.destination, "*");
  EXPECT_EQ(fate.count, 12);
  EXPECT_EQ(fate.number, 5);
  EXPECT_EQ(fate.cause, "too_soon");
  EXPECT_EQ(fate.override_rule, "full_report");
  EXPECT_EQ(fate.range_m, 1.5);
  EXPECT_EQ(fate.limit_m, 2.5);
  EXPECT_EQ(fate.age_s, 3.5);
  EXPECT_EQ(fate.age_limit_s, 4.5);
  EXPECT_EQ(fate.wait_s, 5.5);
  EXPECT_EQ(fate.loss_pct, 6.5);
  EXPECT_EQ(fate.length_bytes, 7);
  EXPECT_EQ(fate.length_limit_bytes, 8);
  ASSERT_EQ(fate.num_paths, 1);
  EXPECT_EQ(fate.path[0].packet, 9);
  const fate_t& plain = received_[0].fates[1];
  EXPECT_EQ(plain.destination, "bravo");
  EXPECT_EQ(plain.count, 1);
  EXPECT_EQ(plain.range_m, -1);
  EXPECT_EQ(plain.wait_s, -1);
  EXPECT_EQ(plain.num_paths, 0);
}

}  // namespace shoal::fate_writer_test
