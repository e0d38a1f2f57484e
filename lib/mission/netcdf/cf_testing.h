// For tests: what a NetCDF file holds, without a file.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lib/mission/netcdf/cf_field.h"

namespace shoal {

using TextAttributes = std::map<std::string, std::string>;
using NumberAttributes = std::map<std::string, std::vector<double>>;

struct FakeNetcdf {
  NetcdfHeader header;
  std::map<std::string, std::vector<double>> values;

  FakeNetcdf& Dimension(const std::string& name, uint64_t length) {
    header.dimensions.push_back({.name = name, .length = length});
    return *this;
  }
  FakeNetcdf& Variable(const std::string& name, const std::vector<std::string>& dimensions,
                       std::vector<double> numbers, const TextAttributes& texts = {},
                       const NumberAttributes& attributes = {},
                       NetcdfType type = NetcdfType::kFloat) {
    NetcdfVariable variable{.name = name, .type = type};
    for (const std::string& each : dimensions) {
      const auto found = std::ranges::find(header.dimensions, each, &NetcdfDimension::name);
      variable.dimensions.push_back(static_cast<uint32_t>(found - header.dimensions.begin()));
    }
    for (const auto& [key, text] : texts)
      variable.attributes.push_back({.name = key, .text = text});
    for (const auto& [key, list] : attributes) {
      variable.attributes.push_back({.name = key, .numbers = list});
    }
    header.variables.push_back(std::move(variable));
    values[name] = std::move(numbers);
    return *this;
  }
  /// A dimension and its coordinates.
  FakeNetcdf& Axis(const std::string& name, const std::vector<double>& points,
                   const TextAttributes& texts) {
    return Dimension(name, points.size()).Variable(name, {name}, points, texts);
  }

  /// @pre this outlives what is returned
  CfSource source() const {
    return {.name = "bay.nc", .header = header, .read = [this](const NetcdfVariable& variable) {
              return Result<std::vector<double>>(values.at(variable.name));
            }};
  }
};

inline const TextAttributes kNorthDegrees = {{"units", "degrees_north"}};
inline const TextAttributes kEastDegrees = {{"units", "degrees_east"}};

}  // namespace shoal
