// One script of the modules of a page: browsers load no module from beside a file:// page.
#pragma once

#include <string>
#include <string_view>

#include "apps/viewer/page_files.h"
#include "lib/base/check/result.h"

namespace shoal {

/// Returns the module `entry`, such as "/app.js", and all that it imports as one module, each in a
/// scope of its own. Statements of import and export begin lines; what is imported is named in
/// braces, or is the default of a module that ends in `export { name as default };`; no exported
/// variable changes. Fails for a module that is not there, and for two that import each other.
[[nodiscard]] Result<std::string> BundleModules(const PageFiles& files, const std::string& entry);

}  // namespace shoal
