// LCM messages in the encoding of Protocol Buffers, by the types of lib/tools/mcap/proto_schema.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "lib/base/schema/walk.h"

namespace shoal {

/// Encodes messages one after the other; its memory is used again.
class ProtoEncoder : private Visitor {
 public:
  explicit ProtoEncoder(const Schema& schema) : schema_(schema) {}

  /// Appends an LCM message in protobuf's encoding. Text that is not UTF-8 has U+FFFD for each
  /// wrong byte: protobuf's readers refuse it.
  /// @pre FindWireFault() finds none, and type is one of schema.types().
  void Append(const StructType& type, std::span<const uint8_t> message, std::string* out);

 private:
  /// A struct that is open, and the member of it that began last.
  struct Frame {
    const StructType* type = nullptr;
    size_t begin = 0;  ///< Where its bytes begin in *out_; the outermost has no length before.
    const Member* member = nullptr;
    uint32_t field = 0;
    int array_depth = 0;
    size_t packed_begin = 0;  ///< Where the elements of an array of numbers begin.
    size_t packed_tag = 0;    ///< Where the tag before them begins.
  };

  void StructBegin(const StructType& type) override;
  void StructEnd() override;
  void MemberBegin(const Member& member) override;
  void ArrayBegin(int64_t size) override;
  void ArrayEnd() override;
  void Value(const Scalar& value) override;

  static bool IsPacked(const Member& member) {
    return member.primitive && *member.primitive != Primitive::kString;
  }

  const Schema& schema_;
  std::string* out_ = nullptr;
  std::vector<Frame> frames_;  ///< Outermost first.
};

}  // namespace shoal
