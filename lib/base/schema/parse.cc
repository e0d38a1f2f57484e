// Reads .lcm files as lcm-gen does: packages, structs, members, constants. No enums (LCM has no
// C++ for them).
#include <algorithm>
#include <charconv>
#include <limits>

#include "lib/base/schema/schema.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"

namespace shoal {

namespace {

bool IsSpace(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool IsWordChar(char c) { return IsNameCharacter(c) || c == '.'; }

struct Token {
  std::string_view text;  ///< A word, a number or one punctuation mark; empty: end of the file.
  size_t position = 0;    ///< In the source.
};

/// Cuts the text into tokens, one ahead.
class Lexer {
 public:
  explicit Lexer(std::string_view text) : text_(text) { Advance(); }

  const Token& next() const { return next_; }

  Token Take() {
    const Token taken = next_;
    Advance();
    return taken;
  }

  bool TakeIf(std::string_view text) {
    if (next_.text != text) return false;
    Advance();
    return true;
  }

 private:
  void Advance() {
    SkipSpaceAndComments();
    const size_t begin = position_;
    while (position_ < text_.size() && IsWordChar(text_[position_])) ++position_;
    if (position_ == begin && position_ < text_.size()) ++position_;
    next_ = {.text = text_.substr(begin, position_ - begin), .position = begin};
  }

  void SkipSpaceAndComments() {
    while (position_ < text_.size()) {
      const std::string_view rest = text_.substr(position_);
      if (IsSpace(rest[0])) {
        ++position_;
      } else if (rest.starts_with("//")) {
        position_ += std::min(rest.find('\n'), rest.size());
      } else if (rest.starts_with("/*")) {
        const size_t end = rest.find("*/", 2);
        position_ += end == std::string_view::npos ? rest.size() : end + 2;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  size_t position_ = 0;
  Token next_;
};

/// Returns the number that C reads in `text`: decimal, 0x hexadecimal or 0 octal.
std::optional<int64_t> ParseInteger(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative) text.remove_prefix(1);
  int base = 10;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    base = 16;
    text.remove_prefix(2);
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
  }
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  constexpr uint64_t kMax = std::numeric_limits<int64_t>::max();
  if (value > (is_negative ? kMax + 1 : kMax)) return std::nullopt;
  return static_cast<int64_t>(is_negative ? 0 - value : value);
}

bool IsLengthType(std::optional<Primitive> primitive) {
  return primitive == Primitive::kInt8 || primitive == Primitive::kInt16 ||
         primitive == Primitive::kInt32 || primitive == Primitive::kInt64;
}

class Parser {
 public:
  explicit Parser(const LcmSource& source) : source_(source), lexer_(source.text) {}

  Result<std::vector<StructType>> Parse() {
    while (!lexer_.next().text.empty() && error_.empty()) ParseTopLevel();
    if (!error_.empty()) return Error{error_};
    return std::move(types_);
  }

 private:
  void Fail(const Token& where, const std::string& what) {
    if (!error_.empty()) return;
    const std::string_view before = std::string_view(source_.text).substr(0, where.position);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
    error_ = source_.file + ":" + std::to_string(line) + ":" +
             std::to_string(where.position - line_begin + 1) + ": " + what;
  }

  bool Expect(std::string_view mark) {
    if (lexer_.TakeIf(mark)) return true;
    Fail(lexer_.next(), "expected '" + std::string(mark) + "'" + Found(lexer_.next()));
    return false;
  }

  static std::string Found(const Token& token) {
    return token.text.empty() ? ", found the end of the file"
                              : ", found '" + TerminalLine(token.text, 40) + "'";
  }

  std::string TakeName(std::string_view of_what, bool may_have_dots) {
    const Token token = lexer_.Take();
    const bool is_name = !token.text.empty() && (IsLetter(token.text[0]) || token.text[0] == '_') &&
                         (may_have_dots || token.text.find('.') == std::string_view::npos);
    if (!is_name) Fail(token, "expected the name of " + std::string(of_what) + Found(token));
    return std::string(token.text);
  }

  void ParseTopLevel() {
    if (lexer_.TakeIf("package")) {
      package_ = TakeName("a package", true);
      Expect(";");
    } else if (lexer_.TakeIf("struct")) {
      ParseStruct();
    } else if (lexer_.next().text == "enum") {
      Fail(lexer_.next(), "enums have no place in LCM's C++; use constants of int8_t");
    } else if (!lexer_.TakeIf(";")) {
      Fail(lexer_.next(), "expected 'package' or 'struct'" + Found(lexer_.next()));
    }
  }

  void ParseStruct() {
    StructType type;
    const std::string name = TakeName("a struct", true);
    const size_t dot = name.rfind('.');
    type.package = dot == std::string::npos ? package_ : name.substr(0, dot);
    type.name = dot == std::string::npos ? name : name.substr(dot + 1);
    Expect("{");
    while (error_.empty() && !lexer_.TakeIf("}")) {
      if (lexer_.TakeIf("const")) {
        ParseConstants(&type);
      } else {
        ParseMembers(&type);
      }
    }
    types_.push_back(std::move(type));
  }

  void CheckIsNew(const StructType& type, const Token& where, const std::string& name) {
    const auto is_same = [&](const auto& each) { return each.name == name; };
    if (std::any_of(type.members.begin(), type.members.end(), is_same) ||
        std::any_of(type.constants.begin(), type.constants.end(), is_same)) {
      Fail(where, "'" + name + "' is there twice");
    }
  }

  void ParseConstants(StructType* type) {
    const Token type_token = lexer_.next();
    const std::string type_name = TakeName("a constant's type", false);
    const auto primitive = PrimitiveNamed(type_name);
    const bool is_real = primitive == Primitive::kFloat || primitive == Primitive::kDouble;
    if (!is_real && !IsLengthType(primitive)) {
      Fail(type_token, "a constant is an integer, a float or a double");
    }
    do {
      const Token name_token = lexer_.next();
      Constant constant{.name = TakeName("a constant", false), .type_name = type_name, .value = ""};
      CheckIsNew(*type, name_token, constant.name);
      Expect("=");
      const Token value_token = lexer_.next();
      while (!lexer_.next().text.empty() && lexer_.next().text != "," &&
             lexer_.next().text != ";") {
        constant.value += lexer_.Take().text;  // "-1.5e-3" is cut at its signs
      }
      if (!(is_real ? IsReal(constant.value) : ParseInteger(constant.value).has_value())) {
        Fail(value_token, "expected a number of type " + type_name + Found(value_token));
      }
      type->constants.push_back(std::move(constant));
    } while (error_.empty() && lexer_.TakeIf(","));
    Expect(";");
  }

  static bool IsReal(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return (error == std::errc() && end == text.data() + text.size()) || ParseInteger(text);
  }

  void ParseMembers(StructType* type) {
    std::string type_name = TakeName("a member's type", true);
    const auto primitive = PrimitiveNamed(type_name);
    if (!primitive && type_name.find('.') == std::string::npos && !package_.empty()) {
      type_name = package_ + "." + type_name;
    }
    do {
      const Token name_token = lexer_.next();
      Member member;
      member.name = TakeName("a member", false);
      member.type_name = type_name;
      member.primitive = primitive;
      CheckIsNew(*type, name_token, member.name);
      while (error_.empty() && lexer_.TakeIf("[")) ParseDimension(type, &member);
      type->members.push_back(std::move(member));
    } while (error_.empty() && lexer_.TakeIf(","));
    Expect(";");
  }

  void ParseDimension(StructType* type, Member* member) {
    const Token token = lexer_.Take();
    Dimension dimension;
    dimension.text = token.text;
    if (!token.text.empty() && IsDigit(token.text[0])) {
      const auto size = ParseInteger(token.text);
      if (!size || *size <= 0) Fail(token, "an array's size is a whole number greater than 0");
      dimension.fixed_size = size.value_or(1);
    } else if (const Constant* constant = FindConstant(*type, token.text)) {
      const auto size = ParseInteger(constant->value);
      if (!IsLengthType(PrimitiveNamed(constant->type_name)) || !size || *size <= 0) {
        Fail(token, "the constant '" + constant->name +
                        "' is an array's size: it must be a whole " +
                        "number greater than 0, of type int8_t to int64_t");
      }
      // lcm-gen from 1.4 on has the constant's value in place of its name, in the fingerprint too.
      dimension.text = constant->value;
      dimension.fixed_size = std::max(size.value_or(1), int64_t{1});
    } else {
      dimension.length_slot = LengthSlot(type, token);
    }
    Expect("]");
    member->dimensions.push_back(std::move(dimension));
  }

  /// Of the same struct and above the array: lcm-gen knows no others.
  static const Constant* FindConstant(const StructType& type, std::string_view name) {
    const auto found = std::find_if(type.constants.begin(), type.constants.end(),
                                    [&](const Constant& each) { return each.name == name; });
    return found == type.constants.end() ? nullptr : &*found;
  }

  /// Marks the member that `token` names as a length.
  size_t LengthSlot(StructType* type, const Token& token) {
    const auto length = std::find_if(type->members.begin(), type->members.end(),
                                     [&](const Member& each) { return each.name == token.text; });
    if (length == type->members.end()) {
      Fail(token,
           "an array's length is a number, or a constant or a member that its struct declares "
           "before "
           "it" +
               Found(token));
      return 0;
    }
    if (!IsLengthType(length->primitive) || !length->dimensions.empty()) {
      Fail(token, "an array's length must be a single integer" + Found(token));
      return 0;
    }
    if (!length->length_slot) length->length_slot = type->num_lengths++;
    return *length->length_slot;
  }

  const LcmSource& source_;
  Lexer lexer_;
  std::string package_;
  std::vector<StructType> types_;
  std::string error_;  ///< The first; empty: none.
};

}  // namespace

Result<std::vector<StructType>> ParseLcm(const LcmSource& source) { return Parser(source).Parse(); }

}  // namespace shoal
