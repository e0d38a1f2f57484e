#include "lib/tools/page/script_hash.h"

#include <gtest/gtest.h>

namespace shoal {

TEST(ScriptHash, IsThatOfThePublishedExample) {
  // "alert('Hello, world.');": Content Security Policy Level 3, 2.3.1 and 6.7.3.3.
  EXPECT_EQ(ScriptHash("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

}  // namespace shoal
