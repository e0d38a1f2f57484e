// `shoal spy`: LCM's own lcm-spy on a running mission, with shoal's message types.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

struct SpyOptions {
  int port_base = 0;                    ///< 0: the only one that runs, or that of this folder.
  std::string vehicle = {};             ///< Empty: the shore.
  std::string url = {};                 ///< Any LCM bus instead of a mission's.
  std::vector<std::string> types = {};  ///< Jars of other message types.
};

/// What it needs of the machine.
struct SpyPlace {
  std::function<bool(const std::string& path)> exists;
  std::string java;         ///< Path of the program with links resolved; empty: there is none.
  std::string program_dir;  ///< Of `shoal` itself.
  bool has_screen = true;
  std::string class_path = {};  ///< $CLASSPATH
};

/// Returns the words of the command, the program first; the error states what is missing and which
/// command installs it.
[[nodiscard]] Result<std::vector<std::string>> SpyCommand(const SpyPlace& place,
                                                          const SpyOptions& options,
                                                          const std::string& url);

/// Becomes lcm-spy; returns only with an exit code of failure.
int RunSpy(const SpyOptions& options);

}  // namespace shoal
