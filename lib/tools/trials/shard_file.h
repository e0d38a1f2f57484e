// The results of one shard: append-only, one line per finished trial.
#pragma once

#include <string>
#include <string_view>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"

namespace shoal {

class ShardFile {
 public:
  /// Opens or makes the file, and locks it for as long as this lives. What a killed process left
  /// half written is closed off by a line feed. An error where another process has the lock, or the
  /// file cannot be written.
  [[nodiscard]] static Result<ShardFile> Open(const std::string& path);

  /// Writes the line and a line feed at once, so that a kill at any time tears the last line at
  /// most. Returns why it could not be written, or an empty string.
  [[nodiscard]] std::string Append(std::string_view line);

  /// Returns once all lines are on the disk, or why they are not.
  [[nodiscard]] std::string Sync();

  /// For a forked worker: gives up the file without unlocking it for the parent.
  void Abandon() { static_cast<void>(file_.Close()); }

 private:
  ShardFile(FileDescriptor file, std::string path);

  FileDescriptor file_;
  std::string path_;
  bool is_synced_ = true;
};

}  // namespace shoal
