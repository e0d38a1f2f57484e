#include "lib/tools/analysis/decision_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "lib/base/geometry/angles.h"
#include "lib/base/time/seconds.h"
#include "lib/run/run/status_page.h"

namespace shoal {

namespace {

/// Courses and speeds that differ by less count as the same choice.
constexpr double kSameCourse_deg = 1;
constexpr double kSameSpeed_mps = 0.05;

/// A name in full, made printable.
std::string NameOf(std::string_view name) { return Printable(name, kLongestSentence); }

std::string PointWords(double course_deg, double speed_mps, double depth_m) {
  std::vector<std::string> parts;
  if (course_deg >= 0) parts.push_back(fmt::format("course {:.0f} deg", course_deg));
  if (speed_mps >= 0) parts.push_back(fmt::format("speed {:.1f} m/s", speed_mps));
  if (depth_m >= 0) parts.push_back(fmt::format("depth {:.1f} m", depth_m));
  return parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string RoleWords(const helm_aim_t& aim) {
  if (aim.contact.empty()) return {};
  std::string text = fmt::format("; {} toward {}", NameOf(aim.role), NameOf(aim.contact));
  if (!aim.rule.empty()) text += fmt::format(" (rule {})", NameOf(aim.rule));
  if (aim.range_m >= 0) text += fmt::format(", range {:.1f} m", aim.range_m);
  if (aim.cpa_m >= 0) text += fmt::format(", CPA {:.1f} m if both hold on", aim.cpa_m);
  if (aim.age_s >= 0) text += fmt::format(", known {:.1f} s ago", aim.age_s);
  return text;
}

bool HasPreference(const helm_aim_t& aim) { return aim.weight > 0; }

bool GotItsBest(const helm_aim_t& aim, const helm_decision_t& decision) {
  const bool same_course =
      aim.best_course_deg < 0 ||
      std::abs(Wrap180(aim.best_course_deg - decision.course_deg)) < kSameCourse_deg;
  const bool same_speed =
      aim.best_speed_mps < 0 || std::abs(aim.best_speed_mps - decision.speed_mps) < kSameSpeed_mps;
  return same_course && same_speed;
}

/// The behavior that gave up most, in weighted utility; nullptr: none gave up anything.
const helm_aim_t* GaveUpMost(const helm_decision_t& decision) {
  const helm_aim_t* most = nullptr;
  for (const helm_aim_t& aim : decision.aims) {
    if (HasPreference(aim) && aim.loss > 1e-6 && (most == nullptr || aim.loss > most->loss)) {
      most = &aim;
    }
  }
  return most;
}

/// The behaviors whose sum bound the decision: all that kept at least half of what they could have,
/// those with the greatest share first.
std::vector<const helm_aim_t*> BoundBy(const helm_decision_t& decision, const helm_aim_t& other) {
  std::vector<const helm_aim_t*> bound;
  for (const helm_aim_t& aim : decision.aims) {
    constexpr double kHalf = 50;
    if (HasPreference(aim) && &aim != &other && aim.value >= kHalf) bound.push_back(&aim);
  }
  std::stable_sort(bound.begin(), bound.end(), [](const helm_aim_t* a, const helm_aim_t* b) {
    return a->weight * a->value > b->weight * b->value;
  });
  return bound;
}

std::string Winner(const helm_aim_t& aim) {
  if (aim.contact.empty()) return NameOf(aim.name);
  std::string text = fmt::format("{}, which is {} toward {}", NameOf(aim.name), NameOf(aim.role),
                                 NameOf(aim.contact));
  if (!aim.rule.empty()) text += fmt::format(" by rule {}", NameOf(aim.rule));
  return text;
}

std::string Reason(const helm_decision_t& decision) {
  if (decision.all_stop != "clear") {
    return fmt::format("It stands still: {}.", NameOf(decision.all_stop));
  }
  const helm_aim_t* loser = GaveUpMost(decision);
  if (loser == nullptr) return "Every behavior got what it wanted most.";
  const std::vector<const helm_aim_t*> bound = BoundBy(decision, *loser);
  const double loss = loser->loss / loser->weight;
  if (bound.empty() || GotItsBest(*loser, decision)) {
    return fmt::format("{} gave up {:.1f} of 100.", NameOf(loser->name), loss);
  }
  std::string winners;
  for (const helm_aim_t* aim : bound) winners += (winners.empty() ? "" : "; ") + Winner(*aim);
  return fmt::format("{} wanted {} and gave up {:.1f} of 100 for {}.", NameOf(loser->name),
                     PointWords(loser->best_course_deg, loser->best_speed_mps, -1), loss, winners);
}

/// What is not a number in the reason of a decision, and the roles.
std::string Gist(const helm_decision_t& decision) {
  std::string text = decision.mode + "\n" + decision.all_stop;
  const helm_aim_t* loser = GaveUpMost(decision);
  if (loser != nullptr) text += "\n" + loser->name;
  for (const helm_aim_t& aim : decision.aims) {
    if (HasPreference(aim)) text += "\n" + aim.name + " " + aim.role;
  }
  return text;
}

}  // namespace

std::string DecisionWords(const helm_decision_t& decision) {
  std::string text =
      fmt::format("{} at {:.3f} s: {}{}\n", Printable(decision.vehicle), Seconds(decision.utime),
                  PointWords(decision.course_deg, decision.speed_mps, decision.depth_m),
                  decision.mode.empty() ? "" : fmt::format("; mode {}", NameOf(decision.mode)));
  for (const helm_aim_t& aim : decision.aims) {
    text += fmt::format("  {} ({}, {})", NameOf(aim.name), NameOf(aim.kind), NameOf(aim.state));
    if (HasPreference(aim)) {
      text += fmt::format(": weight {:.0f}, wants {}, has {:.1f} of 100 here", aim.weight,
                          PointWords(aim.best_course_deg, aim.best_speed_mps, aim.best_depth_m),
                          aim.value);
    }
    text += RoleWords(aim) + "\n";
  }
  for (const std::string& event : decision.events) {
    text += fmt::format("  event: {}\n", NameOf(event));
  }
  return text + Reason(decision) + "\n";
}

std::string DecisionLine(const helm_decision_t& decision) {
  return fmt::format(
      "{:>10.3f}  {:<12} {:<32} {}", Seconds(decision.utime), Printable(decision.vehicle),
      PointWords(decision.course_deg, decision.speed_mps, decision.depth_m), Reason(decision));
}

bool IsChange(const helm_decision_t& next, const helm_decision_t& last) {
  constexpr double kCourse_deg = 5;
  constexpr double kSpeed_mps = 0.2;
  constexpr double kDepth_m = 0.5;
  return (next.course_deg < 0) != (last.course_deg < 0) ||
         std::abs(Wrap180(next.course_deg - last.course_deg)) >= kCourse_deg ||
         std::abs(next.speed_mps - last.speed_mps) >= kSpeed_mps ||
         std::abs(next.depth_m - last.depth_m) >= kDepth_m || Gist(next) != Gist(last);
}

}  // namespace shoal
