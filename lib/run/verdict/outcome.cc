#include "lib/run/verdict/outcome.h"

#include <fmt/format.h>

namespace shoal {

std::string FormatExcess(double excess) {
  return excess < 0.1 ? fmt::format("{:.2g}", excess) : fmt::format("{:.1f}", excess);
}

}  // namespace shoal
