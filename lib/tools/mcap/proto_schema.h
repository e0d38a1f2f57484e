// Descriptions of messages as Protocol Buffers have them: a FileDescriptorSet
// (google/protobuf/descriptor.proto), by which a reader decodes messages that it was not built
// with.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/base/schema/schema.h"

namespace shoal {

/// FieldDescriptorProto.Type, those that are used here.
enum class ProtoType : uint32_t {
  kDouble = 1,
  kFloat = 2,
  kInt64 = 3,
  kInt32 = 5,
  kFixed32 = 7,
  kBool = 8,
  kString = 9,
  kMessage = 11,
  kBytes = 12,
  kUint32 = 13,
  kEnum = 14,
  kSint32 = 17,
  kSint64 = 18,
};

struct ProtoField {
  std::string name;
  uint32_t number = 0;
  ProtoType type = ProtoType::kDouble;
  std::string type_name = {};  ///< Of messages and enums, from the root: ".shoal.key_value_t".
  bool is_repeated = false;
};

struct ProtoEnum {
  std::string name;
  std::vector<std::string> values;  ///< Numbered from 0.
};

struct ProtoMessageType {
  std::string name;
  std::vector<ProtoField> fields;
  std::vector<ProtoEnum> enums = {};
};

/// One .proto file of syntax proto3.
struct ProtoFile {
  std::string name;
  std::string package;
  std::vector<std::string> imports = {};  ///< Names of files that come before this one.
  std::vector<ProtoMessageType> messages = {};
};

/// Returns the encoded FileDescriptorSet.
[[nodiscard]] std::string EncodeFileDescriptorSet(const std::vector<ProtoFile>& files);

/// Returns the number of the field that member `index` of an LCM struct becomes: index + 1, past
/// the numbers that protobuf keeps for itself.
[[nodiscard]] uint32_t ProtoFieldNumber(size_t index);

/// Returns one file for each package that `type` needs, each after those that it imports. Members
/// keep their names and order:
///
///   int8_t int16_t int32_t -> sint32    double -> double   byte    -> uint32
///   int64_t                -> sint64    float  -> float    boolean -> bool
///   string                 -> string    struct -> message  x[n]    -> repeated
///
/// An array of byte is bytes; one of several dimensions is the list of all its elements, the last
/// dimension first to change. An error where two packages need each other: no import can.
/// @pre type is one of schema.types().
[[nodiscard]] Result<std::vector<ProtoFile>> ProtoFilesOf(const Schema& schema,
                                                          const StructType& type);

}  // namespace shoal
