// The broker's rules as data, under the names of the node-comms manual.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "lib/routing/fate.h"

namespace shoal {

/// What carries a kind of traffic from its source to those whom the rules let hear it.
enum class Medium : uint8_t {
  kDirect,    ///< Nothing: it arrives at once and whole.
  kAcoustic,  ///< The acoustic network: late, damaged or not at all.
};

inline constexpr std::array<std::pair<std::string_view, Medium>, 2> kMedia = {{
    {"direct", Medium::kDirect},
    {"acoustic", Medium::kAcoustic},
}};

struct RoutingRules {
  // Who hears whom.
  double comms_range_m = 100;      ///< `comms_range`; negative: no limit, 0: nothing passes.
  double critical_range_m = 30;    ///< `critical_range`; closer than this, reports get through.
  double stale_time_s = 5;         ///< `stale_time`; negative: never stale.
  double stale_forget_s = 100;     ///< `stale_forget_s`; default 20 x stale_time; negative: never.
  bool groups = false;             ///< Reports only within a group.
  bool msg_groups = false;         ///< Messages only within a group.
  std::string ignore_group = {};   ///< Reports of this group are ignored; empty: of none.
  double min_rpt_interval_s = -1;  ///< `min_rpt_interval`, per ordered pair; negative: none.
  double min_msg_interval_s = 30;  ///< `min_msg_interval`, per source; negative: none.
  int64_t max_msg_length_bytes = 1000;  ///< `max_msg_length`, of string_val; 0: no limit.
  double drop_percentage = 0;           ///< 0 to 100: so many deliveries are lost at random.
  Medium reports_over = Medium::kDirect;
  Medium messages_over = Medium::kDirect;  ///< Acks too.

  // What is shown of it.
  double shared_node_reports_s = -1;  ///< `shared_node_reports`: wall seconds; negative: off.
  double pulse_duration_s = 10;       ///< `pulse_duration`; 0: no pulses.
  bool view_node_rpt_pulses = true;   ///< Pulses of reports too, not only of messages.
  std::string msg_color = "white";
  std::string msg_repeat_color = "light_green";
  int64_t each_fate_up_to = 200;  ///< With more known vehicles, far ones are counted together.

  bool operator==(const RoutingRules&) const = default;
};

/// Returns what carries transmissions of this kind.
[[nodiscard]] inline Medium MediumOf(const RoutingRules& rules, Kind kind) {
  switch (kind) {
    case Kind::kReport:
      return rules.reports_over;
    case Kind::kMessage:
    case Kind::kAck:
      return rules.messages_over;
    case Kind::kPacket:
      break;
  }
  return Medium::kAcoustic;
}

/// What one vehicle is given or takes: section 3 of the manual.
struct LinkFactors {
  double stealth = 1;  ///< [0, 1]: as a source, it is heard within comms_range x stealth.
  double earange = 1;  ///< [1, 10]: as a receiver, it hears within comms_range x earange.

  bool operator==(const LinkFactors&) const = default;
};

/// `shared_node_reports = true` stands for this.
inline constexpr double kSharedReportsInterval_s = 0.1;

}  // namespace shoal
