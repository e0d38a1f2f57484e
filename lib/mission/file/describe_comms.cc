// The table [comms].
#include <algorithm>
#include <string>
#include <variant>

#include "lib/comms/routing/control.h"
#include "lib/mission/file/describe.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

void DescribeControlValue(Fields& fields, std::string_view key, const ControlRow& row,
                          ControlValue& value) {
  std::string word = ControlWord(row, value);
  fields.Scalar(key, word);
  if (!fields.reading() || !fields.Has(key, true)) return;
  if (const std::optional<ControlValue> parsed = ParseControlValue(row, word)) {
    value = *parsed;
  } else {
    fields.Refuse(key, std::string(key) + " = " + Quoted(word) + " is impossible; " +
                           std::string(row.rule) + " takes " + std::string(row.values));
  }
}

namespace {

/// Describes one key of [comms] by its row.
struct RuleField {
  Fields& fields;
  const RuleRow& row;
  RoutingRules& rules;

  void operator()(double RoutingRules::*member) const {
    double& value = rules.*member;
    if (row.default_of != nullptr && fields.reading()) {
      const double of = rules.*row.default_of;
      value = of < 0 ? -1 : std::min(row.default_factor * of, row.in_file.max);
    }
    if (row.true_value) {
      ControlValue of_row = value;
      DescribeControlValue(fields, row.rule, row, of_row);
      value = of_row.number;
    } else if (!row.word.empty()) {
      fields.NumberOrWord(row.rule, value, row.in_file.max, row.word, -1);
    } else {
      fields.Number(row.rule, value, Between(row.in_file.min, row.in_file.max));
    }
  }
  void operator()(int64_t RoutingRules::*member) const {
    fields.Integer(row.rule, rules.*member, static_cast<int64_t>(row.in_file.min),
                   static_cast<int64_t>(row.in_file.max));
  }
  void operator()(bool RoutingRules::*member) const { fields.Flag(row.rule, rules.*member); }
  void operator()(std::string RoutingRules::*member) const {
    fields.Text(row.rule, rules.*member,
                {.min_length = static_cast<size_t>(row.in_file.min),
                 .max_length = static_cast<size_t>(row.in_file.max)});
  }
  void operator()(MediaChoice RoutingRules::*member) const {
    DescribeMedia(fields, row.rule, rules.*member);
  }
  // Of a vehicle, and requests: not of [comms].
  void operator()(double LinkFactors::*) const {}
  void operator()(std::monostate) const {}
};

}  // namespace

void Describe(Fields& fields, RoutingRules& rules) {
  for (const RuleRow& row : kRuleTable) {
    if (!row.of_vehicle || row.type == RuleType::kRequest) continue;
    fields.NoKey(row.rule, "each vehicle has its own: write " + std::string(row.rule) + " = " +
                               std::string(row.example) + " in its [[vehicle]]");
  }
  fields.CalledElsewhere("min_rpt_interval", "min_report_interval");
  for (const char* name : {"verbose", "debug"}) {
    fields.NoKey(name,
                 "without meaning here: `shoal status shore_broker` shows what the broker does");
  }
  for (const RuleRow& row : kRuleTable) std::visit(RuleField{fields, row, rules}, row.member);
}

}  // namespace shoal
