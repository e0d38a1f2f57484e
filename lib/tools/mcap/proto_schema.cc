#include "lib/tools/mcap/proto_schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "lib/tools/mcap/proto_wire.h"

namespace shoal {

namespace {

// Numbers of fields in google/protobuf/descriptor.proto.
constexpr uint32_t kOptional = 1;
constexpr uint32_t kRepeated = 3;

void AppendField(const ProtoField& field, std::string* out) {
  AppendProtoText(1, field.name, out);
  AppendProtoVarint(3, field.number, out);
  AppendProtoVarint(4, field.is_repeated ? kRepeated : kOptional, out);
  AppendProtoVarint(5, static_cast<uint32_t>(field.type), out);
  AppendProtoText(6, field.type_name, out);
}

void AppendEnum(const ProtoEnum& type, std::string* out) {
  AppendProtoText(1, type.name, out);
  for (size_t i = 0; i < type.values.size(); ++i) {
    AppendProtoMessage(2, out, [&] {
      AppendProtoText(1, type.values[i], out);
      // Written although it may be 0: descriptor.proto is proto2, where 0 is not left out.
      AppendProtoTag(2, ProtoWireType::kVarint, out);
      AppendVarint(i, out);
    });
  }
}

void AppendMessageType(const ProtoMessageType& type, std::string* out) {
  AppendProtoText(1, type.name, out);
  for (const ProtoField& field : type.fields) {
    AppendProtoMessage(2, out, [&] { AppendField(field, out); });
  }
  for (const ProtoEnum& each : type.enums) {
    AppendProtoMessage(4, out, [&] { AppendEnum(each, out); });
  }
}

void AppendFile(const ProtoFile& file, std::string* out) {
  AppendProtoText(1, file.name, out);
  AppendProtoText(2, file.package, out);
  for (const std::string& import : file.imports) AppendProtoText(3, import, out);
  for (const ProtoMessageType& type : file.messages) {
    AppendProtoMessage(4, out, [&] { AppendMessageType(type, out); });
  }
  AppendProtoText(12, "proto3", out);
}

ProtoType ProtoTypeOf(Primitive primitive) {
  switch (primitive) {
    case Primitive::kInt8:
    case Primitive::kInt16:
    case Primitive::kInt32:
      return ProtoType::kSint32;
    case Primitive::kInt64:
      return ProtoType::kSint64;
    case Primitive::kByte:
      return ProtoType::kUint32;
    case Primitive::kFloat:
      return ProtoType::kFloat;
    case Primitive::kDouble:
      return ProtoType::kDouble;
    case Primitive::kString:
      return ProtoType::kString;
    case Primitive::kBoolean:
      return ProtoType::kBool;
  }
  SHOAL_CHECK(false, "every primitive has a type of protobuf");
}

ProtoMessageType MessageTypeOf(const Schema& schema, const StructType& type) {
  ProtoMessageType message{.name = type.name, .fields = {}};
  for (size_t i = 0; i < type.members.size(); ++i) {
    const Member& member = type.members[i];
    ProtoField field{.name = member.name, .number = ProtoFieldNumber(i)};
    field.is_repeated = !member.dimensions.empty();
    if (member.primitive) {
      field.type = ProtoTypeOf(*member.primitive);
    } else {
      field.type = ProtoType::kMessage;
      field.type_name = "." + schema.types()[member.struct_index].FullName();
    }
    if (member.primitive == Primitive::kByte && field.is_repeated) {
      field.type = ProtoType::kBytes;
      field.is_repeated = false;
    }
    message.fields.push_back(std::move(field));
  }
  return message;
}

std::string FileNameOf(const std::string& package) {
  if (package.empty()) return "no_package.proto";
  std::string name = package + ".proto";
  std::replace(name.begin(), name.end() - 6, '.', '/');
  return name;
}

/// Sorts the types that one needs into files.
class FileMaker {
 public:
  explicit FileMaker(const Schema& schema) : schema_(schema) {}

  Result<std::vector<ProtoFile>> Make(const StructType& type) {
    AddType(type);
    if (!AddPackage(type.package)) {
      return Error{
          fmt::format("{}: the types of package '{}' and those of another one hold each "
                      "other, which protobuf cannot; put them into one package",
                      type.FullName(), type.package)};
    }
    return std::move(files_);
  }

 private:
  struct Package {
    std::vector<ProtoMessageType> messages = {};
    std::set<std::string> needs = {};
    enum class State { kNew, kOpen, kDone } state = State::kNew;
  };

  void AddType(const StructType& type) {
    std::vector<const StructType*> open = {&type};
    while (!open.empty()) {
      const StructType& next = *open.back();
      open.pop_back();
      if (!seen_.insert(next.FullName()).second) continue;
      Package& package = packages_[next.package];
      package.messages.push_back(MessageTypeOf(schema_, next));
      for (const Member& member : next.members) {
        if (member.primitive) continue;
        const StructType& inner = schema_.types()[member.struct_index];
        if (inner.package != next.package) package.needs.insert(inner.package);
        open.push_back(&inner);
      }
    }
  }

  /// Adds a package's file behind those that it imports; false where it needs itself.
  bool AddPackage(const std::string& name) {
    Package& package = packages_.at(name);
    if (package.state != Package::State::kNew) return package.state == Package::State::kDone;
    package.state = Package::State::kOpen;
    ProtoFile file{.name = FileNameOf(name), .package = name};
    for (const std::string& needed : package.needs) {
      if (!AddPackage(needed)) return false;
      file.imports.push_back(FileNameOf(needed));
    }
    std::ranges::sort(package.messages, {}, &ProtoMessageType::name);
    file.messages = std::move(package.messages);
    files_.push_back(std::move(file));
    package.state = Package::State::kDone;
    return true;
  }

  const Schema& schema_;
  std::set<std::string> seen_;
  std::map<std::string, Package> packages_;
  std::vector<ProtoFile> files_;
};

}  // namespace

std::string EncodeFileDescriptorSet(const std::vector<ProtoFile>& files) {
  std::string set;
  for (const ProtoFile& file : files) AppendProtoMessage(1, &set, [&] { AppendFile(file, &set); });
  return set;
}

uint32_t ProtoFieldNumber(size_t index) {
  constexpr size_t kReservedBegin = 19'000;  // [19000, 19999] belong to protobuf itself
  constexpr size_t kNumReserved = 1'000;
  const size_t number = index + 1;
  return static_cast<uint32_t>(number < kReservedBegin ? number : number + kNumReserved);
}

Result<std::vector<ProtoFile>> ProtoFilesOf(const Schema& schema, const StructType& type) {
  return FileMaker(schema).Make(type);
}

}  // namespace shoal
