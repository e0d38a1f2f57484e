#include "lib/helm/modes/mode_tree.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lib/helm/modes/value_text.h"

namespace shoal::mode_tree_test {

/// The tree of most missions with a loiter and a return.
std::vector<ModeOptions> UsualTree() {
  return {{"MODE = ACTIVE", {"DEPLOY = true"}, "INACTIVE"},
          {"MODE = STATION-KEEPING", {"MODE = ACTIVE", "STATION_KEEP = true"}},
          {"MODE = RETURNING", {"MODE = ACTIVE", "RETURN = true"}},
          {"MODE = LOITERING", {"MODE = ACTIVE", "LOITER = true"}, "TRANSITING"}};
}

std::string ModeWhere(const std::string& deploy, const std::string& keep, const std::string& back,
                      const std::string& loiter) {
  const auto tree = ModeTree::Parse(UsualTree());
  EXPECT_TRUE(tree.ok()) << tree.error();
  Variables variables;
  variables.Set("DEPLOY", deploy, 0);
  variables.Set("STATION_KEEP", keep, 0);
  variables.Set("RETURN", back, 0);
  variables.Set("LOITER", loiter, 0);
  tree->Apply(variables, 1);
  return TextOf(variables.Find("MODE")->value);
}

TEST(ModeTree, GivesOneLeafForEachSettingOfItsVariables) {
  const std::string yes = "true";
  const std::string no = "false";
  for (const std::string& loiter : {yes, no}) {
    for (const std::string& back : {yes, no}) {
      for (const std::string& keep : {yes, no}) {
        EXPECT_EQ(ModeWhere(no, keep, back, loiter), "INACTIVE");
        const std::string leaf = keep == yes     ? "STATION-KEEPING"
                                 : back == yes   ? "RETURNING"
                                 : loiter == yes ? "LOITERING"
                                                 : "TRANSITING";
        EXPECT_EQ(ModeWhere(yes, keep, back, loiter), "ACTIVE:" + leaf);
      }
    }
  }
}

TEST(ModeTree, SetsAVariableOnlyWhereItsValueChanges) {
  const auto tree = ModeTree::Parse(UsualTree());
  Variables variables;
  variables.Set("DEPLOY", std::string("true"), 0);
  EXPECT_EQ(tree->Apply(variables, 1), std::vector<std::string>{"MODE = ACTIVE:TRANSITING"});
  EXPECT_TRUE(tree->Apply(variables, 2).empty());
  EXPECT_EQ(variables.Find("MODE")->num_set, 1);
  variables.Set("RETURN", std::string("true"), 3);
  EXPECT_EQ(tree->Apply(variables, 3), std::vector<std::string>{"MODE = ACTIVE:RETURNING"});
}

TEST(ModeTree, KeepsWhatNothingSets) {
  const auto tree = ModeTree::Parse(std::vector<ModeOptions>{{"MODE = ON", {"DEPLOY = true"}}});
  Variables variables;
  tree->Apply(variables, 0);
  EXPECT_EQ(variables.Find("MODE"), nullptr);
  variables.Set("DEPLOY", std::string("true"), 1);
  tree->Apply(variables, 1);
  variables.Set("DEPLOY", std::string("false"), 2);
  EXPECT_TRUE(tree->Apply(variables, 2).empty());
  EXPECT_EQ(TextOf(variables.Find("MODE")->value), "ON");
}

TEST(ModeTree, GrowsBelowAGrandchild) {
  auto options = UsualTree();
  options.push_back({"MODE = CLOSE", {"MODE = ACTIVE:LOITERING", "RANGE < 20"}, "FAR"});
  const auto tree = ModeTree::Parse(options);
  Variables variables;
  variables.Set("DEPLOY", std::string("true"), 0);
  variables.Set("LOITER", std::string("true"), 0);
  variables.Set("RANGE", 30.0, 0);
  tree->Apply(variables, 0);
  EXPECT_EQ(TextOf(variables.Find("MODE")->value), "ACTIVE:LOITERING:FAR");
  variables.Set("RANGE", 10.0, 1);
  tree->Apply(variables, 1);
  EXPECT_EQ(TextOf(variables.Find("MODE")->value), "ACTIVE:LOITERING:CLOSE");
}

TEST(ModeTree, SetsSeveralVariables) {
  auto options = UsualTree();
  options.push_back({"LIGHTS = ON", {"MODE == ACTIVE"}, "OFF"});
  const auto tree = ModeTree::Parse(options);
  EXPECT_EQ(tree->variables(), (std::vector<std::string>{"MODE", "LIGHTS"}));
  Variables variables;
  variables.Set("DEPLOY", std::string("true"), 0);
  tree->Apply(variables, 0);
  EXPECT_EQ(TextOf(variables.Find("LIGHTS")->value), "ON");
}

TEST(ModeTree, StatesWhatIsWrongWithADeclaration) {
  const std::vector<std::pair<ModeOptions, std::string>> cases = {
      {{"ACTIVE", {}}, "write it as \"MODE = ACTIVE\""},
      {{"MY MODE = ACTIVE", {}}, "'MY MODE' is not a name of a variable"},
      {{"MODE = ", {}}, "the name of a mode is missing"},
      {{"MODE = ACTIVE:LOITERING", {}}, "parents come from conditions"},
      {{"MODE = ACTIVE", {}, "NOT ACTIVE"}, "'NOT ACTIVE' is not a name of a mode"},
      {{"MODE = ACTIVE", {"DEPLOY"}}, "'DEPLOY' compares nothing"},
  };
  for (const auto& [options, expected] : cases) {
    const auto tree = ModeTree::Parse(std::vector<ModeOptions>{options});
    ASSERT_FALSE(tree.ok()) << expected;
    EXPECT_NE(tree.error().find(expected), std::string::npos) << tree.error();
  }
}

}  // namespace shoal::mode_tree_test
