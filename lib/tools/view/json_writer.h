// Writes JSON fast, one token after the other.
//
//   JsonWriter json;
//   json.BeginObject().Number("t", 1.25, 2).Text("name", "alpha").EndObject();
//   json.Take();   // {"t":1.25,"name":"alpha"}
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace shoal {

/// Decimals of numbers, by what they leave of a unit.
inline constexpr int kTenths = 1;
inline constexpr int kCentimetres = 2;
inline constexpr int kMilliseconds = 3;

class JsonWriter {
 public:
  JsonWriter& BeginObject() { return Begin('{'); }
  JsonWriter& EndObject() { return End('}'); }
  JsonWriter& BeginArray() { return Begin('['); }
  JsonWriter& EndArray() { return End(']'); }
  /// Writes a member's name; it is taken as it is: letters, digits and '_'.
  JsonWriter& Key(std::string_view key);

  /// The same of any text.
  JsonWriter& KeyText(std::string_view key);

  /// Writes a number rounded to `decimals` (0 to 6); null where it is not finite, or beyond
  /// 1e12.
  JsonWriter& Number(double value, int decimals);
  JsonWriter& Integer(int64_t value);
  JsonWriter& Boolean(bool value) { return Raw(value ? "true" : "false"); }
  JsonWriter& Null() { return Raw("null"); }
  /// Writes any bytes as text: those that are no UTF-8 as U+FFFD (lib/bus/record/valid_utf8.h).
  JsonWriter& Text(std::string_view text);
  /// Writes a value that is JSON already.
  JsonWriter& Raw(std::string_view json);

  // Write a member of an object: its name and its value.
  JsonWriter& Number(std::string_view key, double value, int decimals) {
    return Key(key).Number(value, decimals);
  }
  JsonWriter& Integer(std::string_view key, int64_t value) { return Key(key).Integer(value); }
  JsonWriter& Boolean(std::string_view key, bool value) { return Key(key).Boolean(value); }
  JsonWriter& Text(std::string_view key, std::string_view text) { return Key(key).Text(text); }

  /// Returns what was written, and starts again.
  std::string Take();

 private:
  JsonWriter& Begin(char bracket);
  JsonWriter& End(char bracket);
  void Separate();

  std::string out_;
  bool is_first_ = true;  ///< Of its object or array, or the value of a key.
};

}  // namespace shoal
