#include "lib/mission/netcdf/netcdf_header.h"

#include <algorithm>
#include <limits>

#include "lib/base/text/blanks.h"

namespace shoal {

std::string_view NetcdfVariable::TextOf(std::string_view wanted) const {
  const auto found = std::ranges::find(attributes, wanted, &NetcdfAttribute::name);
  return found == attributes.end() ? std::string_view() : Trimmed(found->text);
}

const std::vector<double>& NetcdfVariable::NumbersOf(std::string_view wanted) const {
  static const std::vector<double> none;
  const auto found = std::ranges::find(attributes, wanted, &NetcdfAttribute::name);
  return found == attributes.end() ? none : found->numbers;
}

NetcdfType NetcdfVariable::TypeOf(std::string_view wanted) const {
  const auto found = std::ranges::find(attributes, wanted, &NetcdfAttribute::name);
  return found == attributes.end() ? NetcdfType::kOther : found->type;
}

const NetcdfVariable* NetcdfHeader::Find(std::string_view wanted) const {
  const auto found = std::ranges::find(variables, wanted, &NetcdfVariable::name);
  return found == variables.end() ? nullptr : &*found;
}

uint64_t NetcdfHeader::NumValues(const NetcdfVariable& variable) const {
  uint64_t count = 1;
  for (const uint32_t dimension : variable.dimensions) {
    const uint64_t length = dimensions[dimension].length;
    if (length != 0 && count > std::numeric_limits<uint64_t>::max() / length) {
      return std::numeric_limits<uint64_t>::max();
    }
    count *= length;
  }
  return count;
}

}  // namespace shoal
