#include "sim/part_batch.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace shoal::part_batch_test {

struct Read {
  uint32_t participant = 0;
  std::string channel;
  uint32_t sequence = 0;
  Bytes data;

  bool operator==(const Read&) const = default;
};

/// Reads a batch to its end.
bool ReadAll(std::span<const uint8_t> batch, BatchReader* reader, PartNews* news,
             std::vector<Read>* messages) {
  if (!reader->Open(batch, news)) return false;
  BatchMessage message;
  while (reader->Next(&message)) {
    messages->push_back({.participant = message.participant,
                         .channel = reader->ChannelName(message.channel),
                         .sequence = message.sequence,
                         .data = Bytes(message.data.begin(), message.data.end())});
  }
  return reader->IsWhole();
}

RC_GTEST_PROP(PartBatch, GivesBackWhatWasWrittenInAnyNumberOfSteps, ()) {
  BatchWriter writer;
  BatchReader reader;
  const auto contents = *rc::gen::container<std::vector<Bytes>>(5, rc::gen::arbitrary<Bytes>());
  for (int step = 0; step < 4; ++step) {
    PartNews news = {.ends_mission = *rc::gen::arbitrary<bool>(),
                     .is_interrupted = *rc::gen::arbitrary<bool>()};
    if (*rc::gen::arbitrary<bool>()) news.losses.push_back({.participant = 3, .text = "lost"});
    if (*rc::gen::arbitrary<bool>()) news.end_of_all = {.participant = 4, .text = "the end"};
    if (*rc::gen::arbitrary<bool>()) news.fault = {.participant = 5, .text = ""};
    writer.Begin(news);
    std::vector<Read> written;
    for (int i = *rc::gen::inRange(0, 20); i > 0; --i) {
      const auto channel = *rc::gen::inRange<uint32_t>(0, 7);
      const Bytes& data = contents[*rc::gen::inRange<size_t>(0, contents.size())];
      const Read message = {.participant = *rc::gen::inRange<uint32_t>(0, 9),
                            .channel = "C" + std::to_string(channel),
                            .sequence = static_cast<uint32_t>(i),
                            .data = data};
      writer.Add({.participant = message.participant,
                  .channel = channel,
                  .sequence = message.sequence,
                  .data = data},
                 message.channel);
      written.push_back(message);
    }
    PartNews read_news;
    std::vector<Read> read;
    RC_ASSERT(ReadAll(writer.bytes(), &reader, &read_news, &read));
    RC_ASSERT(read == written);
    RC_ASSERT(read_news == news);
  }
}

RC_GTEST_PROP(PartBatch, RefusesEveryBatchThatWasCut, ()) {
  BatchWriter writer;
  writer.Begin({.losses = {{.participant = 1, .text = "lost"}}});
  const Bytes data = {1, 2, 3};
  writer.Add({.participant = 1, .channel = 2, .sequence = 0, .data = data}, "NAV");
  const std::span<const uint8_t> whole = writer.bytes();
  const auto size = *rc::gen::inRange<size_t>(0, whole.size());
  PartNews news;
  std::vector<Read> read;
  BatchReader reader;
  const bool is_whole = ReadAll(whole.first(size), &reader, &news, &read);
  RC_ASSERT(read.empty());
  // Cut before its only message, it is a batch without one.
  writer.Begin({.losses = {{.participant = 1, .text = "lost"}}});
  RC_ASSERT(is_whole == (size == writer.bytes().size()));
}

TEST(PartBatch, HoldsBytesThatMessagesInARowShareOnce) {
  const Bytes data(1000, 7);
  BatchWriter writer;
  writer.Begin({});
  for (uint32_t channel = 0; channel < 10; ++channel) {
    writer.Add({.participant = 0, .channel = channel, .sequence = channel, .data = data}, "C");
  }
  EXPECT_LT(writer.bytes().size(), 1500U);
}

TEST(PartBatch, RefusesAChannelThatWasNeverNamed) {
  BatchWriter writer;
  const Bytes data = {1};
  writer.Begin({});
  writer.Add({.data = data}, "NAV");
  writer.Begin({});
  writer.Add({.data = data}, "NAV");
  BatchReader reader;  // It has not seen the first.
  PartNews news;
  std::vector<Read> read;
  EXPECT_FALSE(ReadAll(writer.bytes(), &reader, &news, &read));
  EXPECT_TRUE(read.empty());
}

TEST(PartNewsMerge, DecidesAsOneProcessWhateverTheOrderOfTheParts) {
  const auto event = [](uint32_t participant) {
    return PartEvent{.participant = participant, .text = std::to_string(participant)};
  };
  std::vector<PartNews> parts(3);
  parts[0] = {.losses = {event(5)}, .fault = event(9)};
  parts[1] = {.ends_mission = true, .losses = {event(1), event(7)}, .end_of_all = event(2)};
  parts[2] = {.is_interrupted = true, .end_of_all = event(8), .fault = event(4)};
  std::vector<size_t> order = {0, 1, 2};
  do {
    PartNews merged;
    for (const size_t part : order) Merge(parts[part], &merged);
    EXPECT_EQ(merged, (PartNews{.ends_mission = true,
                                .is_interrupted = true,
                                .losses = {event(1), event(5), event(7)},
                                .end_of_all = event(8),
                                .fault = event(4)}));
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace shoal::part_batch_test
