// For tests of the loader only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/file/load.h"

namespace shoal {

/// The shortest mission that there is; what a test appends begins in line 5.
constexpr std::string_view kShortest = R"([mission]
duration_s = 60
[[vehicle]]
name = "alpha"
)";

/// Returns the errors of `text`, one per line, without the name of the file where it begins them.
inline std::string ErrorsOf(std::string_view text, const std::vector<std::string>& overrides = {}) {
  std::string all;
  for (std::string error : LoadMissionText(text, "m.toml", overrides).errors) {
    if (error.starts_with("m.toml:")) error.erase(0, 7);
    all += error + "\n";
  }
  return all;
}

/// Returns the errors of kShortest with `more` after it.
inline std::string ErrorsAfter(std::string_view more,
                               const std::vector<std::string>& overrides = {}) {
  return ErrorsOf(std::string(kShortest) + std::string(more), overrides);
}

/// Returns the warnings of `loaded` without those of WarnOfConduct, which are due to tests'
/// missions being as short as they can be: no vehicle is deployed, all start at one place.
inline std::vector<std::string> WarningsBesideConduct(const LoadedMission& loaded) {
  std::vector<std::string> warnings;
  for (const std::string& warning : loaded.warnings) {
    const bool is_of_conduct = warning.find("no vehicle is ever deployed") != std::string::npos ||
                               warning.find(": a collision") != std::string::npos;
    if (!is_of_conduct) warnings.push_back(warning);
  }
  return warnings;
}

}  // namespace shoal
