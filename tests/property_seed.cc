// Linked into every test (cmake/Shoal.cmake): property tests draw the same cases in every run,
// unless the environment has other RC_PARAMS. scripts/test --properties draws others, and more.
#include <cstdlib>

namespace {

[[maybe_unused]] const int kIsSet = setenv("RC_PARAMS", "seed=14", /*overwrite=*/0);

}  // namespace
