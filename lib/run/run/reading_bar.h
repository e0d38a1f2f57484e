// A bar on standard error while a long log is read; only on a terminal, and not before it takes a
// while.
//
//   ReadingBar bar(path);
//   bar.Show(0.4);
#pragma once

#include <cstdint>
#include <string>

namespace shoal {

class ReadingBar {
 public:
  explicit ReadingBar(std::string path);
  ~ReadingBar();
  ReadingBar(const ReadingBar&) = delete;
  ReadingBar& operator=(const ReadingBar&) = delete;

  /// Shows the share of the log that was read; removes the bar at 1.
  void Show(double share);

 private:
  void Clear();

  const std::string path_;
  const bool is_terminal_;
  int64_t next_us_;
  bool is_shown_ = false;
};

}  // namespace shoal
