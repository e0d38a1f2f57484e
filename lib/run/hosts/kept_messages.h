// The sealed messages of the last steps, as they came off the bus, so that a relay can hand them on
// unchanged and send them again. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/bus/bus/mission_secret.h"

namespace shoal {

class KeptMessages {
 public:
  KeptMessages(int64_t mission_id, const MissionSecret& secret);

  struct Kept {
    std::string channel;
    Bytes datagram;  ///< With its seal.
  };

  /// Keeps a sealed datagram. Returns its step where it is genuine and new; counts what is forged,
  /// of another mission, or beyond what is kept.
  std::optional<int64_t> Add(std::string_view channel, std::span<const uint8_t> datagram);

  /// How many messages of `publisher` on `channel` in `step` are there.
  int32_t Count(int64_t step, std::string_view publisher, std::string_view channel) const;

  /// Calls `use(const std::string& publisher, const Kept&)` for each message of `step`.
  template <class Use>
  void ForEach(int64_t step, Use use) const {
    const auto found = steps_.find(step);
    if (found == steps_.end()) return;
    for (const auto& [publisher, published] : found->second) {
      for (const auto& [sequence, kept] : published.by_sequence) use(publisher, kept);
    }
  }

  /// Forgets the steps before `step`, and refuses them from now on.
  void ForgetBefore(int64_t step);

  int64_t num_refused() const { return num_refused_; }

 private:
  struct Published {
    std::map<uint32_t, Kept> by_sequence;
    std::map<std::string, int32_t, std::less<>> num_by_channel;
  };

  const int64_t mission_id_;
  const MissionSecret secret_;
  std::map<int64_t, std::map<std::string, Published, std::less<>>> steps_;
  int64_t first_step_ = 0;
  size_t num_kept_ = 0;
  size_t kept_bytes_ = 0;
  int64_t num_refused_ = 0;
};

}  // namespace shoal
