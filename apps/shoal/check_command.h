// `shoal check` and `shoal channels`: what can be found out without running anything.
#pragma once

#include <string>
#include <vector>

namespace shoal {

/// Loads a mission file and prints all that is wrong with it, or, with `explain`, the whole mission
/// with every default. Returns the exit code: kExitEnvironment where the file is right and a
/// program that it names is missing on this machine.
int RunCheck(const std::string& mission_file, const std::vector<std::string>& overrides,
             bool explain);

/// Loads a mission file and prints the path of each key that --set can change, one per line.
/// Returns the exit code.
int RunKeys(const std::string& mission_file, const std::vector<std::string>& overrides);

/// Returns the table of all channels as Markdown: docs/reference/channels.md.
std::string ChannelsMarkdown();

}  // namespace shoal
