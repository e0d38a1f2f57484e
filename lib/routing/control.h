// Rules that can be changed while a mission runs: what they are called in `shoal send` and in a
// mission's events, on which channel a message changes them, and which values are possible.
//
//   const ControlRow* row = FindControl("stealth");
//   if (IsPossible(*row, value)) SetRule(*row, value, &rules);      // row->of_vehicle: SetFactor
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lib/routing/rules.h"

namespace shoal {

/// A row of kRuleTable that has a channel.
using ControlRow = RuleRow;
using ControlType = RuleType;

/// All of them.
[[nodiscard]] std::span<const ControlRow> ControlTable();

/// Return the row of this name or channel, or nullptr.
[[nodiscard]] const ControlRow* FindControl(std::string_view rule);
[[nodiscard]] const ControlRow* FindControlOnChannel(std::string_view channel);

/// Returns true where the rule can have this value; of a request, always.
[[nodiscard]] bool IsPossible(const ControlRow& row, double value);

/// Returns the value that a word stands for: a number, true and false, nolimit. Nothing where it
/// stands for none that is possible.
[[nodiscard]] std::optional<double> ParseControlValue(const ControlRow& row, std::string_view word);

/// Returns the value as people write it: the inverse of ParseControlValue.
[[nodiscard]] std::string ControlWord(const ControlRow& row, double value);

/// Returns the value as the broker's page and the viewer show it: "250", "off", "true (0.1)".
[[nodiscard]] std::string ShownValue(const ControlRow& row, const RoutingRules& rules);

/// Return and set the value. @pre !row.of_vehicle, it is a number or a yes or no;
/// IsPossible(row, value)
[[nodiscard]] double GetRule(const ControlRow& row, const RoutingRules& rules);
void SetRule(const ControlRow& row, double value, RoutingRules* rules);

/// The same for one vehicle. @pre row.of_vehicle, and it is no request
[[nodiscard]] double GetFactor(const ControlRow& row, const LinkFactors& factors);
void SetFactor(const ControlRow& row, double value, LinkFactors* factors);

}  // namespace shoal
