// Each rule on COMMS_RULES, in --example, and in the tables of the docs.
#include "lib/run/broker/broker_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "lib/bus/bus/bus.h"
#include "lib/comms/routing/control.h"
#include "lib/mission/file/load_comms.h"
#include "lib/run/broker/comms_example.h"
#include "shoal/comms_rules_t.hpp"

namespace shoal::broker_rules_test {

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

/// Returns the rules of these, after `change` of their message.
template <class Change>
BrokerRules AfterChange(const BrokerRules& rules, Change change) {
  broker_rules_t message = ToMessage(rules);
  change(&message.rules);
  message.num_rules = static_cast<int32_t>(message.rules.size());
  Bytes bytes;
  EncodeInto(message, &bytes);
  return ReadBrokerRules(bytes).value();
}

broker_rule_t& RuleIn(std::vector<broker_rule_t>* rules, std::string_view key) {
  return *std::ranges::find(*rules, key, &broker_rule_t::key);
}

TEST(CommsRules, CarryEachRuleAsItIs) {
  const BrokerRules sent{.utime = 3,
                         .is_start = true,
                         .seed = 1LL << 62,
                         .tick_us = 7,
                         .origin = {.lat_deg = 0.1, .lon_deg = -0.3},
                         .vehicles = {{.name = "alpha", .address = 5, .is_leader = true}},
                         .rules = OtherRules(),
                         .factors = {{"alpha", {.stealth = 0.1, .earange = 10.0 / 3}}},
                         .media = "[acoustics]"};
  const BrokerRules read = AfterChange(sent, [](auto*) {});
  EXPECT_EQ(read.utime, 3);
  EXPECT_TRUE(read.is_start);
  EXPECT_EQ(read.seed, 1LL << 62);
  EXPECT_EQ(read.tick_us, 7);
  EXPECT_EQ(read.origin.lat_deg, 0.1);
  EXPECT_EQ(read.origin.lon_deg, -0.3);
  ASSERT_EQ(read.vehicles.size(), 1U);
  EXPECT_EQ(read.vehicles[0].name, "alpha");
  EXPECT_EQ(read.vehicles[0].address, 5);
  EXPECT_TRUE(read.vehicles[0].is_leader);
  EXPECT_EQ(read.rules, OtherRules());
  EXPECT_EQ(read.factors, sent.factors);
  EXPECT_EQ(read.media, sent.media);
  EXPECT_TRUE(StrangeRules(read).empty() && read.wrong.empty());
  EXPECT_EQ(ImpossibleRule(read.rules, kBuiltIn), "");
}

TEST(CommsRules, KeepAndNameARuleThatThisBuildDoesNotKnow) {
  const BrokerRules read = AfterChange({}, [](std::vector<broker_rule_t>* rules) {
    rules->push_back(
        {.key = "max_depth", .vehicle = "", .kind = "number", .number = 30.5, .text = ""});
    rules->push_back({.key = "muted", .vehicle = "bravo", .kind = "flag", .number = 1, .text = ""});
  });
  ASSERT_EQ(read.unknown.size(), 2U);
  EXPECT_EQ(read.unknown[0].number, 30.5);
  EXPECT_EQ(read.rules, RoutingRules());
  EXPECT_EQ(StrangeRules(read),
            (std::vector<std::string>{
                "the log has the rule 'max_depth' (30.5), which this build does not know: "
                "decisions may differ",
                "the log has the rule 'muted' (true, of 'bravo'), which this build does not know: "
                "decisions may differ"}));
}

TEST(CommsRules, GiveARuleThatTheLogLacksItsDefaultAndNameIt) {
  BrokerRules sent{.rules = OtherRules()};
  sent.rules.stale_time_s = 3;
  const BrokerRules read = AfterChange(sent, [](std::vector<broker_rule_t>* rules) {
    std::erase_if(*rules, [](const broker_rule_t& rule) {
      return rule.key == "drop_percentage" || rule.key == "stale_forget_s";
    });
  });
  RoutingRules expected = sent.rules;
  expected.drop_percentage = 0;
  expected.stale_forget_s = 60;  // 20 x stale_time
  EXPECT_EQ(read.rules, expected);
  EXPECT_EQ(StrangeRules(read),
            (std::vector<std::string>{
                "the log does not have the rule 'stale_forget_s': it has its default, 60",
                "the log does not have the rule 'drop_percentage': it has its default, 0"}));
}

TEST(CommsRules, RefuseValuesThatAreNotOfTheRulesKind) {
  const auto wrong = [](auto change) { return AfterChange({}, change).wrong; };
  using Rules = std::vector<broker_rule_t>;
  using Texts = std::vector<std::string>;
  EXPECT_EQ(wrong([](Rules* rules) { RuleIn(rules, "groups").kind = "text"; }),
            Texts{"groups is a text, not a flag"});
  EXPECT_EQ(wrong([](Rules* rules) { RuleIn(rules, "max_msg_length").number = 1e300; }),
            Texts{"max_msg_length = 1e+300 is not a whole number"});
  EXPECT_EQ(wrong([](Rules* rules) { RuleIn(rules, "comms_range").vehicle = "alpha"; }),
            Texts{"comms_range is of one vehicle"});
  EXPECT_EQ(wrong([](Rules* rules) { rules->push_back(rules->front()); }),
            Texts{"comms_range is given twice"});
}

TEST(CommsRules, RefuseTheFirstImpossibleValue) {
  RoutingRules rules;
  rules.stale_forget_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ImpossibleRule(rules, kBuiltIn), "stale_forget_s = nan");
  rules.drop_percentage = 101;
  rules.stale_forget_s = 1;
  EXPECT_EQ(ImpossibleRule(rules, kBuiltIn), "drop_percentage = 101");
  rules.drop_percentage = 0;
  rules.reports_over = Over("pigeon");
  EXPECT_EQ(ImpossibleRule(rules, kBuiltIn), "reports_over = 'pigeon'");
  rules.reports_over = Over("acoustic,direct");
  EXPECT_EQ(ImpossibleRule(rules, kBuiltIn), "");
}

TEST(CommsRules, AreReadFromTheTypeOfOlderLogs) {
  comms_rules_t old{};
  old.seed = 7;
  old.num_vehicles = 1;
  old.vehicles = {"alpha"};
  old.acoustic_addresses = {4};
  old.acoustic_leaders = {1};
  old.comms_range_m = 0.1;
  old.groups = 1;
  old.max_msg_length_bytes = 500;
  old.reports_over = "radio,acoustic";
  old.num_factors = 1;
  old.factors = {{.vehicle = "alpha", .stealth = 0.3, .earange = 2}};
  Bytes bytes;
  EncodeInto(old, &bytes);
  const auto read = ReadBrokerRules(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->seed, 7);
  ASSERT_EQ(read->vehicles.size(), 1U);
  EXPECT_EQ(read->vehicles[0].address, 4);
  EXPECT_TRUE(read->vehicles[0].is_leader);
  EXPECT_EQ(read->rules.comms_range_m, 0.1);
  EXPECT_TRUE(read->rules.groups);
  EXPECT_EQ(read->rules.max_msg_length_bytes, 500);
  EXPECT_EQ(read->rules.reports_over, Over("radio,acoustic"));
  ASSERT_EQ(read->factors.size(), 1U);
  EXPECT_EQ(read->factors[0].second, (LinkFactors{.stealth = 0.3, .earange = 2}));
  EXPECT_TRUE(read->unknown.empty() && read->wrong.empty());
  EXPECT_FALSE(ReadBrokerRules(Bytes(20, 0)));
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
  const std::string page =
      PageText("docs/missions/networks.md") + PageText("docs/missions/vehicle.md");
  for (const RuleRow& row : kRuleTable) {
    if (row.type == RuleType::kRequest) continue;
    const std::string line = LineOf(page, row.rule);
    EXPECT_NE(line, "")
        << "neither docs/missions/networks.md nor docs/missions/vehicle.md has a row of "
        << row.rule;
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
  const std::string page = PageText("docs/communication/shore_broker.md");
  for (const ControlRow& row : ControlTable()) {
    const std::string line = LineOf(page, row.rule);
    EXPECT_NE(line.find("`" + std::string(row.channel) + "`"), line.npos)
        << "docs/communication/shore_broker.md has no row of " << row.rule << " with "
        << row.channel;
  }
}

}  // namespace shoal::broker_rules_test
