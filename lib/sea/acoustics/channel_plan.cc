#include "lib/sea/acoustics/channel_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/base/check/check.h"
#include "lib/sea/acoustics/number_text.h"

namespace shoal {

namespace {

/// Widths such as 0.1 are no binary fractions: a channel that misses its place by less fits.
constexpr double kRoundingAllowance = 1e-9;

double Raster_khz(const AcousticOptions& options) {
  return options.channel_bandwidth_khz + options.guard_band_khz;
}

double LowestMiddle_khz(const AcousticOptions& options) {
  return options.base_freq_khz - options.bandwidth_khz / 2 + options.guard_band_khz +
         options.channel_bandwidth_khz / 2;
}

/// How many channels fit if one lies in the middle of the band.
int OddCapacity(int capacity) { return capacity - (capacity % 2 == 0 && capacity > 0 ? 1 : 0); }

std::string TooManyNodes(const AcousticOptions& options, int nodes) {
  return std::to_string(nodes) + " nodes need " + RoundedText(BandNeeded_khz(options, nodes)) +
         " kHz (" + std::to_string(nodes) + " x " + RoundedText(options.channel_bandwidth_khz) +
         " for channels, " + std::to_string(nodes + 1) + " x " +
         RoundedText(options.guard_band_khz) +
         " for guard bands), bandwidth_khz = " + RoundedText(options.bandwidth_khz) + " holds " +
         std::to_string(ChannelCapacity(options)) +
         (ChannelCapacity(options) == 1 ? " channel" : " channels") +
         "; widen bandwidth_khz, or narrow channel_bandwidth_khz or guard_band_khz";
}

}  // namespace

int ChannelCapacity(const AcousticOptions& options) {
  const double count = std::floor(
      (options.bandwidth_khz - options.guard_band_khz) / Raster_khz(options) + kRoundingAllowance);
  if (!(options.channel_bandwidth_khz > 0 && options.guard_band_khz >= 0 && count >= 1)) return 0;
  return static_cast<int>(std::min<double>(count, kMaxChannels));
}

double BandNeeded_khz(const AcousticOptions& options, int count) {
  return count * options.channel_bandwidth_khz + (count + 1.0) * options.guard_band_khz;
}

std::vector<double> ChannelFreqs_khz(const AcousticOptions& options, int count) {
  const int capacity = ChannelCapacity(options);
  const double raster_khz = Raster_khz(options);
  std::vector<double> freqs_khz;
  if (options.channel_order == ChannelOrder::kEdgeIn) {
    for (int i = 0; i < capacity; ++i) {
      freqs_khz.push_back(LowestMiddle_khz(options) + i * raster_khz);
    }
    return freqs_khz;
  }
  const bool one_in_the_middle = count <= OddCapacity(capacity);
  const double first_khz = options.base_freq_khz + (one_in_the_middle ? 0 : raster_khz / 2);
  for (int i = 0; i < (one_in_the_middle ? OddCapacity(capacity) : capacity); ++i) {
    const int steps = i % 2 == 1 ? (i + 1) / 2 : -(i / 2);
    // Without one in the middle the second channel mirrors the first: below comes before above.
    freqs_khz.push_back(first_khz + (one_in_the_middle ? steps : -steps) * raster_khz);
  }
  return freqs_khz;
}

Result<ChannelPlan> ChannelPlan::Make(const AcousticOptions& options,
                                      std::span<const AcousticNode> nodes) {
  ChannelPlan plan(options);
  const bool is_fdma = options.access_mode == AccessMode::kFdma;
  const bool is_tdma_lf = options.access_mode == AccessMode::kTdmaLf;
  const int wanted = is_fdma ? static_cast<int>(std::min<size_t>(nodes.size(), kMaxChannels + 1))
                             : (is_tdma_lf ? 2 : 1);
  const int capacity = ChannelCapacity(options);
  if (wanted > capacity) {
    if (is_fdma) return Error{"fdma: " + TooManyNodes(options, wanted)};
    return Error{std::string(ChoiceText(options.access_mode)) + " needs " + std::to_string(wanted) +
                 (wanted == 1 ? " channel (" : " channels (") +
                 RoundedText(BandNeeded_khz(options, wanted)) + " kHz), bandwidth_khz = " +
                 RoundedText(options.bandwidth_khz) + " holds " + std::to_string(capacity)};
  }
  if (is_tdma_lf && std::ranges::none_of(nodes, &AcousticNode::is_leader)) {
    return Error{"tdma_lf needs a leader, and no node is one: no node would receive another"};
  }
  plan.freqs_khz_ = ChannelFreqs_khz(options, wanted);
  if (!is_fdma) {
    const bool whole_band = options.access_mode == AccessMode::kTdma;
    plan.AddChannel(options.broadcast_address, plan.freqs_khz_[0],
                    whole_band ? options.bandwidth_khz : options.channel_bandwidth_khz, true);
    if (is_tdma_lf) {
      plan.AddChannel(plan.UnusedId(1), plan.freqs_khz_[1], options.channel_bandwidth_khz, false);
    }
  }
  for (const AcousticNode& node : nodes) {
    const Result<int> index = plan.Add(node);
    if (!index.ok()) return Error{index.error()};
  }
  return plan;
}

Result<int> ChannelPlan::Add(const AcousticNode& node) {
  Place place = {.is_leader = node.is_leader};
  if (options_.access_mode == AccessMode::kFdma) {
    const size_t next = channels_.size();
    if (next >= freqs_khz_.size()) {
      const int capacity = ChannelCapacity(options_);
      if (static_cast<int>(next) >= capacity) {
        return Error{"fdma: no channel is left for '" + node.name +
                     "': " + TooManyNodes(options_, num_nodes() + 1)};
      }
      return Error{"fdma: no channel is left for '" + node.name + "': the band holds " +
                   std::to_string(capacity) +
                   " channels only if all are laid out at the start; name it in the mission"};
    }
    place.sends_on = static_cast<int>(next);
    AddChannel(UnusedId(node.address), freqs_khz_[next], options_.channel_bandwidth_khz, false);
  } else if (options_.access_mode == AccessMode::kTdmaLf) {
    place.sends_on = node.is_leader ? 0 : 1;
  }
  nodes_.push_back(place);
  return num_nodes() - 1;
}

bool ChannelPlan::ReceivesOn(int node, int channel) const {
  const Place& place = nodes_[static_cast<size_t>(node)];
  switch (options_.access_mode) {
    case AccessMode::kShared:
    case AccessMode::kTdma:
      return true;
    case AccessMode::kTdmaLf:
    case AccessMode::kFdma:
      return channel != place.sends_on;
  }
  return false;
}

int ChannelPlan::UnusedId(int wanted) const {
  int id = wanted;
  while (id == options_.broadcast_address || ids_.contains(id)) {
    id = id == std::numeric_limits<int>::max() ? 1 : id + 1;
  }
  return id;
}

void ChannelPlan::AddChannel(int id, double freq_khz, double bandwidth_khz, bool is_broadcast) {
  SHOAL_CHECK(ids_.insert(id).second, "each channel has an id of its own");
  channels_.push_back({id, freq_khz, bandwidth_khz, is_broadcast});
}

}  // namespace shoal
