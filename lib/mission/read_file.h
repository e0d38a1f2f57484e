// Reads a whole text file, or returns a user-readable error. What is read is bounded, whatever the
// path leads to.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace shoal {

struct FileText {
  std::string text;
  std::string problem;  ///< Why there is no text; empty where there is.
};

inline constexpr size_t kLargestFile_bytes = 100'000'000;
inline constexpr size_t kLargestRunFile_bytes = size_t{4} << 20;  ///< Of files that shoal writes.

/// Returns the text of the file that a user names, which may be a pipe: `shoal check <(...)`.
[[nodiscard]] FileText ReadFile(const std::string& path);

/// Returns the text of a file that another file names, or that lies beside one: a regular file,
/// which a link may lead to. A pipe, for which the reader would wait, and a device are refused.
[[nodiscard]] FileText ReadRegularFile(const std::string& path,
                                       size_t most_bytes = kLargestFile_bytes);

/// Lists the regular files that ReadRegularFile has read in this thread while the list lives: what
/// a mission consists of beside its own file.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Paths as they were given, in order, each once.
  const std::set<std::string>& paths() const { return paths_; }

 private:
  friend FileText ReadRegularFile(const std::string& path, size_t most_bytes);
  std::set<std::string> paths_;
  FilesRead* const outer_;  ///< The list that this one hides while it lives.
};

/// Returns the text of the open file `fd` from where it is.
[[nodiscard]] FileText ReadOpenFile(int fd, size_t most_bytes);

}  // namespace shoal
