#include "lib/run/launch/launch_terminal.h"

#include <unistd.h>

#include <cstdio>

#include "lib/base/text/terminal_text.h"

namespace shoal {

LaunchTerminal::LaunchTerminal() : is_interactive_(isatty(STDOUT_FILENO) == 1) {}

void LaunchTerminal::Print(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void LaunchTerminal::EndProgress() {
  if (has_progress_) Print("\n");
  has_progress_ = false;
}

void LaunchTerminal::Show(const std::string& line) {
  EndProgress();
  Print(TerminalText(line) + "\n");
}

void LaunchTerminal::Warn(const std::string& line) {
  EndProgress();
  std::fflush(stdout);
  std::fputs((TerminalText(line) + "\n").c_str(), stderr);
}

void LaunchTerminal::ShowProgress(const std::string& line) {
  Print((is_interactive_ ? "\r\033[K" : "") + line + (is_interactive_ ? "" : "\n"));
  has_progress_ = is_interactive_;
}

}  // namespace shoal
