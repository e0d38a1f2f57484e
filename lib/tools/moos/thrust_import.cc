#include "lib/tools/moos/thrust_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/fields.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {

bool ThrustImport::TakeMap(const MoosLine& line, const std::string& table, MissionDraft* draft) {
  std::map<double, double> speeds;
  for (const std::string_view part : TrimmedParts(line.value, ',')) {
    const size_t colon = part.find(':');
    if (colon == std::string_view::npos) return false;
    const auto thrust = NumberIn(part.substr(0, colon));
    const auto speed = NumberIn(part.substr(colon + 1));
    if (!thrust || !speed) return false;
    speeds[*thrust] = *speed;
  }
  Replace(line, table, draft);
  map_ = std::move(speeds);
  return true;
}

/// The map of an earlier line becomes a comment.
void ThrustImport::Replace(const MoosLine& line, const std::string& table, MissionDraft* draft) {
  if (!lines_.origins.empty()) {
    draft->Remark(table, lines_.origins, lines_.texts, "replaced by " + line.origin);
  }
  lines_ = {};
  lines_.Add(line.origin, line.text);
}

bool ThrustImport::TakeFactor(const MoosLine& line, const std::string& table, MissionDraft* draft) {
  const auto factor = NumberIn(line.value);
  if (!factor) return false;
  if (*factor <= 0 || !map_.empty()) {
    draft->Remark(table, line.origin, line.text,
                  *factor <= 0 ? "must be positive" : "the thrust map is used instead");
    return true;
  }
  Replace(line, table, draft);
  map_ = {{100, 100 / *factor}};
  return true;
}

bool ThrustImport::TakeMaxSpeed(const MoosLine& line, const std::string& table,
                                MissionDraft* draft) {
  const auto speed_mps = NumberIn(line.value);
  if (!speed_mps || *speed_mps <= 0) return false;
  if (max_speed_mps_) {
    draft->Remark(table, limit_.origins, limit_.texts, "replaced by " + line.origin);
  }
  limit_ = {};
  limit_.Add(line.origin, line.text);
  max_speed_mps_ = *speed_mps;
  return true;
}

/// uSimMarine runs no faster than max_speed, whatever the thrust.
void ThrustImport::Limit() {
  constexpr double kThrustForDefaultSpeed_pct = 20;  // uSimMarine's thrust_factor, per m/s.
  if (map_.empty()) map_ = {{100, 100 / kThrustForDefaultSpeed_pct}};
  std::map<double, double> limited;
  std::pair<double, double> before = {0, 0};
  for (const auto& [thrust_pct, speed_mps] : map_) {
    if (speed_mps <= *max_speed_mps_) {
      limited[thrust_pct] = speed_mps;
    } else {
      const double share = (*max_speed_mps_ - before.second) / (speed_mps - before.second);
      limited[before.first + share * (thrust_pct - before.first)] = *max_speed_mps_;
      limited[thrust_pct] = *max_speed_mps_;
    }
    if (thrust_pct > 0) before = {thrust_pct, std::min(speed_mps, *max_speed_mps_)};
  }
  map_ = std::move(limited);
}

void ThrustImport::Finish(const std::string& table, MissionDraft* draft) {
  if (max_speed_mps_) {
    Limit();
    lines_.origins += (lines_.origins.empty() ? "" : ", ") + limit_.origins;
    lines_.texts += (lines_.texts.empty() ? "" : ", ") + limit_.texts;
  }
  if (map_.empty()) return;
  std::string pairs;
  for (const auto& [thrust, speed] : map_) {
    pairs +=
        fmt::format("{}[{}, {}]", pairs.empty() ? "" : ", ", TomlNumber(thrust), TomlNumber(speed));
  }
  draft->Set(table, {.key = "thrust_map",
                     .value = "[" + pairs + "]",
                     .origin = lines_.origins,
                     .text = lines_.texts,
                     .reason = ""});
}

}  // namespace shoal
