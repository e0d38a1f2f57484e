// How far each vehicle is from the one that is nearest to it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace shoal {

/// Returns, for each position, the distance to the nearest other one, in three dimensions; infinity
/// where there is no other. Sorts along the longer horizontal side and looks only at those that are
/// near along it: about n log n. @pre positions are finite
[[nodiscard]] std::vector<double> NearestDistances_m(std::span<const Eigen::Vector3d> positions_m);

}  // namespace shoal
