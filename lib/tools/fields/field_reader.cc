#include "lib/tools/fields/field_reader.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>

#include "lib/base/schema/walk.h"
#include "lib/bus/bus/big_endian.h"
#include "lib/bus/bus/fate_columns.h"
#include "lib/bus/bus/pulse_columns.h"
#include "lib/bus/record/message_types.h"
#include "lib/mission/toml/suggest.h"

namespace shoal {

namespace {

constexpr size_t kFingerprint_bytes = 8;

/// Waits for the value whose way is `parts`.
class PartFinder : public Visitor {
 public:
  explicit PartFinder(std::span<const FieldPart> parts) : parts_(parts) {}

  void StructBegin(const StructType&) override {
    BeginElement();
    frames_.emplace_back();
  }
  void StructEnd() override { frames_.pop_back(); }
  void MemberBegin(const Member& member) override {
    frames_.back().member = &member;
    frames_.back().elements.clear();
  }
  void ArrayBegin(int64_t) override {
    BeginElement();
    frames_.back().elements.push_back(-1);
  }
  void ArrayEnd() override { frames_.back().elements.pop_back(); }
  void Value(const Scalar& value) override {
    BeginElement();
    if (found || frames_.size() != parts_.size()) return;
    for (size_t i = 0; i < parts_.size(); ++i) {
      if (frames_[i].member != parts_[i].member || frames_[i].elements != parts_[i].elements) {
        return;
      }
    }
    std::visit(
        [this](const auto& number) {
          if constexpr (requires { static_cast<double>(number); }) {
            found = static_cast<double>(number);
          }
        },
        value);
  }

  std::optional<double> found;

 private:
  void BeginElement() {
    if (!frames_.empty() && !frames_.back().elements.empty()) ++frames_.back().elements.back();
  }

  std::span<const FieldPart> parts_;
  std::vector<FieldPart> frames_;  ///< Where the walk is.
};

/// Returns where the member is in each message of a type of one size.
size_t OffsetIn(const StructType& type, const Member& wanted) {
  size_t offset = kFingerprint_bytes;
  for (const Member& member : type.members) {
    if (&member == &wanted) break;
    int64_t size = member.min_wire_size;
    for (const Dimension& dimension : member.dimensions) size *= dimension.fixed_size;
    offset += static_cast<size_t>(size);
  }
  return offset;
}

std::string UnknownMember(const StructType& type, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Member& member : type.members) names.push_back(member.name);
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) hint = "; it has " + Joined(names);
  return fmt::format("{} has no field {}{}", type.name, Quoted(name), hint);
}

/// Takes "[2]" off the front of `text`.
std::optional<int64_t> TakeElement(std::string_view* text) {
  if (!text->starts_with('[')) return std::nullopt;
  int64_t element = -1;
  const auto [end, fault] = std::from_chars(text->data() + 1, text->data() + text->size(), element);
  if (fault != std::errc() || end == text->data() + text->size() || *end != ']' || element < 0) {
    return std::nullopt;
  }
  text->remove_prefix(static_cast<size_t>(end + 1 - text->data()));
  return element;
}

}  // namespace

const Schema& ShoalTypes() {
  static const Schema schema = [] {
    Result<Schema> types = LoadMessageTypes({});
    SHOAL_CHECK(types.ok(), "shoal's own types are a schema");
    return std::move(*types);
  }();
  return schema;
}

Result<FieldReader> FieldReader::Find(const Schema& schema, std::string_view type,
                                      std::string_view path) {
  // Fates and pulses are named as the list has them, whichever form they are published in.
  if (type == "comms_fate_columns_t") type = "comms_fates_t";
  if (type == "comms_pulse_columns_t") type = "comms_pulses_t";
  const StructType* level = schema.FindByName(fmt::format("shoal.{}", type));
  if (level == nullptr) return Error{fmt::format("there is no message type {}", Quoted(type))};
  FieldReader reader(schema, *level);
  std::string_view rest = path;
  while (true) {
    const std::string_view name = rest.substr(0, rest.find_first_of(".["));
    FieldPart part;
    for (const Member& member : level->members) {
      if (member.name == name) part.member = &member;
    }
    if (part.member == nullptr) return Error{UnknownMember(*level, name)};
    rest.remove_prefix(name.size());
    while (const std::optional<int64_t> element = TakeElement(&rest)) {
      part.elements.push_back(*element);
    }
    const Member& member = *part.member;
    if (part.elements.size() != member.dimensions.size()) {
      std::string example(name);
      for (size_t i = 0; i < member.dimensions.size(); ++i) example += "[0]";
      return Error{fmt::format("{} of {} is {}: write {}", name, level->name,
                               member.dimensions.empty() ? "not an array" : "an array", example)};
    }
    for (size_t i = 0; i < part.elements.size(); ++i) {
      const Dimension& dimension = member.dimensions[i];
      if (dimension.is_variable() || part.elements[i] < dimension.fixed_size) continue;
      return Error{fmt::format("{} of {} has {} elements: [0] to [{}]", name, level->name,
                               dimension.fixed_size, dimension.fixed_size - 1)};
    }
    reader.parts_.push_back(std::move(part));
    if (member.primitive) {
      if (!rest.empty()) {
        return Error{fmt::format("{} of {} is {}: nothing can follow it, not {}", name, level->name,
                                 member.type_name, Quoted(rest))};
      }
      if (*member.primitive == Primitive::kString) {
        return Error{fmt::format("{} of {} is text, no number", name, level->name)};
      }
      break;
    }
    level = &schema.types()[member.struct_index];
    if (!rest.starts_with('.')) {
      return Error{fmt::format("{} is a {}, no number: write {}.{}", path, level->name, path,
                               level->members.empty() ? "..." : level->members.front().name)};
    }
    rest.remove_prefix(1);
  }
  const FieldPart& first = reader.parts_.front();
  const bool is_plain_double = first.member->primitive == Primitive::kDouble &&
                               reader.parts_.size() == 1 && first.elements.empty();
  if (reader.type_->has_fixed_size && is_plain_double) {
    reader.offset_ = OffsetIn(*reader.type_, *first.member);
  }
  return reader;
}

std::optional<double> FieldReader::Read(std::span<const uint8_t> message) const {
  if (type_->fingerprint == comms_fates_t::getHash()) {
    thread_local Bytes storage;
    message = WithFatesAsList(message, &storage);
  } else if (type_->fingerprint == comms_pulses_t::getHash()) {
    thread_local Bytes storage;
    message = WithPulsesAsList(message, &storage);
  }
  if (!offset_) {
    PartFinder finder(parts_);
    if (Walk(*schema_, *type_, message, &finder)) return std::nullopt;
    return finder.found;
  }
  const size_t whole_size = kFingerprint_bytes + static_cast<size_t>(type_->min_wire_size);
  if (message.size() != whole_size || FingerprintOf(message) != type_->fingerprint) {
    return std::nullopt;
  }
  return std::bit_cast<double>(ReadBigEndian(message.subspan(*offset_, sizeof(double))));
}

}  // namespace shoal
