#include "lib/tools/view/link_history.h"

#include <algorithm>

namespace shoal {

namespace {
constexpr double kLatest_s = 366.0 * 86400;
}  // namespace

void LinkHistory::Add(const FateFacts& facts, double t_s) {
  t_s = std::clamp(t_s, 0.0, kLatest_s);
  while (t_s >= bin_s_ * static_cast<double>(kMaxBins)) {
    bin_s_ *= 2;
    for (size_t i = 0; 2 * i < bins_.size(); ++i) {
      Counts pair = bins_[2 * i];
      if (2 * i + 1 < bins_.size()) {
        pair.received += bins_[2 * i + 1].received;
        pair.offered += bins_[2 * i + 1].offered;
      }
      bins_[i] = pair;
    }
    bins_.resize((bins_.size() + 1) / 2);
  }
  const auto bin = static_cast<size_t>(t_s / bin_s_);
  if (bin >= bins_.size()) bins_.resize(bin + 1);
  ++bins_[bin].offered;
  if (IsReceived(facts.cause)) ++bins_[bin].received;

  if (!(facts.range_m >= 0)) return;
  if (ranges_.size() == kMaxRanges) ranges_.pop_front();
  ranges_.push_back({.t_s = t_s, .range_m = facts.range_m, .limit_m = facts.limit_m});
}

std::vector<RatioBin> LinkHistory::Bins() const {
  std::vector<RatioBin> bins;
  for (size_t i = 0; i < bins_.size(); ++i) {
    if (bins_[i].offered == 0) continue;
    bins.push_back({.begin_s = static_cast<double>(i) * bin_s_,
                    .received = bins_[i].received,
                    .offered = bins_[i].offered});
  }
  return bins;
}

}  // namespace shoal
