#include "lib/run/command_line/build_facts.h"

#include <fmt/format.h>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/run/command_line/build_id.h"
#include "lib/run/command_line/version.h"

namespace shoal {

BuildFacts OwnBuild() {
  return {.version = kVersion, .build = BuildId(), .arithmetic = ArithmeticId()};
}

std::string TextOf(const BuildFacts& facts) {
  return fmt::format("{} (build {}, arithmetic {})", facts.version, facts.build, facts.arithmetic);
}

std::string WhyNotTogether(const BuildFacts& its, const BuildFacts& own) {
  const auto shown = [](const std::string& text) { return text.empty() ? "unknown" : text; };
  if (its.version != own.version) {
    return fmt::format("its shoal is {}, not {}: install the same version on both",
                       shown(its.version), own.version);
  }
  if (its.arithmetic != own.arithmetic) {
    return fmt::format(
        "its arithmetic is {}, not {}, so that the same mission would go another way: install the "
        "same shoal on both, compiled with the options that its CMake files set",
        shown(its.arithmetic), own.arithmetic);
  }
  return {};
}

}  // namespace shoal
