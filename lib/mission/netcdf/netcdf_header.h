// What a NetCDF file holds, without its values.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace shoal {

struct NetcdfDimension {
  std::string name;
  uint64_t length = 0;
};

/// The external types that the default fill values depend on ("NetCDF Users Guide", fill values).
enum class NetcdfType : uint8_t {
  kOther,  ///< Text, or a type that was defined in the file: no numbers.
  kByte,   ///< No value stands for missing data unless an attribute names it. Signed or not.
  kShort,
  kInt,
  kInt64,
  kUnsignedShort,
  kUnsignedInt,
  kUnsignedInt64,
  kFloat,
  kDouble,
};

struct NetcdfAttribute {
  std::string name;
  std::string text = {};                 ///< Empty where it holds numbers.
  std::vector<double> numbers = {};      ///< Empty where it holds a text.
  NetcdfType type = NetcdfType::kOther;  ///< Of its numbers.
};

struct NetcdfVariable {
  std::string name;
  NetcdfType type = NetcdfType::kOther;
  std::vector<uint32_t> dimensions = {};  ///< Indices into NetcdfHeader::dimensions.
  std::vector<NetcdfAttribute> attributes = {};

  /// Returns a text of the variable without blanks around it; empty: it has none of that name.
  [[nodiscard]] std::string_view TextOf(std::string_view name) const;
  /// Returns the numbers of an attribute; empty: it has none of that name.
  [[nodiscard]] const std::vector<double>& NumbersOf(std::string_view name) const;
  /// Returns the type of an attribute's numbers; kOther: it has none.
  [[nodiscard]] NetcdfType TypeOf(std::string_view name) const;
};

/// Of the file's root group.
struct NetcdfHeader {
  std::vector<NetcdfDimension> dimensions;
  std::vector<NetcdfVariable> variables;

  /// Null: there is none of that name.
  [[nodiscard]] const NetcdfVariable* Find(std::string_view name) const;
  /// Returns how many values a variable has. @pre its dimensions are indices into `dimensions`
  [[nodiscard]] uint64_t NumValues(const NetcdfVariable& variable) const;
};

}  // namespace shoal
