// The channels that a process subscribes to, asked for every total of every tick: most are not in
// it, and differ in their last letters, the vehicle's name.
#pragma once

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_set>

namespace shoal {

/// For containers that are asked for a std::string_view.
struct TextHash {
  using is_transparent = void;
  size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};

class ChannelSet {
 public:
  void Add(std::string_view channel) {
    channels_.emplace(channel);
    seen_.set(KeyOf(channel));
  }

  bool Contains(std::string_view channel) const {
    return seen_.test(KeyOf(channel)) && channels_.contains(channel);
  }

 private:
  static constexpr size_t kNumKeys = 4096;

  /// A number that most other channels do not share: of the size and the last letters.
  static size_t KeyOf(std::string_view channel) {
    constexpr size_t kLetters = 4;
    size_t key = channel.size();
    for (size_t i = channel.size() - std::min(channel.size(), kLetters); i < channel.size(); ++i) {
      key = key * 31 + static_cast<uint8_t>(channel[i]);
    }
    return key % kNumKeys;
  }

  std::bitset<kNumKeys> seen_;  ///< Keys of the channels.
  std::unordered_set<std::string, TextHash, std::equal_to<>> channels_;
};

}  // namespace shoal
