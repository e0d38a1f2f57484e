// Which frequencies the nodes of an acoustic network send and receive on.
//
//   Result<ChannelPlan> plan = ChannelPlan::Make(options, nodes);
//   if (!plan.ok()) return plan.error();   // "8 nodes need 10.25 kHz ..., band holds 7 channels"
//   plan->channel(plan->SendsOn(node)).freq_khz
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/sea/acoustics/acoustic_options.h"

namespace shoal {

/// One node of the acoustic network.
struct AcousticNode {
  std::string name;        ///< Names the node's random draws; unique.
  int address = 0;         ///< fdma names the node's channel after it.
  bool is_leader = false;  ///< Matters in tdma_lf.
};

struct AcousticChannel {
  int id = 0;
  double freq_khz = 0;  ///< Of its middle.
  double bandwidth_khz = 0;
  bool is_broadcast = false;

  bool operator==(const AcousticChannel&) const = default;
};

/// Returns how many channels fit the band with a guard band beside each: n channels need
/// n C + (n + 1) G of the band's B, so n = floor((B - G) / (C + G)). (muNet counts one guard band
/// too many.) At most kMaxChannels; 0 where the options are invalid.
[[nodiscard]] int ChannelCapacity(const AcousticOptions& options);
inline constexpr int kMaxChannels = 1'000'000;
inline constexpr int kMaxBroadcastAddress = 1'000'000'000;

/// Returns what `count` channels and their guard bands take.
[[nodiscard]] double BandNeeded_khz(const AcousticOptions& options, int count);

/// Returns the middles of the first channels of the band in the options' order, for at least
/// `count` of them, or all that fit where these are fewer. center_out puts the first onto the base
/// frequency, which leaves room for an odd number; where `count` is more than that, for the even
/// number that fits, all move by half a channel's distance.
[[nodiscard]] std::vector<double> ChannelFreqs_khz(const AcousticOptions& options, int count);

class ChannelPlan {
 public:
  /// Gives each node its channel. Fails where one would be left without.
  static Result<ChannelPlan> Make(const AcousticOptions& options,
                                  std::span<const AcousticNode> nodes);

  /// Gives one more node its channel and returns the node's index, or why there is none;
  /// leaves the others' channels as they are.
  Result<int> Add(const AcousticNode& node);

  int num_nodes() const { return static_cast<int>(nodes_.size()); }
  std::span<const AcousticChannel> channels() const { return channels_; }
  const AcousticChannel& channel(int index) const { return channels_[static_cast<size_t>(index)]; }

  /// Return indices of channels, and take those of nodes.
  int SendsOn(int node) const { return nodes_[static_cast<size_t>(node)].sends_on; }
  bool ReceivesOn(int node, int channel) const;

 private:
  struct Place {
    int sends_on = 0;
    bool is_leader = false;
  };

  explicit ChannelPlan(const AcousticOptions& options) : options_(options) {}
  int UnusedId(int wanted) const;
  void AddChannel(int id, double freq_khz, double bandwidth_khz, bool is_broadcast);

  AcousticOptions options_;
  std::vector<double> freqs_khz_;  ///< fdma: of all channels that may still be given away.
  std::vector<AcousticChannel> channels_;
  std::vector<Place> nodes_;
  std::set<int> ids_;  ///< Of the channels.
};

}  // namespace shoal
