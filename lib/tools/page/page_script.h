// One script of several modules, for a page that is a single file: browsers load no module from
// beside a file:// page.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace shoal {

/// Returns the modules as one script that defines nothing outside itself: without their import
/// statements and the word export. The names at the top of the modules are one scope, in which
/// uPlot is `uPlot`.
/// @pre A module stands after those that it imports; `import` and `export` begin lines, and a
///     statement of them ends with ';' at the end of a line.
[[nodiscard]] std::string OneScript(std::span<const std::string_view> modules);

/// Returns "'sha256-...'", by which a page's Content-Security-Policy (W3C, level 3) allows this
/// script and no other.
[[nodiscard]] std::string ScriptHash(std::string_view script);

}  // namespace shoal
