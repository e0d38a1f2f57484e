// Draws from discrete distributions, made of a stream's uniform numbers.
#pragma once

#include <cstdint>

#include "lib/base/random/stream.h"

namespace shoal {

/// Returns how many of `trials` independent trials succeed. Exact, in a time that does not grow
/// with `trials`. @pre trials >= 0, 0 <= probability <= 1
int64_t DrawBinomial(int64_t trials, double probability, Stream* stream);

}  // namespace shoal
