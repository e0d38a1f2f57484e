#include "lib/tools/campaign/samples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lib/base/check/check.h"
#include "lib/base/random/stream.h"
#include "lib/base/statistics/distributions.h"
#include "lib/mission/toml/table_writer.h"

namespace shoal {

namespace {

/// Returns the stratum, from 0, of a repetition within its block.
int64_t StratumOf(const Campaign& campaign, const std::string& key, int64_t block, int64_t place) {
  std::vector<int64_t> strata(static_cast<size_t>(campaign.latin_hypercube));
  std::iota(strata.begin(), strata.end(), 0);
  Stream stream(campaign.seed, "campaign strata", key, block);
  // Fisher and Yates, from the front: only what is asked for is shuffled.
  for (size_t i = 0; i <= static_cast<size_t>(place); ++i) {
    const size_t other = i + stream.UniformInt(strata.size() - i);
    std::swap(strata[i], strata[other]);
  }
  return strata[static_cast<size_t>(place)];
}

/// Returns a number in [0, 1), uniform over the repetitions.
double UniformOf(const Campaign& campaign, const std::string& key, int64_t repetition) {
  const double plain = Stream(campaign.seed, "campaign sample", key, repetition).Uniform();
  if (campaign.latin_hypercube <= 1) return plain;
  const int64_t block = (repetition - 1) / campaign.latin_hypercube;
  const int64_t place = (repetition - 1) % campaign.latin_hypercube;
  const auto stratum = static_cast<double>(StratumOf(campaign, key, block, place));
  return (stratum + plain) / static_cast<double>(campaign.latin_hypercube);
}

std::string ValueOf(const SampledKey& key, double uniform) {
  constexpr double kLeast = 0x1p-60;  // The quantile of 0 is infinite.
  switch (key.kind) {
    case SampleKind::kChoice: {
      const auto size = static_cast<double>(key.choices.size());
      const auto index = static_cast<size_t>(uniform * size);
      return key.choices[std::min(index, key.choices.size() - 1)];
    }
    case SampleKind::kNormal:
      return TomlNumber(key.first + key.second * NormalQuantile(std::max(uniform, kLeast)));
    case SampleKind::kUniform:
      break;
  }
  if (!key.is_integer) return TomlNumber(key.first + (key.second - key.first) * uniform);
  const double count = key.second - key.first + 1;
  return TomlNumber(std::min(key.first + std::floor(uniform * count), key.second));
}

}  // namespace

uint64_t SeedOf(const Campaign& campaign, int64_t repetition) {
  constexpr int kBits = 48;
  return Stream(campaign.seed, "campaign trial", repetition).Bits() >> (64 - kBits);
}

std::vector<std::string> SamplesOf(const Campaign& campaign, int64_t repetition) {
  SHOAL_CHECK(repetition >= 1, "repetitions count from 1");
  std::vector<std::string> samples;
  for (const SampledKey& key : campaign.samples) {
    samples.push_back(ValueOf(key, UniformOf(campaign, key.key, repetition)));
  }
  return samples;
}

}  // namespace shoal
