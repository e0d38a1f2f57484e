#include "lib/bus/bus/lcm_assembler.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace shoal::lcm_assembler_test {

using Datagram = std::vector<uint8_t>;

void Append(uint64_t value, int num_bytes, Datagram* out) {
  for (int shift = 8 * (num_bytes - 1); shift >= 0; shift -= 8) {
    out->push_back(static_cast<uint8_t>(value >> shift));
  }
}

Datagram Whole(std::string_view channel, const Datagram& data) {
  Datagram datagram = {'L', 'C', '0', '2', 0, 0, 0, 7};
  datagram.insert(datagram.end(), channel.begin(), channel.end());
  datagram.push_back(0);
  datagram.insert(datagram.end(), data.begin(), data.end());
  return datagram;
}

struct Fragment {
  uint32_t sequence = 1;
  uint32_t size = 0;
  uint32_t offset = 0;
  uint16_t number = 0;
  uint16_t count = 0;
  Datagram part = {};
};

Datagram Encode(const Fragment& fragment, std::string_view channel = "BIG") {
  Datagram datagram = {'L', 'C', '0', '3'};
  Append(fragment.sequence, 4, &datagram);
  Append(fragment.size, 4, &datagram);
  Append(fragment.offset, 4, &datagram);
  Append(fragment.number, 2, &datagram);
  Append(fragment.count, 2, &datagram);
  if (fragment.number == 0) {
    datagram.insert(datagram.end(), channel.begin(), channel.end());
    datagram.push_back(0);
  }
  datagram.insert(datagram.end(), fragment.part.begin(), fragment.part.end());
  return datagram;
}

/// A message of `size` bytes in fragments of `step`.
std::vector<Datagram> Fragments(const Datagram& message, size_t step, uint32_t sequence = 1) {
  const size_t count = (message.size() + step - 1) / step;
  std::vector<Datagram> datagrams;
  for (size_t i = 0; i < count; ++i) {
    const auto begin = message.begin() + static_cast<std::ptrdiff_t>(i * step);
    const auto end = i + 1 == count ? message.end() : begin + static_cast<std::ptrdiff_t>(step);
    datagrams.push_back(Encode({.sequence = sequence,
                                .size = static_cast<uint32_t>(message.size()),
                                .offset = static_cast<uint32_t>(i * step),
                                .number = static_cast<uint16_t>(i),
                                .count = static_cast<uint16_t>(count),
                                .part = Datagram(begin, end)}));
  }
  return datagrams;
}

Datagram Counted(size_t size) {
  Datagram message(size);
  std::iota(message.begin(), message.end(), uint8_t{0});
  return message;
}

Datagram Bytes(const LcmMessage& message) { return {message.data.begin(), message.data.end()}; }

TEST(LcmAssembler, TakesAMessageOfOneDatagram) {
  LcmAssembler assembler;
  const Datagram datagram = Whole("NAV_ALPHA", {1, 2, 3});
  const auto message = assembler.Add(1, datagram);
  ASSERT_TRUE(message.has_value());
  EXPECT_EQ(message->channel, "NAV_ALPHA");
  EXPECT_EQ(Bytes(*message), (Datagram{1, 2, 3}));
  EXPECT_TRUE(assembler.Add(1, Whole("EMPTY", {})).has_value());
  EXPECT_TRUE(assembler.Add(1, Whole(std::string(63, 'C'), {1})).has_value());
  EXPECT_EQ(assembler.num_malformed(), 0);
}

TEST(LcmAssembler, RefusesWhatEndsAProcessThatTrustsIt) {
  LcmAssembler assembler;
  // A channel name without its end: liblcm 1.3.1 states a size of -1.
  EXPECT_FALSE(assembler.Add(1, Datagram{'L', 'C', '0', '2', 0, 0, 0, 1, 'N', 'A', 'V'}));
  // A fragment whose offset and length wrap: liblcm 1.3.1 writes before its buffer.
  EXPECT_FALSE(assembler.Add(
      1, Encode({.size = 1000, .offset = 0xffffffff - 49, .count = 2, .part = Datagram(100)})));
  EXPECT_FALSE(assembler.Add(1, Encode({.size = 1000,
                                        .offset = 0xffffffff - 49,
                                        .number = 1,
                                        .count = 2,
                                        .part = Datagram(100)})));
  EXPECT_EQ(assembler.num_malformed(), 3);
  EXPECT_EQ(assembler.num_pending(), 0U);
}

TEST(LcmAssembler, RefusesEveryHeaderThatCannotBe) {
  const Fragment good{.size = 100, .offset = 50, .number = 1, .count = 2, .part = Datagram(50)};
  const auto refuses = [&](auto change) {
    Fragment bad = good;
    change(&bad);
    LcmAssembler assembler;
    return !assembler.Add(1, Encode(bad)) && assembler.num_malformed() == 1 &&
           assembler.num_pending() == 0;
  };
  EXPECT_FALSE(refuses([](Fragment*) {}));
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->part.clear(); }));
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->part.push_back(0); })) << "beyond the end";
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->offset = 101; }));
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->number = 2; }));
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->count = 101; })) << "more fragments than bytes";
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->size = LcmAssembler::kMaxPendingBytes + 1; }));
  EXPECT_TRUE(refuses([](Fragment* bad) { bad->number = 0; })) << "the first begins at 0";
  for (const std::string& channel : {std::string(), std::string(64, 'C')}) {
    LcmAssembler assembler;
    EXPECT_FALSE(assembler.Add(1, Whole(channel, {1})));
    EXPECT_FALSE(
        assembler.Add(1, Encode({.size = 100, .count = 2, .part = Datagram(50)}, channel)));
    EXPECT_EQ(assembler.num_malformed(), 2);
  }
  for (size_t size = 0; size < 20; ++size) {
    LcmAssembler assembler;
    Datagram cut = Encode(good);
    cut.resize(size);
    EXPECT_FALSE(assembler.Add(1, cut));
    EXPECT_EQ(assembler.num_malformed(), 1);
  }
}

TEST(LcmAssembler, PutsFragmentsTogetherInWhateverOrderTheyCome) {
  std::mt19937 random(1);
  const Datagram message = Counted(10'000);
  for (int round = 0; round < 20; ++round) {
    std::vector<Datagram> datagrams = Fragments(message, 1 + random() % 3000);
    if (round > 0) std::shuffle(datagrams.begin(), datagrams.end(), random);
    LcmAssembler assembler;
    for (size_t i = 0; i < datagrams.size(); ++i) {
      const auto got = assembler.Add(1, datagrams[i]);
      ASSERT_EQ(got.has_value(), i + 1 == datagrams.size());
      if (!got) {
        EXPECT_FALSE(assembler.Add(1, datagrams[i])) << "sent twice";
        continue;
      }
      EXPECT_EQ(got->channel, "BIG");
      EXPECT_EQ(Bytes(*got), message);
    }
    EXPECT_EQ(assembler.num_pending(), 0U);
    EXPECT_EQ(assembler.pending_bytes(), 0U);
    EXPECT_EQ(assembler.num_malformed() + assembler.num_abandoned(), 0);
  }
}

TEST(LcmAssembler, RefusesFragmentsThatOverlapOrLeaveGaps) {
  LcmAssembler assembler;
  EXPECT_FALSE(assembler.Add(1, Encode({.size = 100, .count = 2, .part = Datagram(50)})));
  EXPECT_FALSE(assembler.Add(
      1, Encode({.size = 100, .offset = 40, .number = 1, .count = 2, .part = Datagram(50)})));
  EXPECT_EQ(assembler.num_malformed(), 1);
  EXPECT_EQ(assembler.num_pending(), 0U) << "none of it is kept";
}

TEST(LcmAssembler, KeepsTheSendersApart) {
  LcmAssembler assembler;
  const auto first = Fragments(Counted(100), 60, 1);
  const auto second = Fragments(Counted(90), 60, 2);
  EXPECT_FALSE(assembler.Add(1, first[0]));
  EXPECT_FALSE(assembler.Add(2, second[0]));
  EXPECT_EQ(Bytes(*assembler.Add(1, first[1])), Counted(100));
  EXPECT_EQ(Bytes(*assembler.Add(2, second[1])), Counted(90));
}

TEST(LcmAssembler, PutsInterleavedMessagesOfOneSenderTogether) {
  LcmAssembler assembler;
  const auto first = Fragments(Counted(100), 60, 1);
  const auto second = Fragments(Counted(90), 60, 2);
  EXPECT_FALSE(assembler.Add(1, first[0]));
  EXPECT_FALSE(assembler.Add(1, second[0]));
  const auto one = assembler.Add(1, first[1]);
  ASSERT_TRUE(one.has_value());
  EXPECT_EQ(Bytes(*one), Counted(100));
  const auto two = assembler.Add(1, second[1]);
  ASSERT_TRUE(two.has_value());
  EXPECT_EQ(Bytes(*two), Counted(90));
  EXPECT_EQ(assembler.num_abandoned(), 0);
}

TEST(LcmAssembler, GivesUpASendersOldestMessageWhereTooManyWait) {
  LcmAssembler assembler;
  constexpr uint32_t kMore = 3;
  // The sequence wraps: the oldest is the first that came, not the least number.
  for (uint32_t i = 0; i < LcmAssembler::kMaxPendingOfSender + kMore; ++i) {
    EXPECT_FALSE(assembler.Add(1, Fragments(Counted(100), 60, i - 2)[0]));
    EXPECT_LE(assembler.num_pending(), LcmAssembler::kMaxPendingOfSender);
  }
  EXPECT_EQ(assembler.num_abandoned(), kMore);
  EXPECT_TRUE(assembler.Add(1, Fragments(Counted(100), 60, kMore - 2)[1])) << "the oldest kept";
}

TEST(LcmAssembler, HoldsNoMoreThanItsLimitsWhateverComes) {
  LcmAssembler assembler;
  for (uint64_t sender = 0; sender < 1000; ++sender) {
    const uint32_t size = sender % 2 == 0 ? 1000 : 3'000'000;
    assembler.Add(sender, Encode({.size = size, .count = 2, .part = Datagram(50)}));
    EXPECT_LE(assembler.num_pending(), LcmAssembler::kMaxPending);
    EXPECT_LE(assembler.pending_bytes(), LcmAssembler::kMaxPendingBytes);
  }
  EXPECT_EQ(assembler.num_abandoned() + static_cast<int64_t>(assembler.num_pending()), 1000);
}

TEST(LcmAssembler, SurvivesRandomChangesOfGoodDatagrams) {
  std::mt19937 random(7);
  LcmAssembler assembler;
  const std::vector<Datagram> good = Fragments(Counted(500), 120);
  for (int i = 0; i < 100'000; ++i) {
    Datagram datagram = good[random() % good.size()];
    for (uint32_t k = random() % 4; k > 0; --k) {
      datagram[random() % std::min<size_t>(datagram.size(), 30)] = static_cast<uint8_t>(random());
    }
    if (random() % 8 == 0) datagram.resize(random() % datagram.size());
    if (const auto message = assembler.Add(random() % 3, datagram)) {
      EXPECT_LE(message->channel.size(), LcmAssembler::kMaxChannel);
      EXPECT_LE(message->data.size(), LcmAssembler::kMaxPendingBytes);
    }
  }
  EXPECT_LE(assembler.pending_bytes(), LcmAssembler::kMaxPendingBytes);
}

}  // namespace shoal::lcm_assembler_test
