#include "lib/routing/control.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "lib/check/check.h"

namespace shoal {

namespace {

constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kLargestLength = 1e9;

using enum ControlType;

constexpr std::array kTable = {
    ControlRow{.rule = "comms_range",
               .channel = "UNC_COMMS_RANGE",
               .min = -kLargest,
               .max = kLargest,
               .values = "metres, or nolimit",
               .example = "250",
               .member = &RoutingRules::comms_range_m},
    ControlRow{.rule = "critical_range",
               .channel = "UNC_CRITICAL_RANGE",
               .max = kLargest,
               .values = "metres",
               .example = "30",
               .member = &RoutingRules::critical_range_m},
    ControlRow{.rule = "stealth",
               .channel = "UNC_STEALTH",
               .of_vehicle = true,
               .max = 1,
               .values = "0 to 1",
               .example = "0.5",
               .member = &LinkFactors::stealth},
    ControlRow{.rule = "earange",
               .channel = "UNC_EARANGE",
               .of_vehicle = true,
               .min = 1,
               .max = 10,
               .values = "1 to 10",
               .example = "2",
               .member = &LinkFactors::earange},
    ControlRow{.rule = "stale_time",
               .channel = "UNC_STALE_TIME",
               .min = -kLargest,
               .max = kLargest,
               .values = "seconds, or nolimit: never stale",
               .example = "5",
               .member = &RoutingRules::stale_time_s},
    ControlRow{.rule = "groups",
               .channel = "UNC_GROUPS",
               .type = kYesNo,
               .max = 1,
               .values = "true or false",
               .example = "true",
               .member = &RoutingRules::groups},
    ControlRow{.rule = "msg_groups",
               .channel = "UNC_MSG_GROUPS",
               .type = kYesNo,
               .max = 1,
               .values = "true or false",
               .example = "true",
               .member = &RoutingRules::msg_groups},
    ControlRow{.rule = "min_rpt_interval",
               .channel = "UNC_MIN_RPT_INTERVAL",
               .min = -kLargest,
               .max = kLargest,
               .values = "seconds; -1: off",
               .example = "10",
               .member = &RoutingRules::min_rpt_interval_s},
    ControlRow{.rule = "min_msg_interval",
               .channel = "UNC_MIN_MSG_INTERVAL",
               .min = -kLargest,
               .max = kLargest,
               .values = "seconds; -1: off",
               .example = "30",
               .member = &RoutingRules::min_msg_interval_s},
    ControlRow{.rule = "max_msg_length",
               .channel = "UNC_MAX_MSG_LENGTH",
               .type = kWhole,
               .max = kLargestLength,
               .values = "bytes; 0: no limit",
               .example = "1000",
               .member = &RoutingRules::max_msg_length_bytes},
    ControlRow{.rule = "drop_percentage",
               .channel = "UNC_DROP_PCT",
               .max = 100,
               .values = "0 to 100",
               .example = "10",
               .member = &RoutingRules::drop_percentage},
    ControlRow{.rule = "view_node_rpt_pulses",
               .channel = "UNC_VIEW_NODE_RPT_PULSES",
               .type = kYesNo,
               .max = 1,
               .values = "true or false",
               .example = "false",
               .member = &RoutingRules::view_node_rpt_pulses},
    ControlRow{.rule = "pulse_duration",
               .channel = "UNC_PULSE_DURATION",
               .max = kLargest,
               .values = "seconds; 0: no pulses",
               .example = "10",
               .member = &RoutingRules::pulse_duration_s},
    ControlRow{.rule = "shared_node_reports",
               .channel = "UNC_SHARED_NODE_REPORTS",
               .min = -kLargest,
               .max = kLargest,
               .values = "true, false, or seconds of wall time between two of a vehicle",
               .example = "true",
               .member = &RoutingRules::shared_node_reports_s},
    ControlRow{.rule = "full_report",
               .channel = "UNC_FULL_REPORT_REQ",
               .type = kRequest,
               .of_vehicle = true,
               .values = "no value",
               .example = "",
               .member = std::monostate()},
};

std::optional<double> ParseNumber(std::string_view word) {
  double value = 0;
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

}  // namespace

std::span<const ControlRow> ControlTable() { return kTable; }

const ControlRow* FindControl(std::string_view rule) {
  const auto found = std::find_if(kTable.begin(), kTable.end(),
                                  [&](const ControlRow& row) { return row.rule == rule; });
  return found == kTable.end() ? nullptr : &*found;
}

const ControlRow* FindControlOnChannel(std::string_view channel) {
  const auto found = std::find_if(kTable.begin(), kTable.end(),
                                  [&](const ControlRow& row) { return row.channel == channel; });
  return found == kTable.end() ? nullptr : &*found;
}

bool IsPossible(const ControlRow& row, double value) {
  if (row.type == kRequest) return true;
  if (!(value >= row.min && value <= row.max)) return false;
  return row.type == kNumber || value == std::floor(value);
}

std::optional<double> ParseControlValue(const ControlRow& row, std::string_view word) {
  std::optional<double> value = ParseNumber(word);
  const bool is_shared = row.rule == "shared_node_reports";
  if (row.type == kYesNo || is_shared) {
    if (word == "true") value = is_shared ? kSharedReportsInterval_s : 1;
    if (word == "false") value = is_shared ? -1 : 0;
  }
  if (word == "nolimit" && (row.rule == "comms_range" || row.rule == "stale_time")) value = -1;
  if (!value || !IsPossible(row, *value)) return std::nullopt;
  return value;
}

std::string ControlWord(const ControlRow& row, double value) {
  if (row.type == kYesNo) return value != 0 ? "true" : "false";
  if ((row.rule == "comms_range" || row.rule == "stale_time") && value < 0) return "nolimit";
  if (row.rule == "shared_node_reports" && value < 0) return "false";
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  SHOAL_CHECK(error == std::errc(), "every number has at most 24 characters");
  return {digits.data(), end};
}

double GetRule(const ControlRow& row, const RoutingRules& rules) {
  if (const auto* number = std::get_if<double RoutingRules::*>(&row.member)) {
    return rules.**number;
  }
  if (const auto* flag = std::get_if<bool RoutingRules::*>(&row.member)) {
    return rules.**flag ? 1 : 0;
  }
  const auto* whole = std::get_if<int64_t RoutingRules::*>(&row.member);
  SHOAL_CHECK(whole != nullptr, "the row is of a rule for all");
  return static_cast<double>(rules.**whole);
}

void SetRule(const ControlRow& row, double value, RoutingRules* rules) {
  if (const auto* number = std::get_if<double RoutingRules::*>(&row.member)) {
    rules->** number = value;
  } else if (const auto* flag = std::get_if<bool RoutingRules::*>(&row.member)) {
    rules->** flag = value != 0;
  } else {
    const auto* whole = std::get_if<int64_t RoutingRules::*>(&row.member);
    SHOAL_CHECK(whole != nullptr, "the row is of a rule for all");
    rules->** whole = static_cast<int64_t>(value);
  }
}

double GetFactor(const ControlRow& row, const LinkFactors& factors) {
  const auto* member = std::get_if<double LinkFactors::*>(&row.member);
  SHOAL_CHECK(member != nullptr, "the row is of one vehicle's factor");
  return factors.**member;
}

void SetFactor(const ControlRow& row, double value, LinkFactors* factors) {
  const auto* member = std::get_if<double LinkFactors::*>(&row.member);
  SHOAL_CHECK(member != nullptr, "the row is of one vehicle's factor");
  factors->** member = value;
}

}  // namespace shoal
