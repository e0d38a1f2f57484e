// A second, plainer reading of docs/communication/media.md for tests: what carries each
// transmission over each hop, and when it is there.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "lib/mission/model/mission.h"
#include "shoal/fate_medium_t.hpp"

namespace shoal::media_hops_test {

constexpr int64_t kStep_us = 100'000;

struct Place {
  double x_m = 0;
  double depth_m = 0;
};

class HopOracle {
 public:
  using Places = std::array<Place, 5>;

  /// Where a share of a medium's jitter lay that was seen.
  struct JitterSeen {
    double least = 1;
    double most = 0;
  };

  explicit HopOracle(const Mission& mission) : mission_(mission) {}

  /// The broker handles a transmission at `utime`, with all at `places`.
  void Take(const std::string& kind, const std::string& source, size_t num_bytes, int64_t utime,
            const Places& places) {
    sent_[{kind, source, num_sent_[{kind, source}]++}] = {utime, num_bytes, places};
  }
  /// The same of one that a gateway refuses: it only has a number.
  void TakeRefused(const std::string& kind, const std::string& source) {
    ++num_sent_[{kind, source}];
  }

  /// Compares a fate that was published at `utime`.
  void Compare(const fate_medium_t& fate, int64_t utime) {
    if (fate.cause == "already_received" && fate.medium.empty()) return;
    const auto found = sent_.find({fate.kind, fate.source, fate.number});
    ASSERT_NE(found, sent_.end()) << fate.kind << ' ' << fate.number << " of " << fate.source;
    const Sent& sent = found->second;
    const Place from = sent.places.at(IndexOf(fate.source));
    const Place to = sent.places.at(IndexOf(fate.destination));
    const double range_m = std::hypot(from.x_m - to.x_m, from.depth_m - to.depth_m);
    const std::string words = fate.source + " to " + fate.destination + ": " + fate.cause;
    ++num_compared;
    const std::string expected = Carrier(fate, from, to, range_m);
    if (expected != "vhf" && expected != "acoustic") {
      EXPECT_EQ(fate.cause, expected) << words;
      EXPECT_EQ(utime, sent.utime) << words;
      return;
    }
    EXPECT_EQ(fate.medium, expected) << words;
    EXPECT_NEAR(fate.range_m, range_m, 1e-6) << words;
    if (fate.delay_s < 0) {
      EXPECT_EQ(expected, "acoustic") << words << ": radio always takes some time";
      return;
    }
    ++num_timed;
    CompareTimes(fate, utime, sent, range_m, words);
  }

  int64_t num_compared = 0;
  int64_t num_timed = 0;
  std::map<std::string, JitterSeen> jitters;  ///< By medium.

 private:
  struct Sent {
    int64_t utime = 0;  ///< Of the broker's step.
    size_t num_bytes = 0;
    Places places;
  };

  size_t IndexOf(const std::string& name) const {
    return static_cast<size_t>(std::ranges::find(mission_.vehicles, name, &Vehicle::name) -
                               mission_.vehicles.begin());
  }
  bool Has(const std::string& vehicle, const std::string& medium) const {
    const auto& names = mission_.vehicles[IndexOf(vehicle)].media.names;
    return std::ranges::find(names, medium) != names.end();
  }

  /// Returns what carries it, or the cause where nothing does.
  std::string Carrier(const fate_medium_t& fate, const Place& from, const Place& to,
                      double range_m) const {
    const auto both_have = [&](const std::string& medium) {
      return Has(fate.source, medium) && Has(fate.destination, medium);
    };
    std::string fault = "no_medium";
    if (both_have("vhf")) {
      if (std::max(from.depth_m, to.depth_m) > 0.5) {
        fault = "submerged";
      } else if (range_m >= 800) {
        fault = "out_of_range";
      } else {
        return "vhf";
      }
    }
    return both_have("acoustic") ? "acoustic" : fault;
  }

  /// It leaves one step before the broker handles it, and its fate is of the first step that is not
  /// before its end.
  void CompareTimes(const fate_medium_t& fate, int64_t utime, const Sent& sent, double range_m,
                    const std::string& words) {
    double surely_s = 0;
    double jitter_s = 0;
    if (fate.medium == "vhf") {
      const RadioOptions& radio = mission_.media.front().radio;
      surely_s = radio.latency_s + 8 * static_cast<double>(sent.num_bytes) / radio.rate_bps;
      jitter_s = radio.jitter_s;
    } else {
      constexpr size_t kChecksum_bytes = 4;
      const AcousticOptions& sound = mission_.acoustics.options;
      surely_s = range_m / sound.sound_speed_mps +
                 8 * static_cast<double>(sent.num_bytes + kChecksum_bytes) / sound.data_rate_bps;
      jitter_s = sound.max_jitter_s;
    }
    constexpr double kRounding_s = 1e-6;
    const double share = (fate.delay_s - surely_s) / jitter_s;
    EXPECT_GE(fate.delay_s, surely_s - kRounding_s) << words;
    EXPECT_LE(fate.delay_s, surely_s + jitter_s + kRounding_s) << words;
    JitterSeen& seen = jitters[fate.medium];
    seen.least = std::min(seen.least, share);
    seen.most = std::max(seen.most, share);

    const double end_us = static_cast<double>(sent.utime - kStep_us) + fate.delay_s * 1e6;
    EXPECT_GE(static_cast<double>(utime), end_us - 1) << words << " before it was there";
    if (utime > sent.utime) {
      EXPECT_LT(static_cast<double>(utime - kStep_us), end_us + 1) << words << " a step too late";
    }
  }

  const Mission& mission_;
  std::map<std::tuple<std::string, std::string, int64_t>, Sent> sent_;  ///< Kind, source, number.
  std::map<std::pair<std::string, std::string>, int64_t> num_sent_;     ///< Kind, source.
};

}  // namespace shoal::media_hops_test
