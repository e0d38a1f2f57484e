#include "lib/helm/modes/variables.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "lib/base/text/numbers.h"
#include "lib/helm/modes/value_text.h"

namespace shoal::variables_test {

TEST(Variables, KeepTheKindThatTheyHadFirst) {
  Variables variables;
  EXPECT_TRUE(variables.Set("A", 1.0, 0));
  EXPECT_TRUE(variables.Set("B", std::string("true"), 0));
  EXPECT_FALSE(variables.Set("A", std::string("true"), 1));
  EXPECT_FALSE(variables.Set("B", 1.0, 1));
  EXPECT_EQ(variables.Find("A")->value, VariableValue(1.0));
  EXPECT_EQ(variables.Find("A")->set_s, 0);
  EXPECT_EQ(variables.Find("C"), nullptr);
}

TEST(Variables, RefuseWhatIsNotANumberAndWhatHasNoName) {
  Variables variables;
  EXPECT_FALSE(variables.Set("", 1.0, 0));
  EXPECT_FALSE(variables.Set("A", std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(variables.Set("A", std::numeric_limits<double>::infinity(), 0));
  EXPECT_TRUE(variables.all().empty());
}

TEST(Variables, AreAtMostAThousand) {
  Variables variables;
  for (size_t i = 0; i < Variables::kMax; ++i) {
    EXPECT_TRUE(variables.Set("V" + std::to_string(i), 1.0, 0));
  }
  EXPECT_FALSE(variables.Set("ONE_MORE", 1.0, 0));
  EXPECT_TRUE(variables.Set("V0", 2.0, 1));
}

TEST(Variables, KeepEverySettingUntilTheEndOfAnIteration) {
  Variables variables;
  variables.Set("A", 1.0, 0);
  variables.Set("A", 2.0, 0);
  EXPECT_EQ(variables.Find("A")->fresh.size(), 2U);
  variables.ForgetFresh();
  EXPECT_TRUE(variables.Find("A")->fresh.empty());
  EXPECT_EQ(variables.Find("A")->num_set, 2);
  EXPECT_EQ(variables.Find("A")->value, VariableValue(2.0));
}

TEST(Variables, KeepTheLastHundredSettingsWhileNothingReadsThem) {
  Variables variables;
  for (int i = 0; i < 250; ++i) variables.Set("A", static_cast<double>(i), 0);
  EXPECT_EQ(variables.Find("A")->fresh.size(), Variables::kMaxFresh);
  EXPECT_EQ(variables.Find("A")->fresh.front(), VariableValue(150.0));
  EXPECT_EQ(variables.Find("A")->fresh.back(), VariableValue(249.0));
}

TEST(Variables, StateWhyASettingIsRefused) {
  Variables variables;
  variables.Set("A", 1.0, 0);
  EXPECT_EQ(variables.WhyNot("A", std::string("x")), "the variable is a number");
  EXPECT_EQ(variables.WhyNot("A", 2.0), "");
  EXPECT_EQ(variables.WhyNot("B", std::numeric_limits<double>::infinity()),
            "the number is not finite");
}

TEST(ValueText, IsANumberOnlyAsAWhole) {
  EXPECT_EQ(NumberIn(" -2.5 "), -2.5);
  EXPECT_EQ(NumberIn("+1e3"), 1000);
  EXPECT_EQ(NumberIn("2 m"), std::nullopt);
  EXPECT_EQ(NumberIn(""), std::nullopt);
  EXPECT_EQ(NumberIn("nan"), std::nullopt);
  EXPECT_EQ(NumberIn("inf"), std::nullopt);
  EXPECT_EQ(ValueIn("\"2\""), VariableValue(std::string("2")));
  EXPECT_EQ(TextOf(ValueIn("0.1")), "0.1");
  EXPECT_EQ(TextOf(ValueIn("true")), "true");
}

}  // namespace shoal::variables_test
