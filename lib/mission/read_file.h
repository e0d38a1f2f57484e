// Reads a whole text file, or returns a user-readable error.
#pragma once

#include <string>

namespace shoal {

struct FileText {
  std::string text;
  std::string problem;  ///< Why there is no text; empty where there is.
};

/// Returns the text of a file of at most 100 MB.
[[nodiscard]] FileText ReadFile(const std::string& path);

}  // namespace shoal
