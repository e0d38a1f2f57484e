#include "lib/comms/routing/control.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "lib/base/check/check.h"
#include "lib/base/text/numbers.h"

namespace shoal {

namespace {

using enum RuleType;
using rule_table::kControls;

bool IsControlCharacter(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

}  // namespace

std::span<const ControlRow> ControlTable() { return kControls; }

const ControlRow* FindControl(std::string_view rule) {
  const auto found = std::ranges::find(kControls, rule, &ControlRow::rule);
  return found == kControls.end() ? nullptr : &*found;
}

const ControlRow* FindControlOnChannel(std::string_view channel) {
  const auto found = std::ranges::find(kControls, channel, &ControlRow::channel);
  return found == kControls.end() ? nullptr : &*found;
}

bool IsPossible(const ControlRow& row, const ControlValue& value) {
  if (row.type == kRequest) return true;
  if (row.type == kText) {
    return static_cast<double>(value.text.size()) <= row.max &&
           std::ranges::none_of(value.text, IsControlCharacter);
  }
  if (!(value.number >= row.min && value.number <= row.max)) return false;
  return row.type == kNumber || value.number == std::floor(value.number);
}

std::optional<ControlValue> ParseControlValue(const ControlRow& row, std::string_view word) {
  std::optional<ControlValue> value = ReadNumber<double>(word);
  if (row.type == kYesNo && word == "true") value = 1;
  if (row.type == kYesNo && word == "false") value = 0;
  if (row.true_value && word == "true") value = *row.true_value;
  if (row.type == kText && !word.empty()) value = std::string(word);
  if (!row.word.empty() && word == row.word) {
    value = row.type == kText ? ControlValue() : ControlValue(-1);
  }
  if (!value || !IsPossible(row, *value)) return std::nullopt;
  return value;
}

std::string ControlWord(const ControlRow& row, const ControlValue& value) {
  if (row.type == kText) return value.text.empty() ? std::string(row.word) : value.text;
  if (row.type == kYesNo) return value.number != 0 ? "true" : "false";
  if (!row.word.empty() && value.number < 0) return std::string(row.word);
  return ShortestText(value.number);
}

std::string ShownValue(const ControlRow& row, const RoutingRules& rules) {
  if (const auto* text = std::get_if<std::string RoutingRules::*>(&row.member)) {
    const std::string& shown = rules.**text;
    return shown.empty() ? std::string(row.word) : shown;
  }
  if (const auto* media = std::get_if<MediaChoice RoutingRules::*>(&row.member)) {
    return TextOf(rules.**media);
  }
  const double value = GetRule(row, rules).number;
  if (row.type == kYesNo) return value != 0 ? "true" : "false";
  if (!row.negative.empty() && value < 0) return std::string(row.negative);
  if (!row.zero.empty() && value == 0) return std::string(row.zero);
  return row.true_value ? "true (" + ShortestText(value) + ")" : ShortestText(value);
}

ControlValue GetRule(const ControlRow& row, const RoutingRules& rules) {
  if (const auto* number = std::get_if<double RoutingRules::*>(&row.member)) {
    return rules.**number;
  }
  if (const auto* flag = std::get_if<bool RoutingRules::*>(&row.member)) {
    return rules.**flag ? 1 : 0;
  }
  if (const auto* text = std::get_if<std::string RoutingRules::*>(&row.member)) {
    return rules.**text;
  }
  const auto* whole = std::get_if<int64_t RoutingRules::*>(&row.member);
  SHOAL_CHECK(whole != nullptr, "the rule is not per vehicle and has a value");
  return static_cast<double>(rules.**whole);
}

void SetRule(const ControlRow& row, const ControlValue& value, RoutingRules* rules) {
  if (const auto* number = std::get_if<double RoutingRules::*>(&row.member)) {
    rules->** number = value.number;
  } else if (const auto* flag = std::get_if<bool RoutingRules::*>(&row.member)) {
    rules->** flag = value.number != 0;
  } else if (const auto* text = std::get_if<std::string RoutingRules::*>(&row.member)) {
    rules->** text = value.text;
  } else {
    const auto* whole = std::get_if<int64_t RoutingRules::*>(&row.member);
    SHOAL_CHECK(whole != nullptr, "the rule is not per vehicle and has a value");
    rules->** whole = static_cast<int64_t>(value.number);
  }
}

double GetFactor(const ControlRow& row, const LinkFactors& factors) {
  const auto* member = std::get_if<double LinkFactors::*>(&row.member);
  SHOAL_CHECK(member != nullptr, "the rule is a factor per vehicle");
  return factors.**member;
}

void SetFactor(const ControlRow& row, double value, LinkFactors* factors) {
  const auto* member = std::get_if<double LinkFactors::*>(&row.member);
  SHOAL_CHECK(member != nullptr, "the rule is a factor per vehicle");
  factors->** member = value;
}

}  // namespace shoal
