// Finds one number in encoded messages of one type, by its name.
//
//   const Result<FieldReader> depth = FieldReader::Find(ShoalTypes(), "nav_t", "z_m");
//   if (const auto value = depth->Read(message.data)) ...
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/schema/schema.h"

namespace shoal {

/// Returns the types of shoal's own messages, made once in a process.
const Schema& ShoalTypes();

/// A member on the way to a number, and which element of it.
struct FieldPart {
  const Member* member = nullptr;
  std::vector<int64_t> elements = {};  ///< One for each dimension.
};

class FieldReader {
 public:
  /// Finds "z_m", "contacts[0].x_m" in a type of the package shoal. The error states what does
  /// not exist or is not a number, and what is there. `schema` must outlive this.
  [[nodiscard]] static Result<FieldReader> Find(const Schema& schema, std::string_view type,
                                                std::string_view path);

  /// Returns the number; a boolean is 1 or 0. Nothing where `message` is not one of the type or has
  /// no such element.
  [[nodiscard]] std::optional<double> Read(std::span<const uint8_t> message) const;

 private:
  FieldReader(const Schema& schema, const StructType& type) : schema_(&schema), type_(&type) {}

  const Schema* schema_;
  const StructType* type_;
  std::vector<FieldPart> parts_;
  /// Where the number is in every message, of types of one size.
  std::optional<size_t> offset_;
};

}  // namespace shoal
