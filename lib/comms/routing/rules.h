// The broker's rules: their values, and one row for each. The mission file's [comms], COMMS_RULES,
// the broker's page, `shoal send`, events, the viewer and the tables of the docs draw on the rows.
// A new rule: one member, one row, and the places that CONTRIBUTING.md names.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lib/comms/routing/kind.h"

namespace shoal {

/// Two media that every mission has by these names: nothing (it arrives at once and whole), and the
/// acoustic network of [acoustics] (late, damaged or not at all). [[medium]] adds others.
inline constexpr std::string_view kDirectMedium = "direct";
inline constexpr std::string_view kAcousticMedium = "acoustic";

/// What carries a kind of traffic from its source to the receivers that the rules let pass.
struct MediaChoice {
  std::vector<std::string> names = {std::string(kDirectMedium)};  ///< In order of preference.
  bool at_once = false;  ///< Over all of them that can work; false: over the first that can.

  bool operator==(const MediaChoice&) const = default;

  bool Has(std::string_view medium) const {
    return std::find(names.begin(), names.end(), medium) != names.end();
  }
  /// True where no medium decides anything.
  bool is_direct() const { return names.size() == 1 && names.front() == kDirectMedium; }
};

/// Returns the choice that a text stands for: "radio", "radio,acoustic": the first of them that can
/// work, or "radio+acoustic": all that can.
[[nodiscard]] MediaChoice Over(std::string_view text);
/// The inverse.
[[nodiscard]] std::string TextOf(const MediaChoice& choice);

struct RoutingRules {
  // Which vehicle receives what.
  double comms_range_m = 100;           ///< Negative: no limit, 0: nothing passes.
  double critical_range_m = 30;         ///< Closer than this, reports get through.
  double stale_time_s = 5;              ///< Negative: never stale.
  double stale_forget_s = 100;          ///< Default 20 x stale_time; negative: never.
  bool groups = false;                  ///< Reports only within a group.
  bool msg_groups = false;              ///< Messages only within a group.
  std::string ignore_group = {};        ///< Reports of this group are ignored; empty: of none.
  double min_rpt_interval_s = -1;       ///< Per ordered pair; negative: none.
  double min_msg_interval_s = 30;       ///< Per source; negative: none.
  int64_t max_msg_length_bytes = 1000;  ///< Of string_val; 0: no limit.
  double drop_percentage = 0;           ///< 0 to 100: this share of deliveries is lost at random.
  MediaChoice reports_over = {};
  MediaChoice messages_over = {};  ///< Acks too.

  // What is shown of it.
  double shared_node_reports_s = -1;  ///< Wall seconds; negative: off.
  double pulse_duration_s = 10;       ///< 0: no pulses.
  bool view_node_rpt_pulses = true;   ///< Pulses of reports too, not only of messages.
  std::string msg_color = "white";
  std::string msg_repeat_color = "light_green";
  int64_t each_fate_up_to = 200;  ///< With more known vehicles, far ones are counted together.

  bool operator==(const RoutingRules&) const = default;
};

/// Returns true where what the rules have let pass goes over a medium that decides further.
[[nodiscard]] inline bool GoesOverMedia(const RoutingRules& rules, Kind kind) {
  switch (kind) {
    case Kind::kReport:
      return !rules.reports_over.is_direct();
    case Kind::kMessage:
    case Kind::kAck:
      return !rules.messages_over.is_direct();
    case Kind::kPacket:
      break;
  }
  return true;
}

/// The factors of one vehicle: section 3 of the manual.
struct LinkFactors {
  double stealth = 1;  ///< [0, 1]: as a source, it is received within comms_range x stealth.
  double earange = 1;  ///< [1, 10]: as a receiver, it receives within comms_range x earange.

  bool operator==(const LinkFactors&) const = default;
};

/// `shared_node_reports = true` stands for this.
inline constexpr double kSharedReportsInterval_s = 0.1;

enum class RuleType : uint8_t {
  kNumber,
  kWhole,  ///< A number without fraction.
  kYesNo,  ///< 1 or 0; people write true or false.
  kText,
  kMedia,    ///< A MediaChoice; mission file only.
  kRequest,  ///< Takes no value; while the mission runs only.
};

/// Where a rule's value is. std::monostate: it has none.
using RuleMember = std::variant<std::monostate, double RoutingRules::*, bool RoutingRules::*,
                                int64_t RoutingRules::*, std::string RoutingRules::*,
                                MediaChoice RoutingRules::*, double LinkFactors::*>;

/// Both ends are included.
struct RuleRange {
  double min = 0;
  double max = 0;
};

/// One rule. `of_vehicle`: each vehicle has its own value, which a mission file has in [[vehicle]];
/// all others are in [comms].
struct RuleRow {
  std::string_view rule;        ///< Its key: "comms_range".
  std::string_view label = {};  ///< On the broker's page and in the viewer: "Comms Range".
  std::string_view unit = {};   ///< "m"; empty: none.
  RuleType type = RuleType::kNumber;
  bool of_vehicle = false;  ///< Needs a vehicle; the others refuse one.
  RuleMember member = {};
  RuleRange in_file = {};         ///< Of a number in a mission file; of a text, its bytes.
  std::string_view channel = {};  ///< Changes it while the mission runs; empty: nothing does.
  double min = 0;                 ///< While the mission runs.
  double max = 0;                 ///< While the mission runs; of a text, its bytes.
  std::string_view values = {};   ///< "metres, or nolimit": for people.
  std::string_view example = {};  ///< A value, as people write it; empty where there is none.
  std::string_view word = {};  ///< Stands for every negative number, or the empty text: "nolimit".
  std::string_view negative = {};         ///< How the page shows negative numbers: "off".
  std::string_view zero = {};             ///< How the page shows 0; empty: as a number.
  std::optional<double> true_value = {};  ///< A number that `true` stands for; `false`: -1.
  /// Where a mission file leaves it out, it is this many times that other rule.
  double default_factor = 0;
  double RoutingRules::*default_of = nullptr;
  bool is_shown_always = false;  ///< On the page; false: only where it is not the default.
  std::string_view about = {};   ///< One line: what it does.
};

namespace rule_table {

inline constexpr double kAny = std::numeric_limits<double>::max();
inline constexpr double kLongest_s = 1e7;
inline constexpr double kFarthest_m = 1e7;
inline constexpr double kLongestText_bytes = 64;

using enum RuleType;

/// In the order of a mission file and of `shoal send`.
inline constexpr std::array kRows = {
    RuleRow{.rule = "comms_range",
            .label = "Comms Range",
            .unit = "m",
            .member = &RoutingRules::comms_range_m,
            .in_file = {0, kFarthest_m},
            .channel = "UNC_COMMS_RANGE",
            .min = -kAny,
            .max = kAny,
            .values = "metres, or nolimit",
            .example = "250",
            .word = "nolimit",
            .negative = "nolimit",
            .is_shown_always = true,
            .about = "what is sent is received nearer than this"},
    RuleRow{.rule = "critical_range",
            .label = "Critical Range",
            .unit = "m",
            .member = &RoutingRules::critical_range_m,
            .in_file = {0, kFarthest_m},
            .channel = "UNC_CRITICAL_RANGE",
            .max = kAny,
            .values = "metres",
            .example = "30",
            .is_shown_always = true,
            .about = "closer than this, reports get through anyway"},
    RuleRow{.rule = "stealth",
            .label = "Stealth",
            .of_vehicle = true,
            .member = &LinkFactors::stealth,
            .in_file = {0, 1},
            .channel = "UNC_STEALTH",
            .max = 1,
            .values = "0 to 1",
            .example = "0.5",
            .about = "as a source, it is received within comms_range x stealth"},
    RuleRow{.rule = "earange",
            .label = "Earange",
            .of_vehicle = true,
            .member = &LinkFactors::earange,
            .in_file = {1, 10},
            .channel = "UNC_EARANGE",
            .min = 1,
            .max = 10,
            .values = "1 to 10",
            .example = "2",
            .about = "as a receiver, it receives within comms_range x earange"},
    RuleRow{.rule = "stale_time",
            .label = "Stale Drop",
            .unit = "s",
            .member = &RoutingRules::stale_time_s,
            .in_file = {0, kLongest_s},
            .channel = "UNC_STALE_TIME",
            .min = -kAny,
            .max = kAny,
            .values = "seconds, or nolimit: never stale",
            .example = "5",
            .word = "nolimit",
            .negative = "never",
            .is_shown_always = true,
            .about = "a vehicle silent for longer receives nothing"},
    RuleRow{.rule = "stale_forget_s",
            .label = "Stale Forget",
            .unit = "s",
            .member = &RoutingRules::stale_forget_s,
            .in_file = {-1, kLongest_s},
            .negative = "never",
            .default_factor = 20,
            .default_of = &RoutingRules::stale_time_s,
            .is_shown_always = true,
            .about = "a vehicle silent for longer is forgotten; default 20 x stale_time"},
    RuleRow{.rule = "groups",
            .label = "Apply Group",
            .type = kYesNo,
            .member = &RoutingRules::groups,
            .channel = "UNC_GROUPS",
            .max = 1,
            .values = "true or false",
            .example = "true",
            .is_shown_always = true,
            .about = "true: reports only within a group"},
    RuleRow{.rule = "msg_groups",
            .label = "Apply Msg Group",
            .type = kYesNo,
            .member = &RoutingRules::msg_groups,
            .channel = "UNC_MSG_GROUPS",
            .max = 1,
            .values = "true or false",
            .example = "true",
            .is_shown_always = true,
            .about = "true: messages only within a group"},
    RuleRow{.rule = "ignore_group",
            .label = "Ignore Group",
            .type = kText,
            .member = &RoutingRules::ignore_group,
            .in_file = {0, kLongestText_bytes},
            .channel = "UNC_IGNORE_GROUP",
            .max = kLongestText_bytes,
            .values = "a group, or none",
            .example = "ghosts",
            .word = "none",
            .about = "reports of this group are ignored"},
    RuleRow{.rule = "min_rpt_interval",
            .label = "Min Report Int",
            .unit = "s",
            .member = &RoutingRules::min_rpt_interval_s,
            .in_file = {-1, kLongest_s},
            .channel = "UNC_MIN_RPT_INTERVAL",
            .min = -kAny,
            .max = kAny,
            .values = "seconds; -1: off",
            .example = "10",
            .negative = "off",
            .is_shown_always = true,
            .about = "between two reports from one vehicle to another; -1: off"},
    RuleRow{.rule = "min_msg_interval",
            .label = "Min Message Int",
            .unit = "s",
            .member = &RoutingRules::min_msg_interval_s,
            .in_file = {-1, kLongest_s},
            .channel = "UNC_MIN_MSG_INTERVAL",
            .min = -kAny,
            .max = kAny,
            .values = "seconds; -1: off",
            .example = "30",
            .negative = "off",
            .is_shown_always = true,
            .about = "between two messages of a vehicle; -1: off"},
    RuleRow{.rule = "max_msg_length",
            .label = "Max Message Len",
            .unit = "bytes",
            .type = kWhole,
            .member = &RoutingRules::max_msg_length_bytes,
            .in_file = {0, 1e9},
            .channel = "UNC_MAX_MSG_LENGTH",
            .max = 1e9,
            .values = "bytes; 0: no limit",
            .example = "1000",
            .zero = "nolimit",
            .is_shown_always = true,
            .about = "of a message's text; 0: no limit"},
    RuleRow{.rule = "drop_percentage",
            .label = "Drop Percentage",
            .unit = "%",
            .member = &RoutingRules::drop_percentage,
            .in_file = {0, 100},
            .channel = "UNC_DROP_PCT",
            .max = 100,
            .values = "0 to 100",
            .example = "10",
            .is_shown_always = true,
            .about = "0 to 100: lost at random"},
    RuleRow{.rule = "reports_over",
            .label = "Reports Over",
            .type = kMedia,
            .member = &RoutingRules::reports_over,
            .about = "a medium, or a list of media in order of preference"},
    RuleRow{.rule = "messages_over",
            .label = "Messages Over",
            .type = kMedia,
            .member = &RoutingRules::messages_over,
            .about = "the same of messages and acks"},
    RuleRow{.rule = "shared_node_reports",
            .label = "Share Reports",
            .unit = "s",
            .member = &RoutingRules::shared_node_reports_s,
            .in_file = {-kAny, kAny},
            .channel = "UNC_SHARED_NODE_REPORTS",
            .min = -kAny,
            .max = kAny,
            .values = "true, false, or seconds of wall time between two of a vehicle",
            .example = "true",
            .word = "false",
            .negative = "false",
            .true_value = kSharedReportsInterval_s,
            .is_shown_always = true,
            .about = "true, or seconds: repeat reports on NODE_REPORT_UNC"},
    RuleRow{.rule = "pulse_duration",
            .label = "Pulse Duration",
            .unit = "s",
            .member = &RoutingRules::pulse_duration_s,
            .in_file = {0, kLongest_s},
            .channel = "UNC_PULSE_DURATION",
            .max = kAny,
            .values = "seconds; 0: no pulses",
            .example = "10",
            .zero = "off",
            .about = "seconds that a pulse is shown; 0: no pulses"},
    RuleRow{.rule = "view_node_rpt_pulses",
            .label = "Report Pulses",
            .type = kYesNo,
            .member = &RoutingRules::view_node_rpt_pulses,
            .channel = "UNC_VIEW_NODE_RPT_PULSES",
            .max = 1,
            .values = "true or false",
            .example = "false",
            .about = "pulses of reports, not only of messages"},
    RuleRow{.rule = "msg_color",
            .label = "Message Color",
            .type = kText,
            .member = &RoutingRules::msg_color,
            .in_file = {1, kLongestText_bytes},
            .about = "of a message's pulse"},
    RuleRow{.rule = "msg_repeat_color",
            .label = "Message Repeat Color",
            .type = kText,
            .member = &RoutingRules::msg_repeat_color,
            .in_file = {1, kLongestText_bytes},
            .about = "of the pulse of a message that is sent again"},
    RuleRow{.rule = "each_fate_up_to",
            .label = "Each Fate Up To",
            .unit = "vehicles",
            .type = kWhole,
            .member = &RoutingRules::each_fate_up_to,
            .in_file = {0, 1'000'000},
            .about = "with more known vehicles, far ones are counted together"},
    RuleRow{.rule = "full_report",
            .label = "Full Report",
            .type = kRequest,
            .of_vehicle = true,
            .channel = "UNC_FULL_REPORT_REQ",
            .values = "no value",
            .example = "",
            .about = "it receives the next report of each other vehicle"},
};

/// True where the row lacks nothing that rules of its type need.
consteval bool IsComplete(const RuleRow& row) {
  if (row.rule.empty() || row.label.empty() || row.about.empty()) return false;
  const bool is_number = row.type == kNumber || row.type == kWhole;
  if ((is_number || row.type == kText) && row.in_file.min >= row.in_file.max) return false;
  if ((row.type == kRequest) == (row.member.index() != 0)) return false;
  // What can be negative has a text for it.
  if (row.in_file.min < 0 && row.negative.empty()) return false;
  if (!row.word.empty() && row.negative.empty() && row.type != kText) return false;
  if (row.channel.empty()) return row.type != kRequest && row.values.empty();
  if (!row.channel.starts_with("UNC_") || row.values.empty()) return false;
  return row.type == kRequest || (row.min < row.max && !row.example.empty());
}

consteval bool AreComplete() {
  for (const RuleRow& row : kRows) {
    if (!IsComplete(row)) return false;
  }
  return true;
}
static_assert(AreComplete(),
              "each rule has a label, a line about it, a member and ranges; one that can change "
              "while the mission runs has a UNC_ channel, words for its values and an example");

/// The rows of the rules that can change while the mission runs.
consteval size_t NumControls() {
  size_t count = 0;
  for (const RuleRow& row : kRows) count += row.channel.empty() ? 0 : 1;
  return count;
}
consteval std::array<RuleRow, NumControls()> Controls() {
  std::array<RuleRow, NumControls()> controls{};
  size_t place = 0;
  for (const RuleRow& row : kRows) {
    if (!row.channel.empty()) controls[place++] = row;
  }
  return controls;
}
inline constexpr std::array kControls = Controls();

}  // namespace rule_table

/// All rules.
inline constexpr const auto& kRuleTable = rule_table::kRows;

}  // namespace shoal
