// The variables of one helm: what conditions test, and what flags, node messages and commands set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace shoal {

/// Text or a number. A variable keeps the kind that it had first.
using VariableValue = std::variant<std::string, double>;

/// One setting of a variable, for flags and their log.
struct VariablePost {
  std::string variable;
  VariableValue value;
  /// Empty: the helm's own; else the node message's destination: a vehicle, a group or "all".
  std::string destination = {};

  bool operator==(const VariablePost&) const = default;
};

class Variables {
 public:
  /// No helm keeps more variables; settings of further ones are refused.
  static constexpr size_t kMax = 1000;
  static constexpr size_t kMaxFresh = 100;

  struct Entry {
    VariableValue value;
    double set_s = 0;     ///< Time of the last setting.
    int64_t num_set = 0;  ///< How often it was set.
    /// Settings since the last ForgetFresh(), in order; the last kMaxFresh of them.
    std::vector<VariableValue> fresh = {};
  };

  /// Sets a variable at `time_s`. Returns false, and changes nothing, where it holds the other kind
  /// (text, number), is new and there are kMax, the name is empty, or the number is not finite.
  bool Set(std::string_view variable, const VariableValue& value, double time_s);

  /// Returns why Set refuses the setting; empty: it does not.
  std::string WhyNot(std::string_view variable, const VariableValue& value) const;

  /// Returns the variable, or nullptr.
  const Entry* Find(std::string_view variable) const;

  /// At the end of an iteration.
  void ForgetFresh();

  const std::map<std::string, Entry, std::less<>>& all() const { return entries_; }

 private:
  std::map<std::string, Entry, std::less<>> entries_;
};

}  // namespace shoal
