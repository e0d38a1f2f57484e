#include "lib/tools/mcap/proto_message.h"

#include <algorithm>

#include "lib/bus/record/valid_utf8.h"
#include "lib/tools/mcap/proto_schema.h"
#include "lib/tools/mcap/proto_wire.h"

namespace shoal {

namespace {

bool IsAscii(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c & 0x80) == 0; });
}

void AppendTextField(uint32_t field, std::string_view text, std::string* out) {
  if (IsAscii(text)) {
    AppendProtoBytes(field, text, out);
  } else {
    AppendProtoBytes(field, ValidUtf8(text), out);
  }
}

/// Appends an element of an array of numbers.
void AppendPacked(Primitive primitive, const Scalar& value, std::string* out) {
  switch (primitive) {
    case Primitive::kDouble:
      return AppendLittleEndian(std::get<double>(value), out);
    case Primitive::kFloat:
      return AppendLittleEndian(std::get<float>(value), out);
    case Primitive::kBoolean:
      return out->push_back(std::get<bool>(value) ? 1 : 0);
    case Primitive::kByte:
      return out->push_back(static_cast<char>(std::get<int64_t>(value)));
    default:
      return AppendVarint(ZigZag(std::get<int64_t>(value)), out);
  }
}

/// Appends a member that is not an array.
void AppendSingle(Primitive primitive, uint32_t field, const Scalar& value, std::string* out) {
  switch (primitive) {
    case Primitive::kDouble:
      return AppendProtoDouble(field, std::get<double>(value), out);
    case Primitive::kFloat:
      if (std::bit_cast<uint32_t>(std::get<float>(value)) == 0) return;
      AppendProtoTag(field, ProtoWireType::kFixed32, out);
      return AppendLittleEndian(std::get<float>(value), out);
    case Primitive::kBoolean:
      return AppendProtoVarint(field, std::get<bool>(value) ? 1 : 0, out);
    case Primitive::kByte:
      return AppendProtoVarint(field, static_cast<uint64_t>(std::get<int64_t>(value)), out);
    case Primitive::kString:
      if (std::get<std::string_view>(value).empty()) return;
      return AppendTextField(field, std::get<std::string_view>(value), out);
    default:
      return AppendProtoVarint(field, ZigZag(std::get<int64_t>(value)), out);
  }
}

}  // namespace

void ProtoEncoder::Append(const StructType& type, std::span<const uint8_t> message,
                          std::string* out) {
  out_ = out;
  frames_.clear();
  const auto fault = Walk(schema_, type, message, this);
  SHOAL_CHECK(!fault, "a message that is encoded again decodes (FindWireFault() finds none)");
}

void ProtoEncoder::StructBegin(const StructType& type) {
  size_t begin = out_->size();
  if (!frames_.empty()) {
    AppendProtoTag(frames_.back().field, ProtoWireType::kLength, out_);
    begin = BeginProtoLength(out_);
  }
  frames_.push_back({.type = &type, .begin = begin});
}

void ProtoEncoder::StructEnd() {
  if (frames_.size() > 1) EndProtoLength(frames_.back().begin, out_);
  frames_.pop_back();
}

void ProtoEncoder::MemberBegin(const Member& member) {
  Frame& frame = frames_.back();
  frame.member = &member;
  frame.field = ProtoFieldNumber(static_cast<size_t>(&member - frame.type->members.data()));
  frame.array_depth = 0;
}

void ProtoEncoder::ArrayBegin(int64_t /*size*/) {
  Frame& frame = frames_.back();
  if (frame.array_depth++ > 0 || !IsPacked(*frame.member)) return;
  frame.packed_tag = out_->size();
  AppendProtoTag(frame.field, ProtoWireType::kLength, out_);
  frame.packed_begin = BeginProtoLength(out_);
}

void ProtoEncoder::ArrayEnd() {
  Frame& frame = frames_.back();
  if (--frame.array_depth > 0 || !IsPacked(*frame.member)) return;
  if (out_->size() == frame.packed_begin) {
    out_->resize(frame.packed_tag);
  } else {
    EndProtoLength(frame.packed_begin, out_);
  }
}

void ProtoEncoder::Value(const Scalar& value) {
  const Frame& frame = frames_.back();
  const Primitive primitive = *frame.member->primitive;
  if (frame.array_depth == 0) return AppendSingle(primitive, frame.field, value, out_);
  if (primitive == Primitive::kString) {
    return AppendTextField(frame.field, std::get<std::string_view>(value), out_);
  }
  AppendPacked(primitive, value, out_);
}

}  // namespace shoal
