#include "lib/run/moos_text/node_report_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

using Member =
    std::variant<std::string node_report_t::*, double node_report_t::*, int64_t node_report_t::*>;

struct StandardKey {
  std::string_view key;
  Member member;
};

/// In the order in which they are written.
const std::array<StandardKey, 19> kStandardKeys = {{
    {"NAME", &node_report_t::name},
    {"X", &node_report_t::x_m},
    {"Y", &node_report_t::y_m},
    {"SPD", &node_report_t::speed_mps},
    {"HDG", &node_report_t::heading_deg},
    {"COG", &node_report_t::course_over_ground_deg},
    {"DEP", &node_report_t::depth_m},
    {"LAT", &node_report_t::lat_deg},
    {"LON", &node_report_t::lon_deg},
    {"TYPE", &node_report_t::type},
    {"COLOR", &node_report_t::color},
    {"GROUP", &node_report_t::group},
    {"MODE", &node_report_t::mode},
    {"ALLSTOP", &node_report_t::all_stop},
    {"ALTITUDE", &node_report_t::altitude_m},
    {"SPD_OG", &node_report_t::speed_over_ground_mps},
    {"INDEX", &node_report_t::index},
    {"TIME", &node_report_t::utime},
    {"LENGTH", &node_report_t::length_m},
}};

constexpr std::string_view kExtraPrefix = "extra.";
constexpr double kAltitudeUnknown = -1;

std::string UpperKey(std::string_view key) {
  std::string upper(key);
  for (char& c : upper) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return upper;
}

bool IsStandard(std::string_view key) {
  constexpr size_t kLongest = 8;
  if (key.size() > kLongest) return false;
  const std::string upper = UpperKey(key);
  return std::any_of(kStandardKeys.begin(), kStandardKeys.end(),
                     [&](const StandardKey& standard) { return standard.key == upper; });
}

}  // namespace

std::string FormatNodeReport(const node_report_t& report) {
  std::string text;
  for (const StandardKey& standard : kStandardKeys) {
    if (const auto* member = std::get_if<std::string node_report_t::*>(&standard.member)) {
      const std::string& value = report.*(*member);
      if (!value.empty() || standard.key == "NAME") AppendField(standard.key, value, &text);
    } else if (const auto* real = std::get_if<double node_report_t::*>(&standard.member)) {
      const double value = report.*(*real);
      if (standard.key == "ALTITUDE" && value == kAltitudeUnknown) continue;
      AppendField(standard.key, NumberText(value), &text);
    } else if (standard.key == "TIME") {
      AppendField(standard.key, SecondsText(report.utime), &text);
    } else {
      AppendField(standard.key, std::to_string(report.index), &text);
    }
  }
  for (const key_value_t& field : report.extra) {
    const bool is_taken = IsStandard(field.key) || field.key.starts_with(kExtraPrefix);
    AppendField(is_taken ? std::string(kExtraPrefix) + field.key : field.key, field.value, &text);
  }
  return text;
}

}  // namespace shoal
