// Which channels a log takes: `--channels` and `--without` of what writes logs.
//
//   const ChannelChoice choice{.only = {"NAV_*"}, .without = {"NAV_ALPHA"}};
//   if (choice.Takes(message.channel)) ...
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// Returns true where the channel matches a glob, which may have * ? [a-z].
[[nodiscard]] bool Matches(const std::string& glob, const std::string& channel);

/// Returns true where `only` is empty or a glob of it matches the channel, and none of `without`
/// does.
[[nodiscard]] bool TakesChannel(const std::vector<std::string>& only,
                                const std::vector<std::string>& without, std::string_view channel);

struct ChannelChoice {
  std::vector<std::string> only = {};     ///< Names, or globs with * ? [a-z]; empty: all.
  std::vector<std::string> without = {};  ///< The same; they win over `only`.

  [[nodiscard]] bool Takes(std::string_view channel) const {
    return TakesChannel(only, without, channel);
  }
  [[nodiscard]] bool TakesAll() const { return only.empty() && without.empty(); }

  bool operator==(const ChannelChoice&) const = default;
};

}  // namespace shoal
