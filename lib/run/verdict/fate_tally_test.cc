#include "lib/run/verdict/fate_tally.h"

#include <gtest/gtest.h>

#include <random>

namespace shoal::fate_tally_test {

constexpr int kAll = FateCounts::kAll;

fate_t Fate(const std::string& kind, const std::string& source, const std::string& destination,
            const std::string& cause, int32_t count = 1) {
  fate_t fate{};
  fate.kind = kind;
  fate.source = source;
  fate.destination = destination;
  fate.cause = cause;
  fate.count = count;
  return fate;
}

fate_t OverAcoustics(const std::string& source, int64_t number, const std::string& cause,
                     int32_t bits_flipped, int32_t num_colliders) {
  fate_t fate = Fate("packet", source, "bravo", cause);
  fate.number = number;
  fate.num_paths = 1;
  fate.path.resize(1);
  fate.path[0].bits_flipped = bits_flipped;
  fate.path[0].num_colliders = num_colliders;
  return fate;
}

/// Fates of all kinds, of three vehicles and of others.
std::vector<fate_t> RandomFates(int num, std::mt19937_64* random) {
  const std::vector<std::string> vehicles = {"alpha", "bravo", "charlie", "nemo", "*"};
  const std::vector<std::string> kinds = {"report", "message", "ack"};
  const std::vector<std::string> causes = {"delivered", "out_of_range", "collision", "damaged"};
  const auto any = [&](const std::vector<std::string>& of) { return of[(*random)() % of.size()]; };
  std::vector<fate_t> fates;
  for (int i = 0; i < num; ++i) {
    if ((*random)() % 3 == 0) {
      fates.push_back(OverAcoustics(any(vehicles), static_cast<int64_t>((*random)() % 50),
                                    any(causes), static_cast<int32_t>((*random)() % 3),
                                    static_cast<int32_t>((*random)() % 2)));
    } else {
      fates.push_back(Fate(any(kinds), any(vehicles), any(vehicles), any(causes),
                           static_cast<int32_t>((*random)() % 900)));
    }
  }
  return fates;
}

FateTally TallyOf(std::span<const fate_t> fates) {
  FateTally tally({"alpha", "bravo", "charlie"});
  tally.Take(fates);
  return tally;
}

std::vector<uint8_t> BytesOf(const FateTally& tally) {
  std::vector<uint8_t> bytes;
  tally.AppendTo(&bytes);
  return bytes;
}

void ExpectSame(const FateTally& a, const FateTally& b) {
  for (const Kind kind : {Kind::kReport, Kind::kMessage, Kind::kAck, Kind::kPacket}) {
    EXPECT_EQ(a.fates(kind).Totals(), b.fates(kind).Totals());
    for (int from = kAll; from < 3; ++from) {
      for (int to = kAll; to < 3; ++to) {
        EXPECT_EQ(a.fates(kind).CountOffered(from, to), b.fates(kind).CountOffered(from, to));
        EXPECT_EQ(a.fates(kind).Count(from, to, "delivered"),
                  b.fates(kind).Count(from, to, "delivered"));
      }
    }
  }
  EXPECT_EQ(a.acoustic().Counts(), b.acoustic().Counts());
}

TEST(FateTally, CountsEachKindByLinkAndCauseAndWhatTheAcousticNetworkDid) {
  const FateTally tally = TallyOf(std::vector{Fate("report", "alpha", "bravo", "delivered"),
                                              Fate("report", "alpha", "*", "out_of_range", 7),
                                              Fate("message", "bravo", "alpha", "delivered"),
                                              Fate("rumour", "bravo", "alpha", "delivered"),
                                              OverAcoustics("alpha", 0, "damaged", 3, 0)});
  EXPECT_EQ(tally.fates(Kind::kReport).Count(0, 1, "delivered"), 1);
  EXPECT_EQ(tally.fates(Kind::kReport).CountOffered(0, kAll), 8);
  EXPECT_EQ(tally.fates(Kind::kMessage).CountOffered(kAll, kAll), 1);
  EXPECT_EQ(tally.fates(Kind::kAck).CountOffered(kAll, kAll), 0);
  EXPECT_EQ(tally.fates(Kind::kPacket).Count(0, 1, "damaged"), 1);
  EXPECT_NE(tally.acoustic().Csv().find("bits flipped,3\n"), std::string::npos);
}

TEST(FateTally, OfPartsIsThatOfTheWhole) {
  std::mt19937_64 random(7);
  for (int round = 0; round < 20; ++round) {
    const std::vector<fate_t> fates = RandomFates(300, &random);
    const size_t cut = random() % fates.size();
    FateTally parts = TallyOf(std::span(fates).first(cut));
    for (int i = 0; i < 60; ++i) parts.acoustic().AddSent("alpha");
    ASSERT_TRUE(parts.Add(BytesOf(TallyOf(std::span(fates).subspan(cut)))));
    FateTally whole = TallyOf(fates);
    for (int i = 0; i < 60; ++i) whole.acoustic().AddSent("alpha");
    ExpectSame(parts, whole);
    EXPECT_GT(whole.acoustic().NumInTransit(), 0);
  }
}

TEST(FateTally, RefusesWhatIsDamaged) {
  std::mt19937_64 random(8);
  const std::vector<uint8_t> bytes = BytesOf(TallyOf(RandomFates(50, &random)));
  for (size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(TallyOf({}).Add(std::span(bytes).first(size))) << size;
  }
  std::vector<uint8_t> more = bytes;
  more.push_back(0);
  EXPECT_FALSE(TallyOf({}).Add(more));
  for (int i = 0; i < 2000; ++i) {
    std::vector<uint8_t> changed = bytes;
    for (int k = 0; k < 3; ++k) changed[random() % changed.size()] = static_cast<uint8_t>(random());
    FateTally tally = TallyOf({});
    [[maybe_unused]] const bool is_taken = tally.Add(changed);  // Neither crashes nor fills memory.
  }
}

}  // namespace shoal::fate_tally_test
