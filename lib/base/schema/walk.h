// Reads an encoded LCM message by its schema, from untrusted bytes.
//
//   if (auto fault = FindWireFault(schema, type, bytes)) Drop(*fault);
//   Walk(schema, type, bytes, &visitor);
//
// Never reads outside `bytes`, and allocates no memory by a length in the message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "lib/base/schema/schema.h"

namespace shoal {

/// A primitive's value; int8_t to int64_t and byte are int64_t here. Text points into the message.
using Scalar = std::variant<bool, int64_t, float, double, std::string_view>;

/// What a visitor gets of a message, in wire order. A struct is StructBegin, for each member
/// MemberBegin and its value, StructEnd. The value of an array is ArrayBegin, its elements,
/// ArrayEnd, once per dimension.
class Visitor {
 public:
  virtual ~Visitor() = default;
  virtual void StructBegin(const StructType& /*type*/) {}
  virtual void StructEnd() {}
  virtual void MemberBegin(const Member& /*member*/) {}
  virtual void ArrayBegin(int64_t /*size*/) {}
  virtual void ArrayEnd() {}
  virtual void Value(const Scalar& /*value*/) {}
};

/// Why bytes are not one whole message of their type.
struct WireFault {
  size_t offset = 0;  ///< Where in the message it was found.
  std::string_view what;
};

/// Returns the fingerprint that a message starts with; nothing where it is shorter.
[[nodiscard]] std::optional<int64_t> FingerprintOf(std::span<const uint8_t> message);

/// Reports to `visitor` what `message` holds: fingerprint and members, of exactly the right length,
/// with strings that end with their only NUL. On a fault the visitor has what came before it.
/// @pre type is one of schema.types().
[[nodiscard]] std::optional<WireFault> Walk(const Schema& schema, const StructType& type,
                                            std::span<const uint8_t> message, Visitor* visitor);

/// As Walk, without a visitor; jumps over what has a fixed size.
[[nodiscard]] std::optional<WireFault> FindWireFault(const Schema& schema, const StructType& type,
                                                     std::span<const uint8_t> message);

}  // namespace shoal
