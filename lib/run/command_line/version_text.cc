#include "lib/run/command_line/version_text.h"

#include <fmt/format.h>

#include "lib/run/command_line/build_facts.h"

namespace shoal {

std::string VersionText(std::string_view program) {
  return fmt::format("{} {}", program, TextOf(OwnBuild()));
}

}  // namespace shoal
