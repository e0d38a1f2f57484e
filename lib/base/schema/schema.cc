#include "lib/base/schema/schema.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shoal {

namespace {

constexpr int64_t kHugeSize = int64_t{1} << 61;       ///< Sizes stop here; no message is that long.
constexpr int64_t kMaxFingerprintVisits = 1'000'000;  ///< Types that nest without end stop here.

constexpr std::array<std::pair<std::string_view, Primitive>, 9> kPrimitives = {{
    {"int8_t", Primitive::kInt8},
    {"int16_t", Primitive::kInt16},
    {"int32_t", Primitive::kInt32},
    {"int64_t", Primitive::kInt64},
    {"byte", Primitive::kByte},
    {"float", Primitive::kFloat},
    {"double", Primitive::kDouble},
    {"string", Primitive::kString},
    {"boolean", Primitive::kBoolean},
}};

int64_t SaturatingAdd(int64_t a, int64_t b) { return std::min(kHugeSize, a + b); }

int64_t SaturatingMultiply(int64_t a, int64_t b) {
  int64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? kHugeSize : std::min(kHugeSize, product);
}

// LCM's hash of a struct's members (lcm-gen 1.3.1), without those of nested structs.
uint64_t Mix(uint64_t hash, uint64_t value) {
  const auto arithmetic_shift = static_cast<uint64_t>(static_cast<int64_t>(hash) >> 55);
  return ((hash << 8) ^ arithmetic_shift) + value;
}

uint64_t MixText(uint64_t hash, std::string_view text) {
  // Lengths and characters are signed chars in lcm-gen.
  hash = Mix(hash, static_cast<uint64_t>(static_cast<int8_t>(text.size())));
  for (const char c : text) hash = Mix(hash, static_cast<uint64_t>(static_cast<int8_t>(c)));
  return hash;
}

uint64_t OwnHash(const StructType& type) {
  uint64_t hash = 0x12345678;
  for (const Member& member : type.members) {
    hash = MixText(hash, member.name);
    if (member.primitive) hash = MixText(hash, member.type_name);
    hash = Mix(hash, static_cast<uint64_t>(static_cast<int8_t>(member.dimensions.size())));
    for (const Dimension& dimension : member.dimensions) {
      hash = Mix(hash, dimension.is_variable() ? 1 : 0);
      hash = MixText(hash, dimension.text);
    }
  }
  return hash;
}

/// Works out fingerprints and sizes of types that know one another.
class Resolver {
 public:
  explicit Resolver(std::vector<StructType>* types)
      : types_(*types), is_measured_(types->size()), own_hashes_(types->size()) {
    std::transform(types_.begin(), types_.end(), own_hashes_.begin(), OwnHash);
  }

  /// Returns what is wrong, or an empty text.
  std::string Resolve() {
    for (size_t i = 0; i < types_.size(); ++i) {
      if (!Measure(i, 0)) {
        return "struct " + types_[i].FullName() + " contains itself, or nests deeper than " +
               std::to_string(kMaxStructDepth) + " structs; let a variable array end it";
      }
      visits_left_ = kMaxFingerprintVisits;
      types_[i].fingerprint = static_cast<int64_t>(Fingerprint(i));
      if (visits_left_ <= 0) return "struct " + types_[i].FullName() + " nests too many structs";
    }
    for (StructType& type : types_) {
      for (Member& member : type.members) MeasureElement(&member);  // variable arrays' too
    }
    return "";
  }

 private:
  /// Fills min_wire_size and has_fixed_size; false where that has no end.
  bool Measure(size_t index, int depth) {
    if (is_measured_[index]) return true;
    if (depth > kMaxStructDepth) return false;
    int64_t size = 0;
    bool is_fixed = true;
    for (Member& member : types_[index].members) {
      int64_t count = 1;
      bool is_variable = false;
      for (const Dimension& dimension : member.dimensions) {
        count = SaturatingMultiply(count, dimension.fixed_size);
        is_variable |= dimension.is_variable();
      }
      is_fixed &= !is_variable;
      if (is_variable) continue;
      if (!member.primitive && !Measure(member.struct_index, depth + 1)) return false;
      MeasureElement(&member);
      is_fixed &= member.has_fixed_size;
      size = SaturatingAdd(size, SaturatingMultiply(count, member.min_wire_size));
    }
    FindFixedRuns(&types_[index].members);
    types_[index].min_wire_size = size;
    types_[index].has_fixed_size = is_fixed;
    is_measured_[index] = true;
    return true;
  }

  /// @pre the struct that the member may be is measured.
  void MeasureElement(Member* member) const {
    if (member->primitive) {
      member->min_wire_size = MinWireSize(*member->primitive);
      member->has_fixed_size = *member->primitive != Primitive::kString;
    } else {
      member->min_wire_size = types_[member->struct_index].min_wire_size;
      member->has_fixed_size = types_[member->struct_index].has_fixed_size;
    }
  }

  static void FindFixedRuns(std::vector<Member>* members) {
    for (size_t i = members->size(); i-- > 0;) {
      Member& member = (*members)[i];
      const bool is_array = !member.dimensions.empty();
      if (!member.primitive || !member.has_fixed_size || member.length_slot || is_array) continue;
      const bool has_next = i + 1 < members->size();
      member.num_fixed_run = 1 + (has_next ? (*members)[i + 1].num_fixed_run : 0);
      member.fixed_run_size =
          SaturatingAdd(member.min_wire_size, has_next ? (*members)[i + 1].fixed_run_size : 0);
    }
  }

  /// As lcm-gen's _computeHash: a struct inside itself counts 0.
  uint64_t Fingerprint(size_t index) {
    if (std::find(parents_.begin(), parents_.end(), index) != parents_.end()) return 0;
    if (--visits_left_ <= 0) return 0;
    parents_.push_back(index);
    uint64_t hash = own_hashes_[index];
    for (const Member& member : types_[index].members) {
      if (!member.primitive) hash += Fingerprint(member.struct_index);
    }
    parents_.pop_back();
    return (hash << 1) + (hash >> 63);
  }

  std::vector<StructType>& types_;
  std::vector<bool> is_measured_;
  std::vector<uint64_t> own_hashes_;
  std::vector<size_t> parents_;
  int64_t visits_left_ = 0;
};

bool AreSame(const StructType& a, const StructType& b) {
  return OwnHash(a) == OwnHash(b) &&
         std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                    [](const Member& x, const Member& y) { return x.type_name == y.type_name; });
}

}  // namespace

std::optional<Primitive> PrimitiveNamed(std::string_view name) {
  const auto found = std::find_if(kPrimitives.begin(), kPrimitives.end(),
                                  [&](const auto& each) { return each.first == name; });
  if (found == kPrimitives.end()) return std::nullopt;
  return found->second;
}

int64_t MinWireSize(Primitive primitive) {
  switch (primitive) {
    case Primitive::kInt8:
    case Primitive::kByte:
    case Primitive::kBoolean:
      return 1;
    case Primitive::kInt16:
      return 2;
    case Primitive::kInt32:
    case Primitive::kFloat:
      return 4;
    case Primitive::kInt64:
    case Primitive::kDouble:
      return 8;
    case Primitive::kString:
      return 5;
  }
  SHOAL_CHECK(false, "every primitive type is handled");
}

Result<Schema> Schema::Build(const std::vector<LcmSource>& sources) {
  Schema schema;
  for (const LcmSource& source : sources) {
    Result<std::vector<StructType>> parsed = ParseLcm(source);
    if (!parsed.ok()) return Error{parsed.error()};
    for (StructType& type : *parsed) {
      const std::string name = type.FullName();
      const auto [known, is_new] = schema.by_name_.emplace(name, schema.types_.size());
      if (is_new) {
        schema.types_.push_back(std::move(type));
      } else if (!AreSame(schema.types_[known->second], type)) {
        return Error{source.file + ": struct " + name + " is there already, with other members"};
      }
    }
  }
  schema.LeaveOutIncomplete();
  for (StructType& type : schema.types_) {
    for (Member& member : type.members) {
      if (!member.primitive) member.struct_index = schema.by_name_.at(member.type_name);
    }
  }
  if (const std::string wrong = Resolver(&schema.types_).Resolve(); !wrong.empty()) {
    return Error{wrong};
  }
  for (size_t i = 0; i < schema.types_.size(); ++i) {
    schema.by_fingerprint_.emplace(schema.types_[i].fingerprint, i);
  }
  return schema;
}

void Schema::LeaveOutIncomplete() {
  const auto is_unknown = [&](const Member& member) {
    return !member.primitive && !by_name_.contains(member.type_name);
  };
  // Each pass finds the types that hold one of the pass before.
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const StructType& type : types_) {
      const std::string name = type.FullName();
      const auto member = std::find_if(type.members.begin(), type.members.end(), is_unknown);
      if (member == type.members.end() || by_name_.erase(name) == 0) continue;
      has_changed = true;
      left_out_.push_back("struct " + name + " is left out: its member '" + member->name +
                          "' has the unknown type " + member->type_name +
                          "; give the .lcm file that declares it, too");
    }
  }
  if (left_out_.empty()) return;
  std::erase_if(types_,
                [&](const StructType& type) { return !by_name_.contains(type.FullName()); });
  for (size_t i = 0; i < types_.size(); ++i) by_name_[types_[i].FullName()] = i;
}

const StructType* Schema::FindByName(std::string_view full_name) const {
  const auto found = by_name_.find(std::string(full_name));
  return found == by_name_.end() ? nullptr : &types_[found->second];
}

const StructType* Schema::FindByFingerprint(int64_t fingerprint) const {
  const auto found = by_fingerprint_.find(fingerprint);
  return found == by_fingerprint_.end() ? nullptr : &types_[found->second];
}

}  // namespace shoal
