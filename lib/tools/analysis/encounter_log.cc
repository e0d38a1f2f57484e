#include "lib/tools/analysis/encounter_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "lib/base/time/seconds.h"
#include "lib/bus/record/csv_rows.h"
#include "lib/comms/routing/vehicle_name.h"
#include "lib/helm/encounters/encounter_score.h"

namespace shoal {

namespace {

constexpr double kLookInterval_s = 0.0999;
/// A vehicle whose last NAV is older is seen no more.
constexpr double kOldest_s = 5;
/// A quarter of the Earth's circumference, and ten times the speed of sound in water.
constexpr double kFarthest_m = 1e7;
constexpr double kFastestEver_mps = 15'000;
constexpr size_t kMaxJudgements = 1'000'000;
/// Times from year -290,000 on are none.
constexpr int64_t kLatest_utime = int64_t{1} << 60;

bool IsPossible(const nav_t& nav) {
  for (const double each : {nav.x_m, nav.y_m, nav.z_m}) {
    if (!std::isfinite(each) || std::abs(each) > kFarthest_m) return false;
  }
  return std::isfinite(nav.heading_deg) && std::abs(nav.heading_deg) <= 720 &&
         std::isfinite(nav.speed_mps) && std::abs(nav.speed_mps) <= kFastestEver_mps &&
         nav.utime >= 0 && nav.utime <= kLatest_utime;
}

std::string Rule(const std::optional<double>& score) {
  return score ? fmt::format("{:.0f}", *score) : "-";
}

std::string Optional(const std::optional<double>& value) {
  return value ? fmt::format("{:.6f}", *value) : "";
}

std::string FirstAlteration(const EncounterSide& side) {
  if (!side.conduct.first_alteration_s) return "none";
  return fmt::format("{:.1f} s", *side.conduct.first_alteration_s);
}

}  // namespace

size_t EncounterLog::FindVessel(std::string_view vehicle) {
  const std::string key = VehicleKey(vehicle);
  const auto found = places_.find(key);
  if (found != places_.end()) return found->second;
  if (vessels_.size() >= kMaxVehicles) return kMaxVehicles;
  const size_t place = vessels_.size();
  vessels_.push_back({.name = key});
  samples_.emplace_back();
  places_.emplace(key, place);
  return place;
}

void EncounterLog::Add(std::string_view vehicle, const nav_t& nav) {
  if (!IsPossible(nav)) {
    ++num_impossible_;
    return;
  }
  const double time_s = Seconds(nav.utime);
  if (has_nav_ && time_s < now_s_) {
    ++num_late_;
    return;
  }
  if (has_nav_ && time_s > now_s_ && now_s_ - last_look_s_ >= kLookInterval_s) Look();
  if (!has_nav_) last_look_s_ = time_s - 1;
  has_nav_ = true;
  now_s_ = time_s;
  const size_t place = FindVessel(vehicle);
  if (place >= kMaxVehicles) {
    ++num_vehicles_left_out_;
    return;
  }
  vessels_[place].seen_s = time_s;
  VesselSample& sample = samples_[place];
  sample.is_seen = true;
  sample.motion = {.position_m = {nav.x_m, nav.y_m},
                   .heading_deg = nav.heading_deg,
                   .speed_mps = std::max(0.0, nav.speed_mps)};
  sample.depth_m = nav.z_m;
}

void EncounterLog::Add(const node_report_t& report) {
  if (!IsLegalVehicleName(report.name)) return;
  const auto found = places_.find(VehicleKey(report.name));
  if (found == places_.end()) return;  // No NAV of it.
  vessels_[found->second].name = report.name;
  constexpr double kLongest_m = 1000;
  if (report.length_m >= 0 && report.length_m <= kLongest_m) {
    samples_[found->second].length_m = report.length_m;
  }
}

void EncounterLog::Add(std::string_view vehicle, const helm_decision_t& decision) {
  for (const helm_aim_t& aim : decision.aims) {
    if (aim.contact.empty() || aim.role.empty() || !IsLegalVehicleName(aim.contact)) continue;
    if (num_judgements_ >= kMaxJudgements) return;
    std::vector<Judgement>& known = judgements_[{VehicleKey(vehicle), VehicleKey(aim.contact)}];
    if (!known.empty() && known.back().role == aim.role) continue;
    constexpr size_t kLongestRole = 40;
    known.push_back({Seconds(decision.utime), aim.role.substr(0, kLongestRole)});
    ++num_judgements_;
  }
}

void EncounterLog::Look() {
  for (size_t i = 0; i < vessels_.size(); ++i) {
    samples_[i].is_seen = vessels_[i].seen_s >= 0 && now_s_ - vessels_[i].seen_s <= kOldest_s;
  }
  watch_.Look(now_s_, samples_);
  last_look_s_ = now_s_;
}

void EncounterLog::Finish() {
  if (has_nav_) Look();
  encounters_ = watch_.Encounters();
}

/// Returns what the helm judged first of this contact, avoidance without rules left aside:
/// "give-way"; nothing where it judged nothing.
std::string EncounterLog::HelmRole(const Encounter& encounter, size_t side) const {
  const auto found = judgements_.find({VehicleKey(NameOf(encounter.sides[side].vessel)),
                                       VehicleKey(NameOf(encounter.sides[1 - side].vessel))});
  if (found == judgements_.end()) return "";
  std::string at_begin;
  for (const Judgement& each : found->second) {
    if (each.time_s > encounter.end_s) break;
    std::string role = each.role.substr(0, each.role.find(':'));
    const bool knows_rules = role != "cpa" && role != "avoid" && role != "none";
    if (each.time_s <= encounter.begin_s) {
      at_begin = knows_rules ? role : "";
    } else if (at_begin.empty() && knows_rules) {
      at_begin = role;
    }
  }
  return at_begin;
}

double EncounterLog::LowestScore(const Encounter& encounter) const {
  return std::min(ScoreOf(encounter, 0, watch_.options()).overall,
                  ScoreOf(encounter, 1, watch_.options()).overall);
}

std::vector<const Encounter*> EncounterLog::Chosen(size_t most) const {
  std::vector<const Encounter*> chosen;
  for (const Encounter& each : encounters_) chosen.push_back(&each);
  if (chosen.size() <= most) return chosen;
  std::stable_sort(chosen.begin(), chosen.end(), [this](const Encounter* a, const Encounter* b) {
    return LowestScore(*a) < LowestScore(*b);
  });
  chosen.resize(most);
  return chosen;
}

std::string EncounterLog::Text(size_t most) const {
  std::string text = fmt::format(
      "{:>7}  {:<12} {:<12} {:<11} {:<11} {:>6} {:>9} {:>8}  {:<22} {:>11} {:>7} {:>5}  {:>6} "
      "{:>3} "
      "{:>3} {:>3} {:>3} {:>3} {:>3}  {:>5}\n",
      "begin_s", "vessel", "contact", "role", "helm", "rule", "closest_m", "at_s", "passed",
      "altered", "course", "speed", "safety", "8", "13", "14", "15", "16", "17", "score");
  const std::vector<const Encounter*> chosen = Chosen(most);
  for (const Encounter* encounter : chosen) {
    for (size_t i = 0; i < 2; ++i) {
      const EncounterSide& side = encounter->sides[i];
      const EncounterScore score = ScoreOf(*encounter, i, watch_.options());
      const std::string helm = HelmRole(*encounter, i);
      text += fmt::format(
          "{:7.1f}  {:<12} {:<12} {:<11} {:<11} {:>6} {:9.1f} {:8.1f}  {:<22} {:>11} {:+7.0f} "
          "{:+4.0f}%  {:6.0f} {:>3} {:>3} {:>3} {:>3} {:>3} {:>3}  {:5.1f}{}\n",
          encounter->begin_s, NameOf(side.vessel), NameOf(encounter->sides[1 - i].vessel),
          Name(side.role), helm.empty() ? "-" : helm, RuleOf(side.role), encounter->closest_m,
          encounter->closest_s, PassedHow(*encounter, i), FirstAlteration(side),
          side.conduct.largest_course_change_deg, 100 * side.conduct.largest_speed_change_share,
          score.safety, Rule(score.rule_8), Rule(score.rule_13), Rule(score.rule_14),
          Rule(score.rule_15), Rule(score.rule_16), Rule(score.rule_17), score.overall,
          encounter->has_touched ? "  collision" : "");
    }
  }
  if (chosen.size() < encounters_.size()) {
    text += fmt::format("{} of {} encounters, those with the lowest scores; --all shows all\n",
                        chosen.size(), encounters_.size());
  }
  return text;
}

std::string EncounterLog::Explanation(size_t most) const {
  std::string text;
  const EncounterOptions& options = watch_.options();
  for (const Encounter* encounter : Chosen(most)) {
    for (size_t i = 0; i < 2; ++i) {
      const EncounterSide& side = encounter->sides[i];
      const EncounterScore score = ScoreOf(*encounter, i, options);
      const ScoreParts& parts = score.parts;
      const Conduct& conduct = side.conduct;
      text += fmt::format(
          "{} toward {}, from {:.1f} to {:.1f} s{}\n"
          "  at entry: {}, rule {}; range {:.1f} m, beta {:.1f}, alpha {:.1f} degrees; holding on: "
          "{:.1f} m in {:.1f} s\n"
          "  closest: {:.1f} m at {:.1f} s, beta {:.1f}, alpha {:.1f} degrees; passed {}\n",
          NameOf(side.vessel), NameOf(encounter->sides[1 - i].vessel), encounter->begin_s,
          encounter->end_s, encounter->is_over ? "" : ", not over", Name(side.role),
          side.role == EncounterRole::kNone ? "none" : RuleOf(side.role), side.entry.range_m,
          side.entry.beta_deg, side.entry.alpha_deg, side.entry.cpa_m, side.entry.time_to_cpa_s,
          encounter->closest_m, encounter->closest_s, side.beta_deg, side.alpha_deg,
          PassedHow(*encounter, i));
      text +=
          fmt::format("  altered first: {}{}; at most {:+.1f} degrees, {:+.0f} % of speed\n",
                      FirstAlteration(side),
                      conduct.altered_to > 0   ? ", to starboard"
                      : conduct.altered_to < 0 ? ", to port"
                                               : "",
                      conduct.largest_course_change_deg, 100 * conduct.largest_speed_change_share);
      if (score.rule_17) {
        text +=
            fmt::format("  held: {:.1f} degrees, {:.0f} % of speed{}{}\n",
                        conduct.held_course_change_deg, 100 * conduct.held_speed_change_share,
                        conduct.in_extremis_s
                            ? fmt::format("; in extremis at {:.1f} s, {}", *conduct.in_extremis_s,
                                          conduct.acted_in_extremis ? "acted" : "did not act")
                            : "",
                        side.excused_s ? fmt::format("; excused from {:.1f} s on: a third "
                                                     "vessel to keep clear of",
                                                     *side.excused_s)
                                       : "");
      }
      text += fmt::format(
          "  parts: range {:.2f}, pose {:.2f}, apparent {:.2f}, early {:.2f}, starboard {:.0f}, "
          "port "
          "to port {:.0f}, behind {:.2f}, held {:.2f} {:.2f}, last resort {:.1f}\n"
          "  score {:.1f}: safety {:.1f}; rules 8: {}, 13: {}, 14: {}, 15: {}, 16: {}, 17: {}\n",
          parts.range, parts.pose, parts.apparent, parts.early, parts.starboard, parts.port_to_port,
          parts.behind, parts.held_course, parts.held_speed, parts.last_resort, score.overall,
          score.safety, Rule(score.rule_8), Rule(score.rule_13), Rule(score.rule_14),
          Rule(score.rule_15), Rule(score.rule_16), Rule(score.rule_17));
    }
  }
  return text;
}

std::string EncounterLog::Csv() const {
  std::string text =
      "begin_s,end_s,is_over,vessel,contact,role,helm_role,rule,entry_range_m,entry_beta_deg,"
      "entry_alpha_deg,entry_cpa_m,entry_tcpa_s,closest_m,closest_s,beta_deg,alpha_deg,passed,"
      "collision,first_alteration_s,altered_to,course_change_deg,speed_change_share,"
      "held_course_change_deg,held_speed_change_share,in_extremis_s,excused_s,crossed_ahead_m,"
      "safety,rule_8,rule_13,rule_14,rule_15,rule_16,rule_17,score\n";
  for (const Encounter& encounter : encounters_) {
    for (size_t i = 0; i < 2; ++i) {
      const EncounterSide& side = encounter.sides[i];
      const Conduct& conduct = side.conduct;
      const EncounterScore score = ScoreOf(encounter, i, watch_.options());
      text +=
          fmt::format("{:.6f},{:.6f},{:d},", encounter.begin_s, encounter.end_s, encounter.is_over);
      AppendCsvCell(NameOf(side.vessel), &text);
      text += ',';
      AppendCsvCell(NameOf(encounter.sides[1 - i].vessel), &text);
      text += fmt::format(",{},", Name(side.role));
      AppendCsvCell(HelmRole(encounter, i), &text);
      text += fmt::format(
          ",{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{},{:d},{},{},{:.6f},"
          "{:.6f},{:.6f},{:.6f},{},{},{},{:.6f},{},{},{},{},{},{},{:.6f}\n",
          RuleOf(side.role), side.entry.range_m, side.entry.beta_deg, side.entry.alpha_deg,
          side.entry.cpa_m, side.entry.time_to_cpa_s, encounter.closest_m, encounter.closest_s,
          side.beta_deg, side.alpha_deg, PassedHow(encounter, i), encounter.has_touched,
          Optional(conduct.first_alteration_s), conduct.altered_to,
          conduct.largest_course_change_deg, conduct.largest_speed_change_share,
          conduct.held_course_change_deg, conduct.held_speed_change_share,
          Optional(conduct.in_extremis_s), Optional(side.excused_s), Optional(side.crossed_ahead_m),
          score.safety, Optional(score.rule_8), Optional(score.rule_13), Optional(score.rule_14),
          Optional(score.rule_15), Optional(score.rule_16), Optional(score.rule_17), score.overall);
    }
  }
  return text;
}

}  // namespace shoal
