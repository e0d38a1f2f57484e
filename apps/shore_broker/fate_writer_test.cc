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
  for (int64_t number = 0; number < 2 * FateWriter::kMaxFatesPerMessage + 1; ++number) {
    writer_.Add(7, {.number = number}, "alpha", "bravo");
  }
  writer_.Flush(7);
  Deliver();
  ASSERT_EQ(received_.size(), 3U);
  EXPECT_EQ(received_[0].num_fates, FateWriter::kMaxFatesPerMessage);
  EXPECT_EQ(received_[2].num_fates, 1);
  EXPECT_EQ(received_[2].fates[0].number, 2 * FateWriter::kMaxFatesPerMessage);
}

}  // namespace shoal::fate_writer_test
