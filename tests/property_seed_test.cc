// Property tests fail in every run or in none.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cstdlib>
#include <string_view>

namespace shoal::property_seed_test {

TEST(PropertyTests, DrawTheSameCasesInEveryRun) {
  const char* parameters = std::getenv("RC_PARAMS");
  ASSERT_NE(parameters, nullptr) << "tests/property_seed.cc is not linked into this test";
  if (std::string_view(parameters) != "seed=14")
    GTEST_SKIP() << "this run has RC_PARAMS=" << parameters;
  EXPECT_EQ(rc::detail::configuration().testParams.seed, 14U);
}

}  // namespace shoal::property_seed_test
