// A shell script that is read: its name and arguments, the files that it has made, and what could
// not be read of it. Nothing is run.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lib/tools/moos/nsplug.h"
#include "lib/tools/moos/shell_text.h"

namespace shoal {

/// No script runs more, those that it calls counted.
inline constexpr int kMaxShellCommands = 50'000;

struct ShellScript {
  std::string name;  ///< Without its folder.
  std::string from;  ///< With it.
  ShellWords arguments;
  bool is_ended = false;
};

class ShellRun {
 public:
  /// `find` may be empty, and outlives this.
  explicit ShellRun(const FindMoosFile& find) : find_(find) {}

  ShellScript& script() { return script_; }
  const ShellScript& script() const { return script_; }

  /// Keeps "launch.sh:12: TEXT", each text once.
  void Note(int line, const std::string& text);
  const std::vector<std::string>& notes() const { return notes_; }

  /// Counts commands; long work counts as several. Returns false once there are too many.
  bool Count(int num_commands);
  bool IsTooLong() const { return num_commands_ > kMaxShellCommands; }

  /// Finds a file of the mission.
  std::optional<MoosSource> Find(std::string_view name) const;
  /// Returns what the script has written to a file; nullptr: nothing.
  const std::string* FindMade(std::string_view name) const;
  bool HasFile(std::string_view name) const;
  /// Writes a line to a file that the script makes.
  void Write(const std::string& name, bool appends, const std::string& line);

  /// Computes a sum of whole numbers and variables; notes one that has no exact result.
  std::string Sum(std::string_view plain, int line,
                  const std::function<std::string_view(std::string_view)>& value_of);

 private:
  const FindMoosFile& find_;
  ShellScript script_;
  std::vector<std::string> notes_;
  std::set<std::string> noted_;  ///< Their texts.
  std::map<std::string, std::string, std::less<>> made_files_;
  int num_commands_ = 0;
};

}  // namespace shoal
