#include "lib/bus/record/channel_choice.h"

#include <fnmatch.h>

#include <algorithm>

namespace shoal {

bool Matches(const std::string& glob, const std::string& channel) {
  return ::fnmatch(glob.c_str(), channel.c_str(), 0) == 0;
}

bool TakesChannel(const std::vector<std::string>& only, const std::vector<std::string>& without,
                  std::string_view channel) {
  if (only.empty() && without.empty()) return true;
  const std::string name(channel);
  const auto matches = [&](const std::string& glob) { return Matches(glob, name); };
  return (only.empty() || std::any_of(only.begin(), only.end(), matches)) &&
         std::none_of(without.begin(), without.end(), matches);
}

}  // namespace shoal
