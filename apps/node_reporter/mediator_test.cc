#include "apps/node_reporter/mediator.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/bus/bus/memory_bus.h"

namespace shoal::mediator_test {

constexpr int64_t kSecond_us = 1'000'000;

node_message_t MessageTo(const std::string& dest_node, const std::string& ack_id = "") {
  node_message_t message{};
  message.dest_node = dest_node;
  message.var_name = "FOOBAR";
  message.string_val = "hello";
  message.ack_id = ack_id;
  return message;
}

class MediatorTest : public testing::Test {
 protected:
  MediatorTest() {
    Subscribe(world_, channels::NodeMessageLocal(),
              [this](const node_message_t& message) { sent_.push_back(message); });
    Subscribe(world_, channels::AckMessage(),
              [this](const ack_message_t& ack) { acks_.push_back(ack); });
  }

  void Give(const node_message_t& message) {
    Publish(world_, channels::MediatedMessage("alpha"), message);
  }
  void Acknowledge(const std::string& vehicle, const std::string& ack_id) {
    ack_message_t ack{};
    ack.src_node = vehicle;
    ack.dest_node = "alpha";
    ack.ack_id = ack_id;
    Publish(world_, channels::AckMessageTo("alpha"), ack);
  }
  /// Lets the mediator handle what was published, and receives its answers.
  void Step(int64_t pass_us = kSecond_us) {
    sent_.clear();
    acks_.clear();
    hub_.NextStep();
    hub_.HandleAll();
    mediator_.Tick(utime_ += pass_us);
    hub_.NextStep();
    hub_.HandleAll();
    const MediatorCounters& counters = mediator_.counters();
    EXPECT_EQ(counters.given, counters.acknowledged + counters.given_up + counters.refused +
                                  static_cast<int64_t>(mediator_.num_waiting()));
  }

  MemoryBus hub_;
  Bus& bus_ = hub_.Join("node_reporter_alpha");
  Bus& world_ = hub_.Join("world");
  StatusLog log_;
  Mediator mediator_{
      "alpha",
      {.ack_timeout_s = 10, .max_repeats = 2, .ack_jitter_s = 0, .repeat_jitter_s = 0},
      1,
      bus_,
      &log_};
  int64_t utime_ = 0;
  std::vector<node_message_t> sent_;
  std::vector<ack_message_t> acks_;
};

TEST_F(MediatorTest, MakesNoFloodOfAcksOutOfAFloodOfMessages) {
  constexpr int64_t kTooMany = 7;
  node_message_t message = MessageTo("alpha", "b-7");
  message.src_node = "bravo";
  message.ack_requested = 1;
  for (size_t i = 0; i < Mediator::kMaxAcksPerStep + kTooMany; ++i) {
    Publish(world_, channels::NodeMessage("alpha"), message);
  }
  Step();
  EXPECT_EQ(acks_.size(), Mediator::kMaxAcksPerStep);
  EXPECT_EQ(mediator_.counters().acks_unsent, kTooMany);
  Publish(world_, channels::NodeMessage("alpha"), message);
  Step();
  EXPECT_EQ(acks_.size(), 1U);
}

TEST_F(MediatorTest, AcknowledgesAsManyInEachStepWhereAcksWaitForTheirTime) {
  Mediator late("charlie", {.ack_jitter_s = 1000}, 1, bus_, &log_);
  node_message_t message = MessageTo("charlie", "b-7");
  message.src_node = "bravo";
  message.ack_requested = 1;
  for (int step = 0; step < 3; ++step) {
    for (size_t i = 0; i < Mediator::kMaxAcksPerStep; ++i) {
      Publish(world_, channels::NodeMessage("charlie"), message);
    }
    Step();
    late.Tick(utime_);
  }
  EXPECT_EQ(late.counters().acks_unsent, 0);
}

TEST_F(MediatorTest, SendsNoAckLongerThanAnAckIdMayBe) {
  for (const size_t length : {Mediator::kLongestAckId, Mediator::kLongestAckId + 1}) {
    node_message_t message = MessageTo("alpha", std::string(length, 'x'));
    message.src_node = "bravo";
    message.ack_requested = 1;
    Publish(world_, channels::NodeMessage("alpha"), message);
    Step();
    EXPECT_EQ(acks_.size(), length == Mediator::kLongestAckId ? 1U : 0U);
  }
  EXPECT_EQ(mediator_.counters().acks_unsent, 1);
}

TEST_F(MediatorTest, RefusesWhatWouldMakeTheWaitingMessagesTooBigUntilSomeAreGone) {
  node_message_t big = MessageTo("bravo", "a-1");
  big.string_val.assign(Mediator::kMaxWaitingBytes / 2, 'x');
  Give(big);
  big.ack_id = "a-2";
  Give(big);
  Step();
  EXPECT_EQ(sent_.size(), 1U);
  EXPECT_EQ(mediator_.counters().refused, 1);
  Acknowledge("bravo", "a-1");
  Give(big);
  Step();
  EXPECT_EQ(sent_.size(), 1U);
  EXPECT_EQ(mediator_.counters().refused, 1);
}

TEST_F(MediatorTest, AcknowledgesAMessageThatAsksForItEachTimeItIsReceived) {
  node_message_t message = MessageTo("alpha", "b-7");
  message.src_node = "bravo";
  message.ack_requested = 1;
  for (int i = 0; i < 2; ++i) {
    Publish(world_, channels::NodeMessage("alpha"), message);
    Step();
    ASSERT_EQ(acks_.size(), 1U);
    EXPECT_EQ(acks_[0].src_node, "alpha");
    EXPECT_EQ(acks_[0].dest_node, "bravo");
    EXPECT_EQ(acks_[0].ack_id, "b-7");
  }
}

TEST_F(MediatorTest, StaysSilentAboutAMessageThatAsksForNoAck) {
  Publish(world_, channels::NodeMessage("alpha"), MessageTo("alpha", "b-7"));
  Step();
  EXPECT_TRUE(acks_.empty());
}

TEST_F(MediatorTest, FillsInTheSenderAndWhatIsToBeAcknowledged) {
  Give(MessageTo("bravo"));
  Step();
  ASSERT_EQ(sent_.size(), 1U);
  EXPECT_EQ(sent_[0].src_node, "alpha");
  EXPECT_EQ(sent_[0].dest_node, "bravo");
  EXPECT_EQ(sent_[0].string_val, "hello");
  EXPECT_EQ(sent_[0].utime, kSecond_us);
  EXPECT_TRUE(sent_[0].ack_requested);
  EXPECT_FALSE(sent_[0].ack_id.empty());
}

TEST_F(MediatorTest, GivesEachMessageAnIdOfItsOwn) {
  Give(MessageTo("bravo"));
  Give(MessageTo("bravo"));
  Step();
  ASSERT_EQ(sent_.size(), 2U);
  EXPECT_NE(sent_[0].ack_id, sent_[1].ack_id);
}

TEST_F(MediatorTest, RepeatsTheSameMessageAfterTheTimeoutAndGivesUpAfterTheLastRepeat) {
  Give(MessageTo("bravo"));
  Step();
  const node_message_t first = sent_.at(0);
  for (int repeat = 0; repeat < 2; ++repeat) {
    Step(10 * kSecond_us - 1);
    EXPECT_TRUE(sent_.empty()) << "just before the timeout";
    Step(1);
    ASSERT_EQ(sent_.size(), 1U);
    EXPECT_EQ(sent_[0].ack_id, first.ack_id);
    EXPECT_EQ(sent_[0].utime, first.utime);
  }
  EXPECT_EQ(mediator_.counters().repeats, 2);
  Step(10 * kSecond_us);
  EXPECT_TRUE(sent_.empty());
  EXPECT_EQ(mediator_.counters().given_up, 1);
  EXPECT_EQ(mediator_.num_waiting(), 0U);
}

TEST_F(MediatorTest, StopsRepeatingOnceTheNamedVehicleHasAcknowledged) {
  Give(MessageTo("Bravo", "a-1"));
  Step();
  Acknowledge("charlie", "a-1");
  Acknowledge("bravo", "a-2");
  Step();
  EXPECT_EQ(mediator_.num_waiting(), 1U) << "neither was asked for";
  EXPECT_EQ(mediator_.counters().acks_unexpected, 2);
  Acknowledge("bravo", "a-1");
  Step();
  EXPECT_EQ(mediator_.counters().acknowledged, 1);
  Step(100 * kSecond_us);
  EXPECT_TRUE(sent_.empty());
}

TEST_F(MediatorTest, WaitsForEveryVehicleThatIsNamed) {
  Give(MessageTo("bravo:charlie", "a-1"));
  Step();
  Acknowledge("charlie", "a-1");
  Step();
  EXPECT_EQ(mediator_.num_waiting(), 1U);
  Acknowledge("bravo", "a-1");
  Step();
  EXPECT_EQ(mediator_.num_waiting(), 0U);
}

TEST_F(MediatorTest, DoesNotWaitForItsOwnVehicle) {
  Give(MessageTo("ALPHA:bravo", "a-1"));
  Step();
  EXPECT_EQ(sent_.size(), 1U);
  EXPECT_EQ(mediator_.num_waiting(), 1U);
  Acknowledge("bravo", "a-1");
  Step();
  EXPECT_EQ(mediator_.counters().acknowledged, 1);
}

TEST_F(MediatorTest, NeedsOnlyOneAckOfAGroupOrOfAll) {
  Give(MessageTo("all", "a-1"));
  node_message_t to_group = MessageTo("", "a-2");
  to_group.dest_group = "red";
  Give(to_group);
  Step();
  Acknowledge("zulu", "a-1");
  Acknowledge("zulu", "a-2");
  Step();
  EXPECT_EQ(mediator_.counters().acknowledged, 2);
}

TEST_F(MediatorTest, RefusesWhatIsAnothersOrWaitsAlready) {
  node_message_t foreign = MessageTo("bravo");
  foreign.src_node = "bravo";
  Give(foreign);
  Give(MessageTo("bravo", "a-1"));
  Give(MessageTo("bravo", "a-1"));
  Step();
  EXPECT_EQ(sent_.size(), 1U);
  EXPECT_EQ(mediator_.counters().refused, 2);
}

TEST_F(MediatorTest, RefusesMoreThanItCanStore) {
  for (size_t i = 0; i <= Mediator::kMaxWaiting; ++i) Give(MessageTo("bravo"));
  Step();
  EXPECT_EQ(mediator_.num_waiting(), Mediator::kMaxWaiting);
  EXPECT_EQ(mediator_.counters().refused, 1);
}

/// Returns when a message of alpha is sent, repeated twice and no more, and when bravo's first ack
/// for it leaves, in tenths of a second.
std::vector<int> Times(uint64_t seed, const std::string& vehicle) {
  MemoryBus hub;
  Bus& bus = hub.Join("node_reporter");
  Bus& world = hub.Join("world");
  StatusLog log;
  Mediator mediator(
      vehicle, {.ack_timeout_s = 10, .max_repeats = 2, .ack_jitter_s = 2, .repeat_jitter_s = 5},
      seed, bus, &log);
  std::vector<int> times;
  int now = 0;
  Subscribe(world, channels::NodeMessageLocal(),
            [&](const node_message_t&) { times.push_back(now); });
  Subscribe(world, channels::AckMessage(), [&](const ack_message_t&) { times.push_back(now); });
  Publish(world, channels::MediatedMessage(vehicle), MessageTo("zulu"));
  node_message_t asks = MessageTo(vehicle, "id");
  asks.src_node = "zulu";
  asks.ack_requested = 1;
  Publish(world, channels::NodeMessage(vehicle), asks);
  for (; now < 400; ++now) {
    hub.NextStep();
    hub.HandleAll();
    mediator.Tick(now * kSecond_us / 10);
    hub.NextStep();
    hub.HandleAll();
  }
  return times;
}

TEST(MediatorJitter, SpreadsAcksAndRepeatsByVehicleAndIsTheSameForTheSameSeed) {
  const std::vector<int> alpha = Times(1, "alpha");
  ASSERT_EQ(alpha.size(), 4U) << "the message, an ack and two repeats";
  EXPECT_EQ(alpha[0], 0);
  EXPECT_LE(alpha[1], 20);
  for (const size_t i : {2U, 3U}) {
    const int since = alpha[i] - (i == 2 ? 0 : alpha[2]);
    EXPECT_GE(since, 100);
    EXPECT_LE(since, 151);
  }
  EXPECT_EQ(Times(1, "alpha"), alpha);
  EXPECT_NE(Times(1, "bravo"), alpha);
  EXPECT_NE(Times(2, "alpha"), alpha);
}

}  // namespace shoal::mediator_test
