// Vehicles' names and their numbers, without regard to case.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace shoal {

class NameTable {
 public:
  static constexpr size_t kLongestName = 64;  ///< Longer names are cut.

  NameTable() = default;
  explicit NameTable(const std::vector<std::string>& names);

  /// Returns the name's number, or -1.
  [[nodiscard]] int32_t Find(std::string_view name) const;
  /// Adds a name, or returns the number that it has.
  int32_t Add(std::string_view name);

  size_t size() const { return names_.size(); }
  /// @pre 0 <= index < size()
  const std::string& at(int32_t index) const { return names_.at(static_cast<size_t>(index)); }
  const std::vector<std::string>& all() const { return names_; }

 private:
  struct TextHash {
    using is_transparent = void;
    size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };

  std::vector<std::string> names_;
  std::unordered_map<std::string, int32_t, TextHash, std::equal_to<>> numbers_;  ///< By key too.
};

}  // namespace shoal
