// Reads a whole text file, or returns a user-readable error. What is read is bounded, whatever the
// path leads to.
#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

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

/// Opens such a file for reading, for what reads it by itself; an error is a text without the path.
[[nodiscard]] Result<FileDescriptor> OpenRegularFile(const std::string& path);

/// Lists the file as one that was read, for what keeps its contents from another time.
void NoteFileRead(const std::string& path);

/// Lists the regular files that ReadRegularFile or OpenRegularFile have opened in this thread while
/// the list lives: what a mission consists of beside its own file.
class FilesRead {
 public:
  FilesRead();
  ~FilesRead();
  FilesRead(const FilesRead&) = delete;
  FilesRead& operator=(const FilesRead&) = delete;

  /// Paths as they were given, in order, each once.
  const std::set<std::string>& paths() const { return paths_; }

 private:
  friend void NoteFileRead(const std::string& path);
  std::set<std::string> paths_;
  FilesRead* const outer_;  ///< The list that this one hides while it lives.
};

/// Returns the text of the open file `fd` from where it is.
[[nodiscard]] FileText ReadOpenFile(int fd, size_t most_bytes);

}  // namespace shoal
