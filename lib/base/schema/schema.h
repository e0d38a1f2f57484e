// The structure of LCM messages, from the text of .lcm files.
//
//   const Result<Schema> schema = Schema::Build({{"pose_t.lcm", text}});
//   const StructType* type = schema->FindByFingerprint(fingerprint);
//
// lib/base/schema/walk.h reads encoded messages with it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/base/check/result.h"

namespace shoal {

enum class Primitive : uint8_t {
  kInt8,
  kInt16,
  kInt32,
  kInt64,
  kByte,
  kFloat,
  kDouble,
  kString,
  kBoolean,
};

/// Returns the primitive that .lcm files call `name`, if there is one.
std::optional<Primitive> PrimitiveNamed(std::string_view name);

/// Returns how many bytes the smallest value takes: all have one size but strings (5 bytes: the
/// length and the terminating NUL).
int64_t MinWireSize(Primitive primitive);

/// One `[...]` of a member.
struct Dimension {
  std::string text;        ///< As written: a number, a constant's value, a length member's name.
  int64_t fixed_size = 0;  ///< 0: variable.
  size_t length_slot = 0;  ///< Variable: which of the struct's lengths; Member::length_slot.
  bool is_variable() const { return fixed_size == 0; }
};

struct Member {
  std::string name;
  std::string type_name;               ///< A primitive's, or a struct's with its package.
  std::optional<Primitive> primitive;  ///< Absent: a struct.
  size_t struct_index = 0;             ///< Into Schema::types(); of structs.
  std::vector<Dimension> dimensions;
  std::optional<size_t> length_slot;  ///< Present: this member is the length of an array.

  // What Schema::Build works out, of one element where the member is an array.
  int64_t min_wire_size = 0;
  bool has_fixed_size = false;  ///< Then all elements have min_wire_size.
  /// The number of members from this one on that are numbers, no arrays, and no lengths of arrays.
  size_t num_fixed_run = 0;
  int64_t fixed_run_size = 0;  ///< The bytes that these take together.
};

struct Constant {
  std::string name;
  std::string type_name;
  std::string value;  ///< As written.
};

struct StructType {
  std::string package;  ///< May be empty, may have dots.
  std::string name;     ///< Without the package.
  std::vector<Member> members;
  std::vector<Constant> constants;

  // What Schema::Build works out.
  int64_t fingerprint = 0;      ///< The first eight bytes of every encoded message.
  int64_t min_wire_size = 0;    ///< Bytes without the fingerprint, where every array is empty.
  bool has_fixed_size = false;  ///< Then all messages have min_wire_size.
  size_t num_lengths = 0;       ///< Members that are lengths of arrays.

  std::string FullName() const { return package.empty() ? name : package + "." + name; }
};

/// The text of one .lcm file.
struct LcmSource {
  std::string file;  ///< For error messages.
  std::string text;
};

/// Reads the text of one .lcm file. Errors name file, line and column.
[[nodiscard]] Result<std::vector<StructType>> ParseLcm(const LcmSource& source);

/// Types that are nested deeper than this are refused, in .lcm files and in messages.
inline constexpr int kMaxStructDepth = 64;

class Schema {
 public:
  /// Parses all sources and joins them. A type may be given twice if both are the same. A type with
  /// a member of a type that is not given is left out, and so are those that hold it.
  [[nodiscard]] static Result<Schema> Build(const std::vector<LcmSource>& sources);

  const std::vector<StructType>& types() const { return types_; }

  /// Returns, for each type left out, a sentence with the reason and the remedy.
  const std::vector<std::string>& left_out() const { return left_out_; }

  /// Finds "shoal.nav_t"; nullptr: no such type.
  const StructType* FindByName(std::string_view full_name) const;

  /// Finds the type of a message. Types with equal members have equal fingerprints: the first wins.
  const StructType* FindByFingerprint(int64_t fingerprint) const;

 private:
  void LeaveOutIncomplete();

  std::vector<StructType> types_;
  std::vector<std::string> left_out_;
  std::unordered_map<std::string, size_t> by_name_;
  std::unordered_map<int64_t, size_t> by_fingerprint_;
};

}  // namespace shoal
