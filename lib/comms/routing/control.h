// Rules that can be changed while a mission runs: what they are called in `shoal send` and in a
// mission's events, on which channel a message changes them, and which values are possible.
//
//   const ControlRow* row = FindControl("comms_range");
//   if (IsPossible(*row, value)) SetRule(*row, value, &rules);      // row->of_vehicle: SetFactor
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "lib/comms/routing/rules.h"

namespace shoal {

/// A row of kRuleTable that has a channel.
using ControlRow = RuleRow;
using ControlType = RuleType;

/// The value of a rule.
struct ControlValue {
  double number = 0;      ///< Of yes and no 1 and 0.
  std::string text = {};  ///< Where the row is of RuleType::kText; otherwise empty.

  ControlValue() = default;
  ControlValue(double of_number) : number(of_number) {}            // NOLINT: a number is a value
  ControlValue(std::string of_text) : text(std::move(of_text)) {}  // NOLINT: so is a text
  bool operator==(const ControlValue&) const = default;
};

/// All of them.
[[nodiscard]] std::span<const ControlRow> ControlTable();

/// Return the row of this name or channel, or nullptr.
[[nodiscard]] const ControlRow* FindControl(std::string_view rule);
[[nodiscard]] const ControlRow* FindControlOnChannel(std::string_view channel);

/// Returns true where the rule can have this value; of a request, always.
[[nodiscard]] bool IsPossible(const ControlRow& row, const ControlValue& value);

/// Returns the value that a word stands for: a number, true and false, nolimit, a text. Nothing
/// where it stands for none that is possible.
[[nodiscard]] std::optional<ControlValue> ParseControlValue(const ControlRow& row,
                                                            std::string_view word);

/// Returns the value as people write it: the inverse of ParseControlValue. @pre of the row's type
[[nodiscard]] std::string ControlWord(const ControlRow& row, const ControlValue& value);

/// Returns the value as the broker's page and the viewer show it: "250", "off", "true (0.1)".
[[nodiscard]] std::string ShownValue(const ControlRow& row, const RoutingRules& rules);

/// Return and set the value. @pre !row.of_vehicle, and it is a number, a yes or no, or a text;
/// IsPossible(row, value)
[[nodiscard]] ControlValue GetRule(const ControlRow& row, const RoutingRules& rules);
void SetRule(const ControlRow& row, const ControlValue& value, RoutingRules* rules);

/// The same for one vehicle. @pre row.of_vehicle, and it is not a request
[[nodiscard]] double GetFactor(const ControlRow& row, const LinkFactors& factors);
void SetFactor(const ControlRow& row, double value, LinkFactors* factors);

}  // namespace shoal
