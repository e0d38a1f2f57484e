// Reads a file of the user's whole, or says in his words why not.
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
