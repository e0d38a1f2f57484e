// The address of the viewer that `shoal run --view` starts: the viewer writes it to its log, and
// the launcher shows it. Once a page is open the viewer writes that too.
#pragma once

#include <cstdint>
#include <string>

#include "lib/run/launch/launch_terminal.h"

namespace shoal {

class ViewerAddress {
 public:
  /// The viewer has been started at `wall_us`.
  void Await(const std::string& log_path, int64_t wall_us);
  /// Shows the address once the log has it; a warning where that takes too long.
  void OnTime(int64_t wall_us, LaunchTerminal* terminal);
  /// The viewer has ended.
  void Forget() { log_path_.clear(); }
  /// Returns true once the viewer has written that a page is open.
  static bool HasPage(const std::string& log_path);

 private:
  std::string log_path_;  ///< Empty: nothing is awaited.
  int64_t started_us_ = 0;
  int64_t next_look_us_ = 0;
};

}  // namespace shoal
