// A folder for files that are of no use afterwards.
#pragma once

#include <string>
#include <string_view>

#include "lib/bus/os/file_descriptor.h"

namespace shoal {

/// An empty folder of mode 0700, $TMPDIR/NAME-XXXXXX, that goes with this. Those of the same name
/// that processes of this user left behind when they were killed are removed first: each is locked
/// as long as its process, or a copy of it, lives.
class ScratchFolder {
 public:
  explicit ScratchFolder(std::string_view name);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  /// Empty: none could be made.
  const std::string& path() const { return path_; }

 private:
  FileDescriptor lock_;
  std::string path_;
};

}  // namespace shoal
