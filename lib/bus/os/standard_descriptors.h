// Standard input, output and error of a process whose caller closed them (`shoal ... >&-`, a
// daemon).
#pragma once

namespace shoal {

/// Makes sure that the descriptors 0, 1 and 2 are taken: else the next file or pipe gets one of
/// these numbers, and what is printed goes into it. Those that were closed stay useless: reading
/// from 0, and writing to 1 and 2, fails as before.
void TakeStandardDescriptors();

}  // namespace shoal
