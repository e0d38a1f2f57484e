// Messages as text for people.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/schema/walk.h"

namespace shoal {

/// Appends a value: numbers in the fewest digits that read back the same, true or false, text as
/// it is. NaN is "nan" whatever its sign.
void AppendScalar(const Scalar& value, std::string* out);

/// Appends `text`, in quotes where it is empty or has characters that would mislead the reader of
/// `name=text other=text`. Control characters become \n or \x1b.
void AppendQuoted(std::string_view text, std::string* out);

/// Appends microseconds as seconds: "12.300", and "12.300001" where three digits do not suffice.
void AppendSeconds(int64_t utime, std::string* out);

/// Writes values in one line: scalars as they are, arrays as [1 2], structs as {x_m=1 y_m=2}.
/// Members that are lengths of arrays are left out; the arrays show them.
class TextWriter : public Visitor {
 public:
  /// Appends to `out`. The outermost struct has no braces where `is_message`.
  explicit TextWriter(std::string* out, bool is_message) : out_(*out), is_message_(is_message) {}

  /// Leaves out members of this name that the outermost struct holds.
  void Skip(std::string_view member) { skipped_ = member; }

  void StructBegin(const StructType& type) override;
  void StructEnd() override;
  void MemberBegin(const Member& member) override;
  void ArrayBegin(int64_t size) override;
  void ArrayEnd() override;
  void Value(const Scalar& value) override;

 private:
  void Separate();
  bool IsSilent() const { return silent_depth_ > 0; }

  std::string& out_;
  const bool is_message_;
  std::string_view skipped_;
  int depth_ = 0;         ///< Structs that are open.
  int silent_depth_ = 0;  ///< Of the struct one of whose members is being left out; 0: none.
  bool is_first_ = true;  ///< Nothing before this one in the struct or array.
};

/// Returns a message as `x_m=1.5 name=alpha extra=[{key=a value=b}]`, without its member `skip`.
/// @pre FindWireFault() finds none.
std::string MessageText(const Schema& schema, const StructType& type,
                        std::span<const uint8_t> message, std::string_view skip = "");

/// One primitive value of a message and where it stands, such as "fates[2].cause".
struct Leaf {
  std::string path;
  std::string text;
};

/// Returns all primitive values in wire order.
/// @pre FindWireFault() finds none.
std::vector<Leaf> Leaves(const Schema& schema, const StructType& type,
                         std::span<const uint8_t> message);

}  // namespace shoal
