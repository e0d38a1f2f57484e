#include "lib/tools/view/json_writer.h"

#include <array>
#include <charconv>
#include <cmath>

#include "lib/bus/record/valid_utf8.h"

namespace shoal {

namespace {

constexpr double kLargest = 1e12;
constexpr std::array<double, 7> kScales = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
constexpr std::array<int64_t, 7> kUnits = {1, 10, 100, 1000, 10'000, 100'000, 1'000'000};

void AppendInteger(int64_t value, std::string* out) {
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  out->append(digits.data(), end);
}

bool IsPlain(char c) { return static_cast<signed char>(c) >= 0x20 && c != '"' && c != '\\'; }

void AppendEscaped(std::string_view text, std::string* out) {
  constexpr std::string_view kHex = "0123456789abcdef";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      *out += '\\';
      *out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      *out += "\\u00";
      *out += kHex[byte >> 4];
      *out += kHex[byte & 15];
    } else {
      *out += c;
    }
  }
}

}  // namespace

JsonWriter& JsonWriter::Key(std::string_view key) {
  Separate();
  out_ += '"';
  out_ += key;
  out_ += "\":";
  is_first_ = true;
  return *this;
}

JsonWriter& JsonWriter::KeyText(std::string_view key) {
  Text(key);
  out_ += ':';
  is_first_ = true;
  return *this;
}

JsonWriter& JsonWriter::Number(double value, int decimals) {
  if (!(std::abs(value) <= kLargest)) return Null();
  Separate();
  const auto place = static_cast<size_t>(decimals);
  int64_t scaled = std::llround(value * kScales.at(place));
  if (scaled < 0) {
    out_ += '-';
    scaled = -scaled;
  }
  const int64_t unit = kUnits.at(place);
  AppendInteger(scaled / unit, &out_);
  int64_t fraction = scaled % unit;
  if (fraction > 0) {
    out_ += '.';
    for (int64_t digit = unit / 10; fraction > 0; digit /= 10) {
      out_ += static_cast<char>('0' + fraction / digit);
      fraction %= digit;
    }
  }
  is_first_ = false;
  return *this;
}

JsonWriter& JsonWriter::Integer(int64_t value) {
  Separate();
  AppendInteger(value, &out_);
  is_first_ = false;
  return *this;
}

JsonWriter& JsonWriter::Text(std::string_view text) {
  Separate();
  out_ += '"';
  size_t num_plain = 0;
  while (num_plain < text.size() && IsPlain(text[num_plain])) ++num_plain;
  out_ += text.substr(0, num_plain);
  if (num_plain < text.size()) AppendEscaped(ValidUtf8(text.substr(num_plain)), &out_);
  out_ += '"';
  is_first_ = false;
  return *this;
}

JsonWriter& JsonWriter::Raw(std::string_view json) {
  Separate();
  out_ += json;
  is_first_ = false;
  return *this;
}

std::string JsonWriter::Take() {
  std::string taken = std::move(out_);
  out_.clear();
  is_first_ = true;
  return taken;
}

JsonWriter& JsonWriter::Begin(char bracket) {
  Separate();
  out_ += bracket;
  is_first_ = true;
  return *this;
}

JsonWriter& JsonWriter::End(char bracket) {
  out_ += bracket;
  is_first_ = false;
  return *this;
}

void JsonWriter::Separate() {
  if (!is_first_) out_ += ',';
}

}  // namespace shoal
