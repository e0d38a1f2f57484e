// The leg of a LegRun, whose two ends several keys move.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace shoal {

class BhvLeg {
 public:
  /// True for leg, leg_len, leg_len_mod, leg_ang, leg_ang_mod and shift_pt, which move both ends.
  [[nodiscard]] static bool IsKey(std::string_view key);

  /// p1 (0) or p2 (1).
  void SetEnd(size_t i, const Eigen::Vector2d& end_m) { ends_m_[i] = end_m; }

  /// Moves both ends, rounded to a micrometre. Returns what is wrong; then they stay.
  /// @pre IsKey(key)
  [[nodiscard]] std::string Take(std::string_view key, std::string_view value);

  /// @pre it is set
  const Eigen::Vector2d& end_m(size_t i) const { return *ends_m_[i]; }

 private:
  std::array<std::optional<Eigen::Vector2d>, 2> ends_m_;
};

}  // namespace shoal
