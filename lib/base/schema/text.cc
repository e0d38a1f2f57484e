#include "lib/base/schema/text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <utility>

namespace shoal {

namespace {

template <class T>
void AppendNumber(T value, std::string* out) {
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(value)) {
      *out += "nan";
      return;
    }
  }
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  SHOAL_CHECK(error == std::errc(), "a number has at most 32 characters");
  out->append(digits.data(), end);
}

bool IsPlain(std::string_view text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    // Behind 0xc2 may stand the C1 control characters, which terminals execute.
    if (byte <= ' ' || byte == 0x7f || byte == 0xc2) return false;
    if (std::string_view("\"\\=[]{}").find(c) != std::string_view::npos) return false;
  }
  return !text.empty();
}

void AppendEscaped(unsigned char byte, std::string* out) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  *out += "\\x";
  *out += kDigits[byte >> 4];
  *out += kDigits[byte & 15];
}

/// Collects Leaf after Leaf.
class LeafCollector : public Visitor {
 public:
  std::vector<Leaf> leaves;

  void StructBegin(const StructType&) override { levels_.push_back({.prefix = path_.size()}); }
  void StructEnd() override { Leave(); }
  void MemberBegin(const Member& member) override {
    path_.resize(levels_.back().prefix);
    if (!path_.empty()) path_ += '.';
    path_ += member.name;
  }
  void ArrayBegin(int64_t) override {
    levels_.push_back({.prefix = path_.size(), .index = 0});
    ShowIndex();
  }
  void ArrayEnd() override { Leave(); }
  void Value(const Scalar& value) override {
    Leaf& leaf = leaves.emplace_back();
    leaf.path = path_;
    if (const auto* text = std::get_if<std::string_view>(&value)) {
      AppendQuoted(*text, &leaf.text);
    } else {
      AppendScalar(value, &leaf.text);
    }
    NextElement();
  }

 private:
  struct Level {
    size_t prefix = 0;   ///< Length of the path outside this struct or array.
    int64_t index = -1;  ///< Of the element; -1: a struct.
  };

  void ShowIndex() {
    path_.resize(levels_.back().prefix);
    path_ += '[';
    AppendNumber(levels_.back().index, &path_);
    path_ += ']';
  }
  void NextElement() {
    if (levels_.empty() || levels_.back().index < 0) return;
    ++levels_.back().index;
    ShowIndex();
  }
  void Leave() {
    path_.resize(levels_.back().prefix);
    levels_.pop_back();
    NextElement();
  }

  std::string path_;
  std::vector<Level> levels_;
};

}  // namespace

void AppendScalar(const Scalar& value, std::string* out) {
  std::visit(
      [&](const auto& each) {
        using T = std::decay_t<decltype(each)>;
        if constexpr (std::is_same_v<T, bool>) {
          *out += each ? "true" : "false";
        } else if constexpr (std::is_same_v<T, std::string_view>) {
          *out += each;
        } else {
          AppendNumber(each, out);
        }
      },
      value);
}

void AppendQuoted(std::string_view text, std::string* out) {
  if (IsPlain(text)) {
    *out += text;
    return;
  }
  *out += '"';
  for (size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool is_c1 =
        byte == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (byte == '\n') {
      *out += "\\n";
    } else if (byte < ' ' || byte == 0x7f || is_c1) {
      AppendEscaped(byte, out);
      if (is_c1) AppendEscaped(static_cast<unsigned char>(text[++i]), out);
    } else {
      if (byte == '"' || byte == '\\') *out += '\\';
      *out += text[i];
    }
  }
  *out += '"';
}

void AppendSeconds(int64_t utime, std::string* out) {
  const uint64_t magnitude =
      utime < 0 ? 0 - static_cast<uint64_t>(utime) : static_cast<uint64_t>(utime);
  if (utime < 0) *out += '-';
  AppendNumber(magnitude / 1'000'000, out);
  std::string fraction = std::to_string(1'000'000 + magnitude % 1'000'000);
  fraction[0] = '.';
  if (fraction.ends_with("000")) fraction.resize(4);
  *out += fraction;
}

void TextWriter::Separate() {
  if (!is_first_) out_ += ' ';
  is_first_ = false;
}

void TextWriter::StructBegin(const StructType&) {
  const bool has_braces = depth_ > 0 || !is_message_;
  ++depth_;
  if (IsSilent()) return;
  if (has_braces) {
    Separate();
    out_ += '{';
  }
  is_first_ = true;
}

void TextWriter::StructEnd() {
  if (depth_ == silent_depth_) silent_depth_ = 0;
  --depth_;
  if (IsSilent() || (depth_ == 0 && is_message_)) return;
  out_ += '}';
  is_first_ = false;
}

void TextWriter::MemberBegin(const Member& member) {
  if (depth_ == silent_depth_) silent_depth_ = 0;
  if (IsSilent()) return;
  if (member.length_slot || (depth_ == 1 && member.name == skipped_)) {
    silent_depth_ = depth_;
    return;
  }
  Separate();
  out_ += member.name;
  out_ += '=';
  is_first_ = true;
}

void TextWriter::ArrayBegin(int64_t) {
  if (IsSilent()) return;
  Separate();
  out_ += '[';
  is_first_ = true;
}

void TextWriter::ArrayEnd() {
  if (IsSilent()) return;
  out_ += ']';
  is_first_ = false;
}

void TextWriter::Value(const Scalar& value) {
  if (IsSilent()) return;
  Separate();
  if (const auto* text = std::get_if<std::string_view>(&value)) {
    AppendQuoted(*text, &out_);
  } else {
    AppendScalar(value, &out_);
  }
}

std::string MessageText(const Schema& schema, const StructType& type,
                        std::span<const uint8_t> message, std::string_view skip) {
  std::string text;
  TextWriter writer(&text, true);
  writer.Skip(skip);
  const auto fault = Walk(schema, type, message, &writer);
  SHOAL_CHECK(!fault, "FindWireFault() finds no fault in the message");
  return text;
}

std::vector<Leaf> Leaves(const Schema& schema, const StructType& type,
                         std::span<const uint8_t> message) {
  LeafCollector collector;
  const auto fault = Walk(schema, type, message, &collector);
  SHOAL_CHECK(!fault, "FindWireFault() finds no fault in the message");
  return std::move(collector.leaves);
}

}  // namespace shoal
