// Where the files that come with shoal are: in the tree that it was built in, or installed.
//
//   const auto index = FindOwnFile("docs/index.md", ExecutableDirectory());
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace shoal {

/// Returns the absolute path of a file or folder of the repository, named from its root
/// ("examples/recorded", "docs/index.md"). A program in ROOT/build/bin finds it in ROOT; one that
/// is installed in PREFIX/lib/shoal/bin finds pages in PREFIX/share/doc/shoal and all else in
/// PREFIX/share/shoal. Nothing where neither has it.
[[nodiscard]] std::optional<std::string> FindOwnFile(std::string_view path,
                                                     std::string_view program_dir);

}  // namespace shoal
