#include "lib/tools/moos/sim_drift.h"

#include <array>
#include <cstddef>
#include <numbers>
#include <utility>

#include "lib/base/arithmetic/elementary.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {
namespace {

constexpr auto kDriftPosts = std::to_array<std::pair<std::string_view, DriftAction>>({
    {"DRIFT_VECTOR_MULT", DriftAction::kScale},
    {"DRIFT_VECTOR_ADD", DriftAction::kAdd},
    {"DRIFT_VECTOR", DriftAction::kSet},
    {"CURRENT_X", DriftAction::kSetX},
    {"CURRENT_Y", DriftAction::kSetY},
    {"DRIFT_X", DriftAction::kSetX},
    {"DRIFT_Y", DriftAction::kSetY},
});

}  // namespace

std::optional<Eigen::Vector2d> ParseDriftVector(std::string_view value) {
  const size_t comma = value.find(',');
  if (comma == value.npos) return std::nullopt;
  const auto angle_deg = NumberIn(value.substr(0, comma));
  const auto speed_mps = NumberIn(value.substr(comma + 1));
  if (!angle_deg || !speed_mps) return std::nullopt;
  const double angle_rad = *angle_deg * std::numbers::pi / 180;
  return Eigen::Vector2d(*speed_mps * Sin(angle_rad), *speed_mps * Cos(angle_rad));
}

bool TakeDriftLine(std::string_view key, std::string_view value, Eigen::Vector2d* drift_mps) {
  if (key == "drift_vector") {
    const auto vector_mps = ParseDriftVector(value);
    if (vector_mps) *drift_mps = *vector_mps;
    return vector_mps.has_value();
  }
  if (key != "drift_x" && key != "drift_y") return false;
  const auto number = NumberIn(value);
  if (number) (*drift_mps)(key == "drift_x" ? 0 : 1) = *number;
  return number.has_value();
}

std::optional<DriftAction> DriftActionOf(std::string_view variable) {
  for (const auto& [name, action] : kDriftPosts) {
    if (variable == name) return action;
  }
  return std::nullopt;
}

std::vector<std::string_view> DriftVariables() {
  std::vector<std::string_view> names;
  names.reserve(kDriftPosts.size());
  for (const auto& [name, action] : kDriftPosts) names.push_back(name);
  return names;
}

std::optional<Eigen::Vector2d> ParseDriftValue(DriftAction action, std::string_view value) {
  if (action == DriftAction::kSet || action == DriftAction::kAdd) return ParseDriftVector(value);
  const auto number = NumberIn(value);
  if (!number) return std::nullopt;
  return Eigen::Vector2d(*number, 0);
}

Eigen::Vector2d DriftAfter(const Eigen::Vector2d& before_mps, const DriftChange& change) {
  Eigen::Vector2d after_mps = before_mps;
  switch (change.action) {
    case DriftAction::kSet:
      after_mps = change.drift_mps;
      break;
    case DriftAction::kAdd:
      after_mps += change.drift_mps;
      break;
    case DriftAction::kScale:
      after_mps *= change.drift_mps.x();
      break;
    case DriftAction::kSetX:
      after_mps.x() = change.drift_mps.x();
      break;
    case DriftAction::kSetY:
      after_mps.y() = change.drift_mps.x();
      break;
  }
  return (after_mps * 1e9).array().round() / 1e9 + 0.0;
}

}  // namespace shoal
