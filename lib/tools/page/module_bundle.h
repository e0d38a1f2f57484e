// One script of the modules of a page: browsers load no module from beside a file:// page.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "lib/base/check/result.h"

namespace shoal {

/// Modules by path, such as "/page/dom.js".
using ModuleTexts = std::map<std::string, std::string_view, std::less<>>;

/// Returns the module `entry`, such as "/app.js", and all that it imports as one module, each in a
/// scope of its own. Statements of import and export begin lines; what is imported is named in
/// braces, or is the default of a module that ends in `export { name as default };`; no exported
/// variable changes. Fails for a module that is not there, and for two that import each other.
[[nodiscard]] Result<std::string> BundleModules(const ModuleTexts& modules,
                                                const std::string& entry);

}  // namespace shoal
