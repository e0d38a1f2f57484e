// Visits depths, each for a time.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "lib/behaviors/behavior.h"

namespace shoal {

/// kind = "go_to_depth". Visits depths, each for a time.
struct GoToDepthOptions {
  static constexpr std::string_view kKind = "go_to_depth";

  std::vector<Eigen::Vector2d> depths = {};    ///< Pairs of a depth, m, and a time, s, at it.
  int repeat = 0;                              ///< Further rounds.
  double capture_delta = 1;                    ///< m.
  std::vector<std::string> capture_flag = {};  ///< At each depth that is reached.

  bool operator==(const GoToDepthOptions&) const = default;
};

}  // namespace shoal
