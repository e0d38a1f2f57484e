// The drift that uSimMarine pushes a vehicle with: as lines set it, and as posts change it.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

/// What a post does to the drift: sets it, sets one of its parts, or changes the present value.
enum class DriftAction { kSet, kAdd, kScale, kSetX, kSetY };

struct DriftChange {
  std::string vehicle;
  DriftAction action = DriftAction::kSet;
  Eigen::Vector2d drift_mps = {0, 0};  ///< x East, y North; of kScale, kSetX and kSetY x() alone.
};

/// Reads "ANGLE,SPEED", degrees and m/s.
[[nodiscard]] std::optional<Eigen::Vector2d> ParseDriftVector(std::string_view value);

/// Takes drift_x, drift_y or drift_vector of uSimMarine, in lower case. Returns false where the
/// value makes no sense, or the key is another.
bool TakeDriftLine(std::string_view key, std::string_view value, Eigen::Vector2d* drift_mps);

/// Returns what a post to a variable does, without its vehicle's name behind it: DRIFT_VECTOR,
/// DRIFT_VECTOR_ADD, DRIFT_VECTOR_MULT, DRIFT_X, CURRENT_Y ... Nothing for other variables.
[[nodiscard]] std::optional<DriftAction> DriftActionOf(std::string_view variable);

/// All such variables, longer ones first.
[[nodiscard]] std::vector<std::string_view> DriftVariables();

/// Reads the value of such a post.
[[nodiscard]] std::optional<Eigen::Vector2d> ParseDriftValue(DriftAction action,
                                                             std::string_view value);

/// Returns the drift after a change, without the 1e-17 that sines leave.
[[nodiscard]] Eigen::Vector2d DriftAfter(const Eigen::Vector2d& before_mps,
                                         const DriftChange& change);

}  // namespace shoal
