#include "lib/mission/netcdf/cf_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "lib/base/text/letters.h"
#include "lib/mission/netcdf/cf_words.h"

namespace shoal {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What a point that was never written holds. Nothing where all numbers of the type are data.
std::optional<double> DefaultFill(NetcdfType type) {
  switch (type) {
    case NetcdfType::kShort:
      return -32'767;
    case NetcdfType::kInt:
      return -2'147'483'647;
    case NetcdfType::kInt64:
      return -9'223'372'036'854'775'806.0;
    case NetcdfType::kUnsignedShort:
      return 65'535;
    case NetcdfType::kUnsignedInt:
      return 4'294'967'295;
    case NetcdfType::kUnsignedInt64:
      return 18'446'744'073'709'551'614.0;
    case NetcdfType::kFloat:
    case NetcdfType::kDouble:
      return 9.9692099683868690e+36;
    case NetcdfType::kByte:
    case NetcdfType::kOther:
      return std::nullopt;
  }
  return std::nullopt;
}

double FirstOf(const NetcdfVariable& variable, const char* name, double otherwise) {
  const std::vector<double>& numbers = variable.NumbersOf(name);
  return numbers.empty() ? otherwise : numbers.front();
}

struct ValueRule {
  std::vector<double> missing;
  double least = -kInfinity;
  double most = kInfinity;
};

ValueRule RuleOf(const NetcdfVariable& variable) {
  ValueRule rule{.missing = variable.NumbersOf("missing_value")};
  const std::vector<double>& fill = variable.NumbersOf("_FillValue");
  rule.missing.insert(rule.missing.end(), fill.begin(), fill.end());
  const std::optional<double> unwritten = DefaultFill(variable.type);
  if (fill.empty() && unwritten) rule.missing.push_back(*unwritten);
  if (variable.type == NetcdfType::kFloat) {
    for (double& value : rule.missing) value = static_cast<float>(value);
  }
  const std::vector<double>& range = variable.NumbersOf("valid_range");
  const bool has_range = range.size() == 2;
  rule.least = FirstOf(variable, "valid_min", has_range ? range[0] : -kInfinity);
  rule.most = FirstOf(variable, "valid_max", has_range ? range[1] : kInfinity);
  return rule;
}

/// Returns what is added to negative numbers.
double UnsignedShift(const NetcdfVariable& variable) {
  if (LowerCase(variable.TextOf("_Unsigned")) != "true") return 0;
  return variable.type == NetcdfType::kByte    ? 256
         : variable.type == NetcdfType::kShort ? 65'536
                                               : 0;
}

}  // namespace

std::vector<double> Unpacked(const NetcdfVariable& variable, std::vector<double> values) {
  const ValueRule rule = RuleOf(variable);
  const double shift = UnsignedShift(variable);
  const double scale = FirstOf(variable, "scale_factor", 1);
  const double offset = FirstOf(variable, "add_offset", 0);
  for (double& value : values) {
    const double stored = value;
    if (value < 0) value += shift;
    const bool is_missing = std::ranges::find(rule.missing, stored) != rule.missing.end() ||
                            std::ranges::find(rule.missing, value) != rule.missing.end();
    // A comparison with NaN is false: it is missing too.
    const bool is_valid = !is_missing && value >= rule.least && value <= rule.most;
    value = is_valid ? value * scale + offset : std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

}  // namespace shoal
