// A value for each enumerator, so that one that is forgotten does not compile.
//
//   enum class Jitter { kUniform, kOff };
//   constexpr EnumTable<Jitter, std::string_view> kJitterTexts = {"uniform", "off"};
//   kJitterTexts[Jitter::kOff]              // "off"
//   kJitterTexts.Find("off")                // Jitter::kOff
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace shoal {

namespace enum_table {

/// True where `kValue` is an enumerator: g++ and clang then print its name in the name of this
/// function, and else the number in brackets, "(shoal::Jitter)2".
template <class Enum, Enum kValue>
consteval bool IsEnumerator() {
  const std::string_view name = __PRETTY_FUNCTION__;
  const size_t begin = name.find("kValue = ") + std::string_view("kValue = ").size();
  return name[begin] != '(';
}

template <class Enum, size_t kNumber = 0>
consteval size_t Count() {
  if constexpr (IsEnumerator<Enum, static_cast<Enum>(kNumber)>()) {
    return Count<Enum, kNumber + 1>();
  } else {
    return kNumber;
  }
}

}  // namespace enum_table

/// The number of enumerators of an enumeration that counts from 0 without gaps.
template <class Enum>
inline constexpr size_t kNumEnumerators = enum_table::Count<Enum>();

/// All of them, in their order.
template <class Enum>
inline constexpr std::array<Enum, kNumEnumerators<Enum>> kEnumerators = [] {
  std::array<Enum, kNumEnumerators<Enum>> all{};
  for (size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Enum>(i);
  return all;
}();

template <class Enum, class T>
class EnumTable {
 public:
  /// One value for each enumerator, in their order.
  template <class... Values>
  constexpr EnumTable(const Values&... values) : values_{T(values)...} {  // NOLINT: like an array
    static_assert(sizeof...(Values) == kNumEnumerators<Enum>,
                  "an EnumTable has one value for each enumerator, in their order");
  }

  constexpr const T& operator[](Enum which) const { return values_[static_cast<size_t>(which)]; }
  constexpr const T& At(size_t number) const { return values_.at(number); }
  constexpr auto begin() const { return values_.begin(); }
  constexpr auto end() const { return values_.end(); }
  static constexpr size_t size() { return kNumEnumerators<Enum>; }

  /// Returns the first enumerator with this value.
  constexpr std::optional<Enum> Find(const T& value) const {
    for (size_t i = 0; i < size(); ++i) {
      if (values_[i] == value) return static_cast<Enum>(i);
    }
    return std::nullopt;
  }

 private:
  std::array<T, kNumEnumerators<Enum>> values_;
};

}  // namespace shoal
