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

bool IsInteger(NetcdfType type) {
  return type != NetcdfType::kFloat && type != NetcdfType::kDouble && type != NetcdfType::kOther;
}

/// Returns what is added to negative numbers.
double UnsignedShift(const NetcdfVariable& variable) {
  if (LowerCase(variable.TextOf("_Unsigned")) != "true") return 0;
  return variable.type == NetcdfType::kByte    ? 256
         : variable.type == NetcdfType::kShort ? 65'536
         : variable.type == NetcdfType::kInt   ? 4'294'967'296
                                               : 0;
}

/// What counts as data. NaN is beyond each range.
struct ValueRange {
  double least = -kInfinity;
  double most = kInfinity;

  bool Has(double value) const { return value >= least && value <= most; }
};

struct ValueRule {
  std::vector<double> missing;
  ValueRange stored = {};
  ValueRange unpacked = {};
};

/// Returns which range of the rule the bounds of an attribute belong to: they are numbers as they
/// are in the file, unless these are packed integers and the attribute is of the type that they
/// are unpacked to.
ValueRange& RangeFor(const NetcdfVariable& variable, const char* bound, ValueRule& rule) {
  const bool is_packed = IsInteger(variable.type) && !(variable.NumbersOf("scale_factor").empty() &&
                                                       variable.NumbersOf("add_offset").empty());
  const NetcdfType type = variable.TypeOf(bound);
  const bool is_real = type == NetcdfType::kFloat || type == NetcdfType::kDouble;
  return is_packed && is_real ? rule.unpacked : rule.stored;
}

ValueRule RuleOf(const NetcdfVariable& variable, double shift) {
  ValueRule rule{.missing = variable.NumbersOf("missing_value")};
  const std::vector<double>& fill = variable.NumbersOf("_FillValue");
  rule.missing.insert(rule.missing.end(), fill.begin(), fill.end());
  const std::optional<double> unwritten = DefaultFill(variable.type);
  if (fill.empty() && unwritten) rule.missing.push_back(*unwritten);
  // The least short is the mark of many programs, and mostly it is data of none.
  if (fill.empty() && variable.type == NetcdfType::kShort && shift == 0) {
    rule.missing.push_back(-32'768);
  }
  if (variable.type == NetcdfType::kFloat) {
    for (double& value : rule.missing) value = static_cast<float>(value);
  }
  const auto bound = [&](double number, const ValueRange& range) {
    return number < 0 && &range == &rule.stored ? number + shift : number;
  };
  if (const std::vector<double>& both = variable.NumbersOf("valid_range"); both.size() == 2) {
    ValueRange& range = RangeFor(variable, "valid_range", rule);
    range = {.least = bound(both[0], range), .most = bound(both[1], range)};
  }
  if (const std::vector<double>& least = variable.NumbersOf("valid_min"); !least.empty()) {
    ValueRange& range = RangeFor(variable, "valid_min", rule);
    range.least = bound(least[0], range);
  }
  if (const std::vector<double>& most = variable.NumbersOf("valid_max"); !most.empty()) {
    ValueRange& range = RangeFor(variable, "valid_max", rule);
    range.most = bound(most[0], range);
  }
  return rule;
}

}  // namespace

std::vector<double> Unpacked(const NetcdfVariable& variable, std::vector<double> values) {
  const double shift = UnsignedShift(variable);
  const ValueRule rule = RuleOf(variable, shift);
  const double scale = FirstOf(variable, "scale_factor", 1);
  const double offset = FirstOf(variable, "add_offset", 0);
  for (double& value : values) {
    const double stored = value;
    if (value < 0) value += shift;
    const bool is_missing = std::ranges::find(rule.missing, stored) != rule.missing.end() ||
                            std::ranges::find(rule.missing, value) != rule.missing.end();
    const bool is_stored = !is_missing && rule.stored.Has(value);
    value = value * scale + offset;
    if (!is_stored || !rule.unpacked.Has(value)) value = std::numeric_limits<double>::quiet_NaN();
  }
  return values;
}

}  // namespace shoal
