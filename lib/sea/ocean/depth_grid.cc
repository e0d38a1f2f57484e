#include "lib/sea/ocean/depth_grid.h"

#include <algorithm>

#include "lib/base/check/check.h"

namespace shoal {

DepthGrid::DepthGrid(GridMap map, std::vector<float> depths_m)
    : map_(std::move(map)), depths_m_(std::move(depths_m)) {
  SHOAL_CHECK(depths_m_.size() == map_.num_points() && !depths_m_.empty(),
              "a grid has columns * rows finite depths");
  shallowest_m_ = *std::ranges::min_element(depths_m_);
}

double DepthGrid::DepthAt(const Eigen::Vector2d& position_m) const {
  return map_.Interpolate(depths_m_, map_.Locate(position_m));
}

}  // namespace shoal
