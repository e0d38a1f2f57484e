// The points of a grid around a position.
#pragma once

#include "lib/sea/ocean/grid_axis.h"

namespace shoal {

/// The four points around a position.
struct GridCell {
  GridPlace x;  ///< Columns.
  GridPlace y;  ///< Rows.

  /// At most half a cell beyond the outermost points.
  bool IsInside() const { return x.is_inside && y.is_inside; }
};

}  // namespace shoal
