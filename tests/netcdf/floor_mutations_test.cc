// Sea floors whose files were damaged, the same ones in every run: each is refused with the file's
// name, or is a floor that has depths. None is land everywhere without a word.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>

#include "lib/base/geodesy/local_frame.h"
#include "lib/base/geodesy/map_projection.h"
#include "lib/mission/file/grid_files.h"
#include "tests/fuzz/mutation.h"
#include "tests/netcdf/write_netcdf.h"

namespace shoal::floor_mutations_test {

constexpr size_t kMax_bytes = size_t{512} << 20;
constexpr GeoPoint kOrigin = {.lat_deg = 60, .lon_deg = 5};
constexpr int kNumRows = 5;

/// What makes land of a map: other signs, other marks, other keys.
constexpr std::array<std::string_view, 12> kHarm = {"-",
                                                    "0",
                                                    " nan ",
                                                    "1e30",
                                                    "\n",
                                                    "9999",
                                                    "up",
                                                    "down",
                                                    "_above_",
                                                    std::string_view("\0\0\0\0", 4),
                                                    std::string_view("\x7F\xF8\0\0\0\0\0\0", 8),
                                                    std::string_view("\xBF\xF0\0\0\0\0\0\0", 8)};

std::string EsriText() {
  std::string text =
      "ncols 5\nnrows 5\nxllcorner -250\nyllcorner -250\ncellsize 100\nNODATA_value -9999\n";
  for (int i = 0; i < kNumRows * kNumRows; ++i) {
    text += std::to_string(-30 - i) + (i % kNumRows == kNumRows - 1 ? "\n" : " ");
  }
  return text;
}

/// The axes of a grid about the origin, in degrees, metres of a map, or as latitudes and longitudes
/// of each point; and the depths on it.
enum class Places { kDegrees, kProjected, kCurvilinear };

WrittenNetcdf FloorOf(Places places) {
  const MapProjection map =
      MapProjection::Make({.kind = MapProjectionKind::kTransverseMercator, .central_lon_deg = 4})
          .value();
  const Eigen::Vector2d middle_m = map.Forward(kOrigin);
  const LocalFrame frame(kOrigin);
  WrittenVariable x = {.name = "x", .type = WrittenType::kDouble, .dimensions = {1}};
  WrittenVariable y = {.name = "y", .type = WrittenType::kDouble, .dimensions = {0}};
  WrittenVariable h = {.name = "h",
                       .dimensions = {0, 1},
                       .texts = {{"standard_name", "sea_floor_depth_below_geoid"}, {"units", "m"}}};
  for (int row = 0; row < kNumRows; ++row) {
    for (int column = 0; column < kNumRows; ++column) {
      const Eigen::Vector2d place_m(100 * (column - 2), 100 * (row - 2));
      const GeoPoint point = frame.ToGeo(place_m);
      const bool is_first = places == Places::kCurvilinear;
      if (is_first || row == 0) {
        x.values.push_back(places == Places::kProjected ? middle_m.x() + place_m.x()
                                                        : point.lon_deg);
      }
      if (is_first || column == 0) {
        y.values.push_back(places == Places::kProjected ? middle_m.y() + place_m.y()
                                                        : point.lat_deg);
      }
      h.values.push_back(30 + kNumRows * row + column);
    }
  }
  x.texts = {{"units", "degrees_east"}};
  y.texts = {{"units", "degrees_north"}};
  WrittenNetcdf file = {.dimensions = {{"y", kNumRows}, {"x", kNumRows}}, .variables = {}};
  if (places == Places::kProjected) {
    x.texts = {{"units", "m"}, {"standard_name", "projection_x_coordinate"}};
    y.texts = {{"units", "m"}, {"standard_name", "projection_y_coordinate"}};
    h.texts["grid_mapping"] = "map";
    file.variables.push_back({.name = "map",
                              .type = WrittenType::kInt,
                              .texts = {{"grid_mapping_name", "transverse_mercator"}},
                              .numbers = {{"longitude_of_central_meridian", 4}}});
  }
  if (places == Places::kCurvilinear) {
    x.name = "lon";
    y.name = "lat";
    x.dimensions = y.dimensions = {0, 1};
  }
  file.variables.push_back(x);
  file.variables.push_back(y);
  file.variables.push_back(h);
  return file;
}

struct Counts {
  int read = 0;
  int refused = 0;
  std::string fault = "";  ///< The first answer that is neither.
};

/// Returns what is wrong with the answer to a damaged file; empty: nothing.
std::string FaultOf(const Result<GridRead<DepthGrid>>& read, const std::string& path) {
  if (!read.ok()) {
    return read.error().starts_with(path) && read.error().size() < 900 ? "" : read.error();
  }
  double deepest_m = 0;
  for (double x_m = -250; x_m <= 250; x_m += 50) {
    for (double y_m = -250; y_m <= 250; y_m += 50) {
      const double depth_m = read->grid.DepthAt({x_m, y_m});
      if (!(depth_m >= 0 && depth_m <= 20'000)) return "a depth of " + std::to_string(depth_m);
      deepest_m = std::max(deepest_m, depth_m);
    }
  }
  return deepest_m > 0 ? "" : "land everywhere, and no error";
}

Counts ReadMutants(const std::string& path, const std::string& whole, int num_mutants) {
  std::mt19937_64 generator(32);
  Counts counts;
  for (int i = 0; i < num_mutants; ++i) {
    const std::string mutant = Mutated(whole, kHarm, generator);
    std::ofstream(path, std::ios::binary | std::ios::trunc) << mutant;
    const auto read = ReadFloorGrid(
        {.style = "grid", .grid = path, .grid_gap_depth_m = i % 2 == 0 ? -1.0 : 0.0},
        {.folder = "", .origin_lat_deg = kOrigin.lat_deg, .origin_lon_deg = kOrigin.lon_deg});
    ++(read.ok() ? counts.read : counts.refused);
    const std::string fault = FaultOf(read, path);
    if (!fault.empty() && counts.fault.empty()) counts.fault = std::to_string(i) + ": " + fault;
  }
  return counts;
}

void ExpectErrorsOrFloors(const std::string& name, const std::string& whole, int num_mutants) {
  const std::string path =
      testing::TempDir() + "floor_mutations_test_" + std::to_string(getpid()) + name;
  EXPECT_TRUE(LastsWithin(kMax_bytes, [&] {
    const Counts counts = ReadMutants(path, whole, num_mutants);
    std::fprintf(stderr, "%s: %d read, %d refused %s\n", name.c_str(), counts.read, counts.refused,
                 counts.fault.c_str());
    return counts.fault.empty() && counts.read > num_mutants / 50 &&
           counts.refused > num_mutants / 20;
  })) << "a crash, more than 512 MB, or an answer that is shown above";
  std::filesystem::remove(path);
}

void ExpectErrorsOrFloors(const std::string& name, Places places, NetcdfForm form) {
  const std::string path =
      testing::TempDir() + "floor_mutations_test_" + std::to_string(getpid()) + "_whole" + name;
  WriteNetcdf(path, form, FloorOf(places));
  std::ifstream in(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  std::filesystem::remove(path);
  // A process for each, some 10 ms: SHOAL_MUTANTS=5000 asks for as many as of the other forms.
  const char* asked = std::getenv("SHOAL_MUTANTS");
  ExpectErrorsOrFloors(name, whole, asked == nullptr ? 150 : std::max(1, std::atoi(asked)));
}

TEST(MutatedFloor, OfEsriAsciiIsRefusedOrHasDepths) {
  ExpectErrorsOrFloors("bay.asc", EsriText(), 5000);
}

TEST(MutatedFloor, OfDegreesIsRefusedOrHasDepths) {
  ExpectErrorsOrFloors("degrees.nc", Places::kDegrees, NetcdfForm::kClassic);
}

TEST(MutatedFloor, OfAProjectedMapIsRefusedOrHasDepths) {
  ExpectErrorsOrFloors("projected.nc", Places::kProjected, NetcdfForm::kClassic);
}

TEST(MutatedFloor, OfACurvilinearGridIsRefusedOrHasDepths) {
  ExpectErrorsOrFloors("curvilinear.nc", Places::kCurvilinear, NetcdfForm::kClassic);
}

TEST(MutatedFloor, OfHdf5IsRefusedOrHasDepths) {
  ExpectErrorsOrFloors("hdf5.nc", Places::kDegrees, NetcdfForm::kHdf5);
}

}  // namespace shoal::floor_mutations_test
