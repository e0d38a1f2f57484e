#include "lib/tools/campaign/toml_text.h"

#include <fmt/format.h>

#include "lib/mission/toml/table_writer.h"

namespace shoal {

namespace {

std::string TextOf(bool flag) { return flag ? "true" : "false"; }
std::string TextOf(int64_t number) { return fmt::format("{}", number); }
std::string TextOf(const std::string& text) { return TomlString(text); }
std::string TextOf(const DateOrTime&) { return "\"a date\""; }

std::string TextOf(double number) {
  std::string text = TomlNumber(number);
  // A number without point or exponent would be read as an integer.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string TextOf(const Array& array) {
  std::string text;
  for (const Value& value : array) text += (text.empty() ? "" : ", ") + TomlText(value);
  return "[" + text + "]";
}

std::string TextOf(const Table& table) {
  std::string text;
  for (const Entry& entry : table) {
    text += (text.empty() ? "" : ", ") + TomlString(entry.key) + " = " + TomlText(entry.value);
  }
  return "{" + text + "}";
}

}  // namespace

std::string TomlText(const Value& value) {
  return std::visit([](const auto& data) { return TextOf(data); }, value.data);
}

}  // namespace shoal
