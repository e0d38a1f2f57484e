// For tests: writes NetCDF files with libnetcdf.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace shoal {

enum class NetcdfForm { kClassic, kHdf5 };
enum class WrittenType { kByte, kChar, kShort, kInt, kFloat, kDouble };

struct WrittenVariable {
  std::string name;
  WrittenType type = WrittenType::kFloat;
  std::vector<int> dimensions = {};  ///< By their numbers.
  std::vector<double> values = {};   ///< Empty: none is written.
  std::map<std::string, std::string> texts = {};
  std::map<std::string, double> numbers = {};  ///< _FillValue has the variable's type.
};

struct WrittenNetcdf {
  std::vector<std::pair<std::string, size_t>> dimensions;
  std::vector<WrittenVariable> variables;
};

/// Throws std::runtime_error where libnetcdf cannot.
void WriteNetcdf(const std::string& path, NetcdfForm form, const WrittenNetcdf& content);

}  // namespace shoal
