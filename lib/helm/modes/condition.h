// Conditions of behaviors and modes: "DEPLOY = true", "(MODE = ACTIVE) and !(DEPTH > 20)".
//
//   condition  :=  comparison | "(" condition ")" | "!(" condition ")" | part op part op part ...
//   part       :=  "(" condition ")" | "!(" condition ")"
//   op         :=  "and" or "or", in any case; all of one condition alike
//   comparison :=  VARIABLE relation value
//   relation   :=  =  !=  <  >  <=  >=  ==
//   value      :=  number | text | "text" | $(VARIABLE)
//
// A comparison with a variable that was never set is false, that with != too. Text compares with
// text exactly, < and > by the alphabet; text that is a number compares with a number as one; other
// text compared with a number is false, with != too. VARIABLE == value holds where any of the
// variable's parts between colons equals the value; = means the whole.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/helm/modes/variables.h"

namespace shoal {

class Condition {
 public:
  /// Values that count instead of those of the variables.
  using Overlay = std::map<std::string, std::string, std::less<>>;

  /// Returns the condition, or what is wrong with it and how to write it.
  static Result<Condition> Parse(std::string_view text);

  bool Holds(const Variables& variables, const Overlay& overlay = {}) const;

  /// Returns the variables that it looks at, each once, in the order of the text.
  std::vector<std::string> VariablesUsed() const;
  /// Returns the variables that it compares with one value each by = or ==, and the values.
  std::multimap<std::string, std::string> ValuesCompared() const;
  const std::string& text() const { return text_; }

 private:
  struct Node;
  class Parser;

  std::string text_;
  std::shared_ptr<const Node> root_;  ///< Never changes.
};

/// Parses each; the error names the one that is wrong.
[[nodiscard]] Result<std::vector<Condition>> ParseConditions(const std::vector<std::string>& texts);

/// Returns true where all of them hold.
[[nodiscard]] bool AllHold(const std::vector<Condition>& conditions, const Variables& variables,
                           const Condition::Overlay& overlay = {});

}  // namespace shoal
