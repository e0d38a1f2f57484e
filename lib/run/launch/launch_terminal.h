// What `shoal run` writes to its terminal: results and progress to standard output, trouble to
// standard error. On a terminal the progress line is drawn over; other lines start below it. Lines
// lose control characters: they may quote a participant or a computer that means no good.
#pragma once

#include <string>
#include <string_view>

namespace shoal {

class LaunchTerminal {
 public:
  LaunchTerminal();

  /// Writes to standard output as it is. A closed pipe does not end the mission.
  static void Print(std::string_view text);

  /// Writes a line to standard output.
  void Show(const std::string& line);
  /// Writes a line to standard error.
  void Warn(const std::string& line);
  /// Writes the progress line; on a terminal, over the last one.
  void ShowProgress(const std::string& line);
  /// Starts a new line below the progress line.
  void EndProgress();

  /// Standard output is a terminal.
  bool is_interactive() const { return is_interactive_; }

 private:
  const bool is_interactive_;
  bool has_progress_ = false;  ///< The cursor is behind the progress line.
};

}  // namespace shoal
