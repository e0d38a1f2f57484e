#include "lib/tools/campaign/samples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace shoal {
namespace {

Campaign CampaignWith(std::vector<SampledKey> samples, int64_t latin_hypercube = 0) {
  Campaign campaign;
  campaign.seed = 7;
  campaign.samples = std::move(samples);
  campaign.latin_hypercube = latin_hypercube;
  return campaign;
}

SampledKey Uniform(const std::string& key, double from, double to) {
  return {.key = key, .kind = SampleKind::kUniform, .first = from, .second = to, .choices = {}};
}

double Number(const Campaign& campaign, int64_t repetition, size_t key = 0) {
  return std::stod(SamplesOf(campaign, repetition)[key]);
}

TEST(Samples, DependOnTheRepetitionAloneAndNotOnOtherKeys) {
  const Campaign one = CampaignWith({Uniform("a", 0, 1)});
  const Campaign two = CampaignWith({Uniform("b", 0, 1), Uniform("a", 0, 1)});
  for (const int64_t repetition : {1, 2, 1000}) {
    EXPECT_EQ(SamplesOf(one, repetition)[0], SamplesOf(two, repetition)[1]);
    EXPECT_NE(SamplesOf(two, repetition)[0], SamplesOf(two, repetition)[1]);
  }
}

TEST(Samples, GiveEachRepetitionASeedOfItsOwn) {
  const Campaign campaign = CampaignWith({});
  std::set<uint64_t> seeds;
  for (int64_t repetition = 1; repetition <= 10'000; ++repetition) {
    seeds.insert(SeedOf(campaign, repetition));
  }
  EXPECT_EQ(seeds.size(), 10'000U);
  EXPECT_LT(*seeds.rbegin(), uint64_t{1} << 48);
}

// 99.9 %: mean of 4,000 draws within 3.29 standard errors.
TEST(Samples, HaveTheMeansAndDeviationsThatAreAskedFor) {
  constexpr int64_t kDraws = 4000;
  constexpr double kErrors = 3.29;
  SampledKey normal{
      .key = "n", .kind = SampleKind::kNormal, .first = 5, .second = 2, .choices = {}};
  const Campaign campaign = CampaignWith({Uniform("u", -50, 50), normal});
  double sum_u = 0;
  double sum_n = 0;
  double square_n = 0;
  for (int64_t i = 1; i <= kDraws; ++i) {
    const double u = Number(campaign, i);
    const double n = Number(campaign, i, 1);
    ASSERT_GE(u, -50);
    ASSERT_LT(u, 50);
    sum_u += u;
    sum_n += n;
    square_n += (n - 5) * (n - 5);
  }
  EXPECT_NEAR(sum_u / kDraws, 0, kErrors * 100 / std::sqrt(12.0 * kDraws));
  EXPECT_NEAR(sum_n / kDraws, 5, kErrors * 2 / std::sqrt(static_cast<double>(kDraws)));
  EXPECT_NEAR(square_n / kDraws, 4, kErrors * 4 * std::sqrt(2.0 / kDraws));
}

TEST(Samples, HitEachStratumOfALatinHypercubeOncePerBlock) {
  constexpr int64_t kBlock = 50;
  const Campaign campaign =
      CampaignWith({Uniform("a", 0, kBlock), Uniform("b", 0, kBlock)}, kBlock);
  for (int64_t block = 0; block < 3; ++block) {
    std::set<int> a;
    std::set<int> b;
    for (int64_t i = 1; i <= kBlock; ++i) {
      a.insert(static_cast<int>(Number(campaign, block * kBlock + i, 0)));
      b.insert(static_cast<int>(Number(campaign, block * kBlock + i, 1)));
    }
    EXPECT_EQ(a.size(), static_cast<size_t>(kBlock));
    EXPECT_EQ(b.size(), static_cast<size_t>(kBlock));
  }
}

TEST(Samples, OfOneBlockStayWhereMoreRepetitionsCome) {
  Campaign campaign = CampaignWith({Uniform("a", 0, 1)}, 10);
  campaign.repetitions = 10;
  const auto before = SamplesOf(campaign, 7);
  campaign.repetitions = 1000;
  EXPECT_EQ(SamplesOf(campaign, 7), before);
}

TEST(Samples, OfIntegersAndChoicesComeAsOftenAsEachOther) {
  SampledKey integers = Uniform("i", 1, 6);
  integers.is_integer = true;
  SampledKey choice{.key = "c", .kind = SampleKind::kChoice, .choices = {"\"a\"", "true", "3"}};
  const Campaign campaign = CampaignWith({integers, choice});
  std::map<std::string, int> counts;
  constexpr int kDraws = 6000;
  for (int64_t i = 1; i <= kDraws; ++i) {
    for (const std::string& text : SamplesOf(campaign, i))
      ++counts[text == "3" ? text + "?" : text];
  }
  // "3" is of both: 1,000 and 2,000 are expected.
  EXPECT_EQ(counts.size(), 8U);
  EXPECT_NEAR(counts["1"], kDraws / 6, 100);
  EXPECT_NEAR(counts["6"], kDraws / 6, 100);
  EXPECT_NEAR(counts["3?"], kDraws / 6 + kDraws / 3, 160);
  EXPECT_NEAR(counts["true"], kDraws / 3, 130);
}

}  // namespace
}  // namespace shoal
