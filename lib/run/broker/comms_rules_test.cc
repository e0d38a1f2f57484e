// Each rule on COMMS_RULES, in --example, and in the tables of the docs.
#include "lib/run/broker/comms_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "lib/comms/routing/control.h"
#include "lib/mission/file/load_comms.h"
#include "lib/run/broker/comms_example.h"

namespace shoal::comms_rules_test {

const std::vector<std::string> kBuiltIn = {"direct", "acoustic"};

std::string PageText(const std::string& path) {
  std::ifstream in(std::string(SHOAL_SOURCE_DIR) + "/" + path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the row of a table of a page, from its line's begin to its end; empty: there is none.
std::string LineOf(const std::string& page, std::string_view rule) {
  const size_t begin = page.find("\n| `" + std::string(rule) + "` |");
  if (begin == page.npos) return {};
  return page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
}

/// Rules of which each differs from its default.
RoutingRules OtherRules() {
  RoutingRules rules;
  for (const RuleRow& row : kRuleTable) {
    std::visit(
        [&]<class Member>(Member member) {
          if constexpr (std::is_same_v<Member, std::string RoutingRules::*>) {
            rules.*member = "other";
          } else if constexpr (std::is_same_v<Member, MediaChoice RoutingRules::*>) {
            rules.*member = Over("acoustic");
          } else if constexpr (std::is_same_v<Member, bool RoutingRules::*>) {
            rules.*member = !(rules.*member);
          } else if constexpr (std::is_same_v<Member, double RoutingRules::*> ||
                               std::is_same_v<Member, int64_t RoutingRules::*>) {
            rules.*member += 7;
          }
        },
        row.member);
  }
  return rules;
}

TEST(CommsRules, CarryEachRuleAsItIs) {
  comms_rules_t message{};
  PutRules(OtherRules(), &message);
  EXPECT_EQ(RulesOf(message), OtherRules());
  EXPECT_EQ(ImpossibleRule(message, kBuiltIn), "");
}

TEST(CommsRules, RefuseTheFirstImpossibleValue) {
  comms_rules_t message{};
  PutRules({}, &message);
  message.stale_forget_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ImpossibleRule(message, kBuiltIn), "stale_forget_s = nan");
  message.drop_percentage = 101;
  message.stale_forget_s = 1;
  EXPECT_EQ(ImpossibleRule(message, kBuiltIn), "drop_percentage = 101");
  message.drop_percentage = 0;
  message.reports_over = "pigeon";
  EXPECT_EQ(ImpossibleRule(message, kBuiltIn), "reports_over = 'pigeon'");
  message.reports_over = "acoustic,direct";
  EXPECT_EQ(ImpossibleRule(message, kBuiltIn), "");
}

TEST(CommsExample, HasEachRuleWithItsDefaultAndLoads) {
  const std::string example = CommsExample();
  for (const RuleRow& row : kRuleTable) {
    const bool is_of_comms = !row.of_vehicle && row.type != RuleType::kRequest;
    EXPECT_EQ(example.find("\n" + std::string(row.rule) + " = ") != example.npos, is_of_comms)
        << row.rule;
    EXPECT_EQ(example.find(row.about) != example.npos, is_of_comms) << row.rule;
  }
  const LoadedComms loaded = LoadCommsText(example, "example");
  EXPECT_TRUE(loaded.errors.empty());
  EXPECT_EQ(loaded.rules, RoutingRules());
}

TEST(MissionFilePage, HasARowForEachRuleOfCommsAndVehicles) {
  const std::string page = PageText("docs/mission_file.md");
  for (const RuleRow& row : kRuleTable) {
    if (row.type == RuleType::kRequest) continue;
    const std::string line = LineOf(page, row.rule);
    EXPECT_NE(line, "") << "docs/mission_file.md has no row of " << row.rule;
    if (!row.word.empty() && row.type == RuleType::kNumber) {
      EXPECT_NE(line.find(row.word), line.npos) << row.rule << " takes " << row.word;
    }
    if (row.type == RuleType::kNumber && !row.true_value && !row.of_vehicle &&
        row.default_of == nullptr) {
      const std::string value = " | " + ControlWord({.rule = row.rule}, GetRule(row, {})) + " | ";
      EXPECT_NE(line.find(value), line.npos) << row.rule << " is " << value << "by default";
    }
  }
}

TEST(ShoreBrokerPage, HasARowForEachRuleThatCanChange) {
  const std::string page = PageText("docs/app_shore_broker.md");
  for (const ControlRow& row : ControlTable()) {
    const std::string line = LineOf(page, row.rule);
    EXPECT_NE(line.find("`" + std::string(row.channel) + "`"), line.npos)
        << "docs/app_shore_broker.md has no row of " << row.rule << " with " << row.channel;
  }
}

}  // namespace shoal::comms_rules_test
