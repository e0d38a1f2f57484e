// Keeps the files that a text from another computer names in the folder that came with it.
//
//   const OnlyFilesBelow bounds(folder);
//   LoadMission(folder + "/m.toml");  // Reads nothing outside of `folder`.
#pragma once

#include <string>

namespace shoal {

/// While it lives, this thread's ReadFile, ReadRegularFile and OpenRegularFile open nothing but
/// what lies below `folder` by its path, and do not look at anything else. Links in the folder are
/// followed: whoever made the folder has put none there. Where several live, all count.
class OnlyFilesBelow {
 public:
  explicit OnlyFilesBelow(const std::string& folder);
  ~OnlyFilesBelow();
  OnlyFilesBelow(const OnlyFilesBelow&) = delete;
  OnlyFilesBelow& operator=(const OnlyFilesBelow&) = delete;

 private:
  friend bool MayReadFile(const std::string& path);
  const std::string folder_;  ///< Absolute, without dots, with a slash at its end.
  const OnlyFilesBelow* const outer_;
};

/// Returns false where an OnlyFilesBelow of this thread keeps the file from being read.
[[nodiscard]] bool MayReadFile(const std::string& path);

}  // namespace shoal
