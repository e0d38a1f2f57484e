// A folder that may have come from elsewhere, and may hold links that lead to other files of the
// user: what is opened, made or removed through it lies in the folder itself.
//
//   const Result<PlainFolder> results = PlainFolder::Open("sweep");
//   const Result<PlainFolder> shards = results->Below("shards");
//   const Result<FileDescriptor> shard = shards->OpenFile("1-of-1.jsonl", O_APPEND);
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/read_file.h"

namespace shoal {

class PlainFolder {
 public:
  /// Opens the folder that a user names, which may be a link.
  [[nodiscard]] static Result<PlainFolder> Open(const std::string& path);

  /// Opens the folder `name` in this one; one that is missing is made, a link is refused.
  /// @pre `name` has no slash, as in the other functions
  [[nodiscard]] Result<PlainFolder> Below(const std::string& name) const;

  /// Opens the file `name` for reading and writing, with `flags` added. A missing file is
  /// made. Links, files that are not regular, and files that have a second name (hard links) are
  /// refused.
  [[nodiscard]] Result<FileDescriptor> OpenFile(const std::string& name, int flags) const;

  /// Opens the folder `name` in this one if it is there; a link is refused.
  [[nodiscard]] Result<PlainFolder> Existing(const std::string& name) const;

  /// Opens the file `name` for reading. Refused are links and what is not a regular file: a pipe is
  /// not waited for.
  [[nodiscard]] Result<FileDescriptor> FileToRead(const std::string& name) const;

  /// Returns the text of such a file. The problem is without its path.
  [[nodiscard]] FileText ReadText(const std::string& name,
                                  size_t most_bytes = kLargestFile_bytes) const;

  /// True where something bears the name, be it a link that leads nowhere.
  [[nodiscard]] bool Has(const std::string& name) const;

  /// Returns the names of what lies in the folder, in order.
  [[nodiscard]] std::vector<std::string> Names() const;

  /// Removes what bears the name, a folder with all in it; of a link, the link. Returns why it is
  /// still there, or an empty text.
  [[nodiscard]] std::string Remove(const std::string& name) const;

  const std::string& path() const { return path_; }

 private:
  PlainFolder(FileDescriptor fd, std::string path) : fd_(std::move(fd)), path_(std::move(path)) {}

  FileDescriptor fd_;
  std::string path_;
};

}  // namespace shoal
