// When a process that waits for the next tick may sleep through the messages before it: they stay
// in the sockets' buffers until the tick comes, and it wakes up once per step. Not a process with
// many of them, which reads them while the others still work; nor where they might not fit the
// buffers; nor for long: messages come from outside, too. Pure.
//
//   WakeRule rule(ReceiveBufferLimit());
//   rule.OnDatagram();                          // for each that comes
//   rule.OnStep(now_us);                        // a step has been answered
//   transport.Poll(rule.Timeout(wanted_us, now_us), -1,
//                  rule.SleepsThrough(now_us) ? WakeFor::kSteps : WakeFor::kAll);
#pragma once

#include <algorithm>
#include <cstdint>

namespace shoal {

class WakeRule {
 public:
  /// Steps that follow each other faster leave no time for a flood to fill the buffers.
  static constexpr int64_t kLongestSleep_us = 50'000;
  /// Of a receive buffer, for a datagram of some hundred bytes: the kernel's own part counts too.
  static constexpr int64_t kBytesOfDatagram = 2'048;
  /// Datagrams of a step, on average, that a process reads in a tenth of a millisecond.
  static constexpr double kFew = 24;
  /// A relay hands them on and does not handle them; it wakes up for each STEP_DONE, and reads then
  /// what has come.
  static constexpr double kFewOfRelay = 400;

  /// `buffer_bytes`: of each socket's receive buffer. `few`: datagrams of a step, on average, up to
  /// which the process sleeps.
  explicit WakeRule(int64_t buffer_bytes, double few = kFew)
      : most_(buffer_bytes / kBytesOfDatagram), few_(few) {}

  void OnDatagram() { ++num_datagrams_; }

  /// A step has been answered. A step with many messages is remembered for some hundred others.
  void OnStep(int64_t now_us) {
    constexpr double kPeakMemory = 0.99;
    constexpr double kMeanMemory = 0.9;
    const auto num = static_cast<double>(num_datagrams_);
    peak_ = std::max(kPeakMemory * peak_, num);
    mean_ = kMeanMemory * mean_ + (1 - kMeanMemory) * num;
    num_datagrams_ = 0;
    answered_us_ = now_us;
  }

  bool SleepsThrough(int64_t now_us) const {
    return mean_ <= few_ && peak_ <= static_cast<double>(most_) &&
           now_us - answered_us_ < kLongestSleep_us;
  }
  /// Returns how long to wait instead of `wanted_us`.
  int64_t Timeout(int64_t wanted_us, int64_t now_us) const {
    if (!SleepsThrough(now_us)) return wanted_us;
    return std::min(wanted_us, answered_us_ + kLongestSleep_us - now_us);
  }

 private:
  const int64_t most_;  ///< Datagrams in a step that surely fit.
  const double few_;
  double peak_ = 0;            ///< Datagrams in a step, the most of those remembered.
  double mean_ = 0;            ///< Datagrams in a step, of late.
  int64_t num_datagrams_ = 0;  ///< Since the last answer.
  int64_t answered_us_ = -kLongestSleep_us;
};

}  // namespace shoal
