// Flags: settings of variables that a behavior makes at certain moments.
//
//   RETURN = true                         own variable
//   PLACE = "x=$[OSX],y=$[OSY]"           macros are replaced when the flag is posted
//   RETURN = true [to] all                a node message to all vehicles; also a name, a group as
//                                         group:NAME; all+ means oneself too
//   SLOW = true [if] (RANGE < 20)         only where the condition holds
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/variables.h"

namespace shoal {

/// Returns what stands for the macro `name` of $[NAME], or nothing where it has no value now.
using MacroValues = std::function<std::optional<std::string>(std::string_view name)>;

class Flag {
 public:
  /// Returns the flag, or what is wrong with it and how to write it.
  static Result<Flag> Parse(std::string_view text);

  /// Returns what it sets now: nothing where its condition fails, two posts where it is for others
  /// and oneself. A macro without value stays as it is written.
  std::vector<VariablePost> Fire(const Variables& variables, const MacroValues& macros) const;

  const std::string& variable() const { return variable_; }
  /// Returns the names in its $[...].
  std::vector<std::string> MacrosUsed() const;
  const std::optional<Condition>& condition() const { return condition_; }
  const std::string& destination() const { return destination_; }

 private:
  std::string variable_;
  std::string value_;
  bool is_quoted_ = false;  ///< Text, whatever it looks like.
  std::string destination_;
  bool own_too_ = false;
  std::optional<Condition> condition_;
};

/// Parses each; the error names the one that is wrong.
[[nodiscard]] Result<std::vector<Flag>> ParseFlags(const std::vector<std::string>& texts);

}  // namespace shoal
