#include "lib/helm/modes/condition.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace shoal::condition_test {

Variables SomeVariables() {
  Variables variables;
  variables.Set("DEPLOY", std::string("true"), 0);
  variables.Set("DEPTH", 20.0, 0);
  variables.Set("LIMIT", 20.0, 0);
  variables.Set("TEXT_NUMBER", std::string("20"), 0);
  variables.Set("PLACE", std::string("harbour"), 0);
  variables.Set("MODE", std::string("ACTIVE:SURVEYING:LEG"), 0);
  return variables;
}

bool Holds(const std::string& text) {
  const auto condition = Condition::Parse(text);
  EXPECT_TRUE(condition.ok()) << condition.error();
  return condition.ok() && condition->Holds(SomeVariables());
}

std::string ErrorOf(const std::string& text) {
  const auto condition = Condition::Parse(text);
  EXPECT_FALSE(condition.ok()) << text;
  return condition.ok() ? "" : condition.error();
}

TEST(Condition, ComparesTextExactly) {
  EXPECT_TRUE(Holds("DEPLOY = true"));
  EXPECT_FALSE(Holds("DEPLOY = TRUE"));
  EXPECT_TRUE(Holds("DEPLOY != false"));
  EXPECT_TRUE(Holds("DEPLOY=\"true\""));
  EXPECT_TRUE(Holds("DEPLOY, true"));
}

TEST(Condition, ComparesTextByTheAlphabet) {
  EXPECT_TRUE(Holds("PLACE < island"));
  EXPECT_TRUE(Holds("PLACE > beach"));
  EXPECT_TRUE(Holds("PLACE <= harbour"));
  EXPECT_FALSE(Holds("PLACE < harbour"));
}

TEST(Condition, ComparesNumbers) {
  EXPECT_TRUE(Holds("DEPTH = 20.0"));
  EXPECT_TRUE(Holds("DEPTH >= 20"));
  EXPECT_TRUE(Holds("DEPTH <= 2e1"));
  EXPECT_FALSE(Holds("DEPTH > 20"));
  EXPECT_FALSE(Holds("DEPTH < 20"));
  EXPECT_TRUE(Holds("DEPTH > -1"));
  EXPECT_FALSE(Holds("DEPTH != 20"));
}

TEST(Condition, TakesTextThatIsANumberAsOne) {
  EXPECT_TRUE(Holds("TEXT_NUMBER = 20.0"));
  EXPECT_TRUE(Holds("TEXT_NUMBER < 100"));
  EXPECT_TRUE(Holds("DEPTH = \"20\""));
}

TEST(Condition, IsFalseForOtherTextAgainstANumberWhateverTheRelation) {
  for (const char* relation : {"=", "==", "!=", "<", ">", "<=", ">="}) {
    EXPECT_FALSE(Holds(std::string("PLACE ") + relation + " 3")) << relation;
    EXPECT_FALSE(Holds(std::string("DEPTH ") + relation + " deep")) << relation;
  }
}

TEST(Condition, IsFalseForAnUnknownVariableWhateverTheRelation) {
  for (const char* relation : {"=", "==", "!=", "<", ">", "<=", ">="}) {
    EXPECT_FALSE(Holds(std::string("X ") + relation + " 2")) << relation;
    EXPECT_FALSE(Holds(std::string("DEPTH ") + relation + " $(X)")) << relation;
  }
  EXPECT_TRUE(Holds("!(X = 2)"));
  EXPECT_TRUE(Holds("!(X != 2)"));
}

TEST(Condition, ComparesOnePartBetweenColonsByTwoEqualSigns) {
  EXPECT_TRUE(Holds("MODE == ACTIVE"));
  EXPECT_TRUE(Holds("MODE == SURVEYING"));
  EXPECT_TRUE(Holds("MODE == LEG"));
  EXPECT_FALSE(Holds("MODE == SURVEY"));
  EXPECT_FALSE(Holds("MODE == ACTIVE:SURVEYING"));
  EXPECT_FALSE(Holds("MODE = ACTIVE"));
  EXPECT_TRUE(Holds("MODE = ACTIVE:SURVEYING:LEG"));
  EXPECT_TRUE(Holds("DEPTH == 20"));
}

TEST(Condition, ComparesTwoVariables) {
  EXPECT_TRUE(Holds("DEPTH = $(LIMIT)"));
  EXPECT_TRUE(Holds("(DEPTH >= $(LIMIT)) and (DEPLOY = true)"));
  EXPECT_FALSE(Holds("DEPTH < $( LIMIT )"));
}

TEST(Condition, JoinsPartsInParentheses) {
  EXPECT_TRUE(Holds("(DEPLOY = true) and (DEPTH = 20)"));
  EXPECT_FALSE(Holds("(DEPLOY = true) AND (DEPTH = 21)"));
  EXPECT_TRUE(Holds("(DEPLOY = false) or (DEPTH = 20)"));
  EXPECT_FALSE(Holds("(DEPLOY = false) Or (DEPTH = 21)"));
  EXPECT_TRUE(Holds("(DEPLOY = true) and (!(DEPTH > 20))"));
  EXPECT_TRUE(Holds("(DEPLOY = true) and !(DEPTH > 20)"));
  EXPECT_TRUE(Holds("((DEPLOY = false) and (DEPTH = 1)) or (PLACE = harbour)"));
  EXPECT_FALSE(Holds("(DEPLOY = false) and ((DEPTH = 1) or (PLACE = harbour))"));
  EXPECT_TRUE(Holds("!(!(DEPLOY = true))"));
  EXPECT_TRUE(Holds("((DEPLOY = true))"));
}

TEST(Condition, JoinsMoreThanTwoPartsByTheSameWord) {
  EXPECT_TRUE(Holds("(DEPLOY = true) and (DEPTH = 20) and (PLACE = harbour)"));
  EXPECT_FALSE(Holds("(DEPLOY = true) and (DEPTH = 20) and (PLACE = beach)"));
  EXPECT_TRUE(Holds("(DEPLOY = false) or (DEPTH = 2) or (PLACE = harbour)"));
}

TEST(Condition, StatesWhatIsWrongAndHowToWriteIt) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "a comparison is missing"},
      {"DEPLOY", "'DEPLOY' compares nothing; write it like DEPLOY = true"},
      {"DEPLOY =", "the value behind DEPLOY is missing"},
      {"= true", "the name of a variable is missing"},
      {"A B = true", "'A B' is not a name of a variable"},
      {"not (A = 1)", "write !( ... )"},
      {"!A = 1", "needs parentheses: !(DEPLOY = true)"},
      {"A = 1 and B = 2", "put each comparison in parentheses"},
      {"(A = 1) and B = 2", "what is behind and needs parentheses"},
      {"(A = 1) and", "what is behind and needs parentheses"},
      {"(A = 1) and (B = 2) or (C = 3)", "add parentheses: ((A) and (B)) or (C)"},
      {"(A = 1", "a ')' is missing"},
      {"(A = 1) B", "there is 'B' behind a ')'"},
      {"(A = 1))", "there is ')' behind a ')'"},
      {"A = \"1", "the quotes of the value of A do not enclose it"},
      {"A = B = C", "put it in quotes"},
      {"A = $(B C)", "'B C' is not a name of a variable"},
      {std::string(60, '(') + "A = 1" + std::string(60, ')'), "nested too deeply"},
  };
  for (const auto& [text, expected] : cases) {
    const std::string error = ErrorOf(text);
    EXPECT_NE(error.find(expected), std::string::npos) << error;
    EXPECT_TRUE(error.starts_with("condition '" + text + "'")) << error;
  }
}

TEST(Condition, TakesWordsInsideOtherWordsAndInQuotesAsText) {
  EXPECT_FALSE(Holds("PLACE = sandbank"));
  EXPECT_FALSE(Holds("PLACE = \"search and rescue\""));
  EXPECT_FALSE(Holds("(PLACE = \"a ) or (b\") and (DEPLOY = true)"));
}

TEST(Condition, ListsTheVariablesAndValuesItLooksAt) {
  const auto condition = Condition::Parse("((A = 1) or (B == X)) and (!(A != $(C)))");
  ASSERT_TRUE(condition.ok());
  EXPECT_EQ(condition->VariablesUsed(), (std::vector<std::string>{"A", "B", "C"}));
  EXPECT_EQ(condition->ValuesCompared(),
            (std::multimap<std::string, std::string>{{"A", "1"}, {"B", "X"}}));
}

TEST(Condition, LooksAtTheOverlayFirst) {
  const auto condition = Condition::Parse("DEPLOY = false");
  EXPECT_TRUE(condition->Holds(SomeVariables(), {{"DEPLOY", "false"}}));
  EXPECT_FALSE(condition->Holds(SomeVariables(), {{"DEPTH", "false"}}));
}

TEST(Conditions, HoldTogether) {
  const auto both = ParseConditions({"DEPLOY = true", "DEPTH > 10"});
  const auto one = ParseConditions({"DEPLOY = true", "DEPTH > 30"});
  EXPECT_TRUE(AllHold(*both, SomeVariables()));
  EXPECT_FALSE(AllHold(*one, SomeVariables()));
  EXPECT_TRUE(AllHold({}, SomeVariables()));
  EXPECT_FALSE(ParseConditions({"DEPLOY = true", "DEPTH"}).ok());
}

}  // namespace shoal::condition_test
