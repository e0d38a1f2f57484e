// How many messages an app may take in one round, so that a round stays short.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shoal {

class RoundSize {
 public:
  /// A round may take this much processor time.
  static constexpr int64_t kTarget_us = 100'000;
  static constexpr int64_t kLeast = 20;
  static constexpr int64_t kMax = 20'000;

  /// Learns what a round cost.
  void AfterRound(int64_t num_messages, int64_t processor_us) {
    if (num_messages <= 0) return;
    // Rounds are weighted by what they handled, and count less as others follow.
    constexpr double kMemory = 0.7;
    messages_ = kMemory * messages_ + static_cast<double>(num_messages);
    spent_us_ = kMemory * spent_us_ + static_cast<double>(std::max<int64_t>(processor_us, 1));
  }

  int64_t most() const {
    if (messages_ == 0) return kMax;
    const double most = static_cast<double>(kTarget_us) * messages_ / spent_us_;
    return std::clamp<int64_t>(std::llround(std::min(most, 1e9)), kLeast, kMax);
  }

 private:
  double messages_ = 0;
  double spent_us_ = 0;
};

}  // namespace shoal
