#include "lib/run/command_line/version_text.h"

#include <fmt/format.h>

#include "lib/run/command_line/build_id.h"
#include "lib/run/command_line/version.h"

namespace shoal {

std::string VersionText(std::string_view program) {
  return fmt::format("{} {} (build {})", program, kVersion, BuildId());
}

}  // namespace shoal
