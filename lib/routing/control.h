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
#include <variant>

#include "lib/routing/rules.h"

namespace shoal {

enum class ControlType {
  kNumber,
  kWhole,    ///< A number without fraction.
  kYesNo,    ///< 1 or 0; people write true or false.
  kRequest,  ///< Takes no value.
};

struct ControlRow {
  std::string_view rule;     ///< "comms_range"
  std::string_view channel;  ///< "UNC_COMMS_RANGE"
  ControlType type = ControlType::kNumber;
  bool of_vehicle = false;  ///< Needs a vehicle; the others refuse one.
  double min = 0;
  double max = 0;
  std::string_view values;   ///< "metres, or nolimit": for people.
  std::string_view example;  ///< A value, as people write it; empty where there is none.
  std::variant<std::monostate, double RoutingRules::*, bool RoutingRules::*,
               int64_t RoutingRules::*, double LinkFactors::*>
      member;
};

/// All of them, in the order in which people look for them.
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

/// Return and set the value. @pre !row.of_vehicle, and it is no request; IsPossible(row, value)
[[nodiscard]] double GetRule(const ControlRow& row, const RoutingRules& rules);
void SetRule(const ControlRow& row, double value, RoutingRules* rules);

/// The same for one vehicle. @pre row.of_vehicle, and it is no request
[[nodiscard]] double GetFactor(const ControlRow& row, const LinkFactors& factors);
void SetFactor(const ControlRow& row, double value, LinkFactors* factors);

}  // namespace shoal
