#include "lib/bus/record/extra_fields.h"

#include <algorithm>
#include <set>

#include "lib/bus/bus/seal.h"
#include "lib/bus/record/log_source.h"
#include "lib/bus/record/message_types.h"
#include "lib/bus/record/valid_utf8.h"

namespace shoal {

namespace {

/// Gathers the texts of one member, which hold keys and values in turns.
class ExtraCollector : public Visitor {
 public:
  explicit ExtraCollector(const Member& extra) : extra_(extra) {}

  void StructBegin(const StructType& /*type*/) override { ++depth_; }
  void StructEnd() override { --depth_; }
  void MemberBegin(const Member& member) override {
    if (depth_ == 1) is_open_ = &member == &extra_;
  }
  void Value(const Scalar& value) override {
    if (!is_open_ || depth_ != 2) return;
    const std::string_view text = std::get<std::string_view>(value);
    if (is_key_next_) {
      fields_.emplace_back(text, "");
    } else {
      fields_.back().second = text;
    }
    is_key_next_ = !is_key_next_;
  }

  ExtraFields& fields() { return fields_; }

 private:
  const Member& extra_;
  ExtraFields fields_;
  int depth_ = 0;
  bool is_open_ = false;
  bool is_key_next_ = true;
};

bool IsKeyAndValue(const StructType& type) {
  const auto is_text = [](const Member& member) {
    return member.primitive == Primitive::kString && member.dimensions.empty();
  };
  return type.package == "shoal" && type.name == "key_value_t" && type.members.size() == 2 &&
         std::all_of(type.members.begin(), type.members.end(), is_text);
}

void CountKeys(const ExtraFields& fields, ExtraKeys* keys) {
  ++keys->num_all_messages;
  std::set<std::string_view> seen;
  for (const auto& [key, value] : fields) {
    if (!seen.insert(key).second) continue;
    const std::string text = ValidUtf8(key);
    const auto it = std::ranges::find(keys->keys, text);
    if (it != keys->keys.end()) {
      ++keys->num_messages[static_cast<size_t>(it - keys->keys.begin())];
    } else if (keys->keys.size() < ExtraKeys::kMaxKeys) {
      keys->keys.push_back(text);
      keys->num_messages.push_back(1);
    }
  }
}

}  // namespace

const Member* ExtraMember(const Schema& schema, const StructType& type) {
  for (const Member& member : type.members) {
    if (!member.primitive && member.dimensions.size() == 1 &&
        IsKeyAndValue(schema.types()[member.struct_index])) {
      return &member;
    }
  }
  return nullptr;
}

ExtraFields ExtraFieldsOf(const Schema& schema, const StructType& type,
                          std::span<const uint8_t> message) {
  const Member* extra = ExtraMember(schema, type);
  if (extra == nullptr) return {};
  ExtraCollector collector(*extra);
  const auto fault = Walk(schema, type, message, &collector);
  SHOAL_CHECK(!fault, "a message whose fields are read decodes (FindWireFault() finds none)");
  return std::move(collector.fields());
}

std::vector<std::string> ExtraKeys::Common() const {
  std::vector<std::string> common;
  for (size_t i = 0; i < keys.size(); ++i) {
    if (num_messages[i] == num_all_messages) common.push_back(keys[i]);
  }
  return common;
}

ExtraKeyTable::ExtraKeyTable(const Schema& schema, const LogSelection& selection,
                             LogReader reader) {
  std::set<int64_t> fingerprints;
  for (const StructType& type : schema.types()) {
    if (ExtraMember(schema, type) != nullptr) fingerprints.insert(type.fingerprint);
  }
  while (const auto event = reader.Next()) {
    const auto fingerprint = FingerprintOf(Unseal(event->data).message);
    if (!fingerprint || !fingerprints.contains(*fingerprint)) continue;
    if (!IsSelected(selection, *event)) continue;
    const RecognisedMessage message = Recognise(schema, event->data);
    if (!message.IsDecodable()) continue;
    const ExtraFields fields = ExtraFieldsOf(schema, *message.type, message.data);
    CountKeys(fields, &keys_[{std::string(event->channel), message.type}]);
  }
}

const ExtraKeys& ExtraKeyTable::Of(std::string_view channel, const StructType& type) const {
  static const ExtraKeys kNoKeys;
  const auto it = keys_.find({std::string(channel), &type});
  return it == keys_.end() ? kNoKeys : it->second;
}

}  // namespace shoal
