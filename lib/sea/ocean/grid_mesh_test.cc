#include "lib/sea/ocean/grid_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "lib/sea/ocean/grid_map.h"

namespace shoal::grid_mesh_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr GeoPoint kOrigin = {.lat_deg = 60, .lon_deg = 5};

/// A bent grid of 5 columns and 4 rows about the origin, some 2 km from point to point, turned by
/// 30 degrees; positions in the mission's plane.
struct Bent {
  std::vector<Eigen::Vector2d> places_m;
  std::vector<double> lats_deg;
  std::vector<double> lons_deg;
  std::vector<float> values;  ///< Linear in the plane.

  static float Value(const Eigen::Vector2d& place_m) {
    return static_cast<float>(100 + place_m.x() / 100 - place_m.y() / 50);
  }

  Bent() {
    const LocalFrame frame(kOrigin);
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 5; ++column) {
        const double x = 2000.0 * (column - 2) + 40.0 * row * row;
        const double y = 2000.0 * (row - 1.5) - 60.0 * column * column;
        places_m.emplace_back(0.866 * x - 0.5 * y, 0.5 * x + 0.866 * y);
        const GeoPoint point = frame.ToGeo(places_m.back());
        lats_deg.push_back(point.lat_deg);
        lons_deg.push_back(point.lon_deg);
        values.push_back(Value(places_m.back()));
      }
    }
  }
  GridMap Map() const { return GridMap(GridMesh(kOrigin, 5, 4, lats_deg, lons_deg)); }
};

TEST(GridMesh, IsExactAtItsPointsAndBetweenThemForWhatIsLinear) {
  const Bent bent;
  const GridMap map = bent.Map();
  for (size_t i = 0; i < bent.places_m.size(); ++i) {
    EXPECT_NEAR(map.Interpolate(bent.values, map.Locate(bent.places_m[i])), bent.values[i], 1e-3);
  }
  for (double x_m = -2500; x_m <= 2500; x_m += 170) {
    const Eigen::Vector2d place_m(x_m, 700 - x_m / 5);
    const GridCell cell = map.Locate(place_m);
    ASSERT_TRUE(cell.IsInside()) << x_m;
    EXPECT_NEAR(map.Interpolate(bent.values, cell), Bent::Value(place_m), 1e-3) << x_m;
  }
}

TEST(GridMesh, IsThatOfItsNearestPointBeyondItsCellsAndInsideForHalfACell) {
  const Bent bent;
  const GridMap map = bent.Map();
  const Eigen::Vector2d corner_m = bent.places_m.front();
  const Eigen::Vector2d out = corner_m.normalized();
  EXPECT_TRUE(map.Locate(corner_m + 900 * out).IsInside());
  EXPECT_FALSE(map.Locate(corner_m + 1500 * out).IsInside());
  EXPECT_EQ(map.Interpolate(bent.values, map.Locate(corner_m + 1500 * out)), bent.values.front());
  EXPECT_FALSE(map.Locate({kNan, 0}).IsInside());
}

TEST(GridMesh, IsThatOfTheNearestOfAllPointsWhereverAVehicleIs) {
  // More than two blocks along either side, with a hole.
  constexpr int kColumns = 70;
  constexpr int kRows = 90;
  const LocalFrame frame(kOrigin);
  std::vector<double> lats_deg;
  std::vector<double> lons_deg;
  std::vector<Eigen::Vector2d> places_m;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const bool is_hole = column > 20 && column < 50 && row > 10 && row < 70;
      const GeoPoint point =
          frame.ToGeo({500.0 * (column - 35) + 8.0 * row, 400.0 * (row - 45) - 0.3 * column * row});
      lats_deg.push_back(is_hole ? kNan : point.lat_deg);
      lons_deg.push_back(point.lon_deg);
      places_m.push_back(
          frame.ToLocal({lats_deg.back(), lons_deg.back()}).value_or(Eigen::Vector2d(kNan, kNan)));
    }
  }
  const GridMesh mesh(kOrigin, kColumns, kRows, lats_deg, lons_deg);
  for (double angle_rad = 0; angle_rad < 6.2; angle_rad += 0.3) {
    for (const double distance_m : {10.0, 2000.0, 30'000.0, 1e6}) {
      const Eigen::Vector2d place_m =
          distance_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
      size_t nearest = 0;
      double least = std::numeric_limits<double>::infinity();
      for (size_t i = 0; i < places_m.size(); ++i) {
        if ((places_m[i] - place_m).squaredNorm() < least) {
          least = (places_m[i] - place_m).squaredNorm();
          nearest = i;
        }
      }
      const GridCell cell = mesh.Locate(place_m);
      if (cell.x.before != cell.x.after) continue;  // In a cell.
      EXPECT_EQ(cell.x.before, static_cast<int>(nearest) % kColumns) << place_m.transpose();
      EXPECT_EQ(cell.y.before, static_cast<int>(nearest) / kColumns) << place_m.transpose();
    }
  }
}

TEST(GridMesh, LeavesOutPointsWithoutAPlace) {
  Bent bent;
  bent.lats_deg[7] = kNan;
  bent.lons_deg[12] = kNan;
  const GridMap map = bent.Map();
  const GridCell cell = map.Locate(bent.places_m[7]);
  EXPECT_EQ(cell.x.share, 0) << "the nearest of the others";
  EXPECT_FALSE(cell.x.before == 2 && (cell.y.before == 1 || cell.y.before == 2));
  const GridMap none(GridMesh(kOrigin, 2, 2, std::vector(4, kNan), std::vector(4, kNan)));
  EXPECT_FALSE(none.Locate({0, 0}).IsInside());
  const GridMap far(GridMesh({.lat_deg = -60, .lon_deg = 5}, 5, 4, bent.lats_deg, bent.lons_deg));
  EXPECT_FALSE(far.Locate({0, 0}).IsInside()) << "on the other side of the Earth";
}

TEST(GridMesh, TakesLongitudesFromAnywhere) {
  Bent bent;
  for (double& lon_deg : bent.lons_deg) lon_deg += 720;
  const GridMap map = bent.Map();
  EXPECT_TRUE(map.Locate({0, 0}).IsInside());
}

TEST(GridMesh, OfPointsThatLieAnywhereIsFoundWithoutMuchMemory) {
  std::vector<double> lats_deg;
  std::vector<double> lons_deg;
  for (int i = 0; i < 100 * 100; ++i) {
    lats_deg.push_back(60 + (i * 37 % 101) / 50.0);
    lons_deg.push_back(5 + (i * 53 % 97) / 50.0);
  }
  const GridMap map(GridMesh(kOrigin, 100, 100, lats_deg, lons_deg));
  const GridCell cell = map.Locate({20'000, 30'000});
  EXPECT_GE(cell.x.share, 0);
  EXPECT_LE(cell.y.share, 1);
}

}  // namespace shoal::grid_mesh_test
