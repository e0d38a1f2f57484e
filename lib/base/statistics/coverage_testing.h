// Simulated campaigns with a known truth: how often an interval covers it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <concepts>
#include <string>

#include "lib/base/random/stream.h"

namespace shoal {

inline constexpr int kSimulatedCampaigns = 10'000;

/// Returns the share of simulated campaigns of which `covers(stream)` is true, and records it in
/// the test's XML under `name`; docs/campaigns/report.md lists the figures.
template <std::predicate<Stream*> Covers>
double MeasureCoverage(const std::string& name, Covers covers) {
  int num_covered = 0;
  for (int campaign = 0; campaign < kSimulatedCampaigns; ++campaign) {
    Stream stream(18, "coverage", name, campaign);
    if (covers(&stream)) ++num_covered;
  }
  const double coverage = static_cast<double>(num_covered) / kSimulatedCampaigns;
  ::testing::Test::RecordProperty(name, std::to_string(coverage));
  return coverage;
}

/// Returns what a coverage of exactly `confidence` is measured to be at least, but for three
/// standard deviations of chance.
inline double LeastCoverage(double confidence) {
  return confidence - 3 * std::sqrt(confidence * (1 - confidence) / kSimulatedCampaigns);
}

}  // namespace shoal
