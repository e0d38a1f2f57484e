// Hierarchical modes: variables that follow from conditions, so that those of behaviors stay short.
//
//   [[vehicle.mode]]                 [[vehicle.mode]]
//   set = "MODE = ACTIVE"            set = "MODE = RETURNING"
//   condition = ["DEPLOY = true"]    condition = ["MODE = ACTIVE", "RETURN = true"]
//   else = "INACTIVE"                else = "SURVEYING"
//
//              MODE = INACTIVE, ACTIVE:RETURNING or ACTIVE:SURVEYING
//
// The declarations are evaluated in their order, each sees what earlier ones set. Where all its
// conditions hold, the variable becomes the value, behind its present value and a colon where a
// condition is about the variable itself. Where they do not, but those about the variable itself
// do, it becomes the else value likewise. A variable that nothing sets keeps its value.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/helm/modes/condition.h"
#include "lib/helm/modes/variables.h"

namespace shoal {

/// [[vehicle.mode]].
struct ModeOptions {
  std::string set;  ///< "VARIABLE = VALUE".
  std::vector<std::string> condition = {};
  std::string otherwise = {};  ///< `else`; empty: none.

  bool operator==(const ModeOptions&) const = default;
};

class ModeTree {
 public:
  /// Returns the tree, or what is wrong with a declaration.
  static Result<ModeTree> Parse(std::span<const ModeOptions> options);

  /// Sets the mode variables whose values change; returns these as "MODE = ACTIVE:SURVEYING".
  std::vector<std::string> Apply(Variables& variables, double time_s) const;

  /// Returns the variables that it sets, in the order of the file; that of the first is the mode.
  const std::vector<std::string>& variables() const { return variables_; }
  /// Returns every value that a declaration gives (RETURNING, without its parents).
  std::vector<std::string> Values() const;

 private:
  struct Declaration {
    std::string variable;
    std::string value;
    std::string otherwise;
    std::vector<Condition> about_itself;  ///< Conditions that look at the variable alone.
    std::vector<Condition> others;
  };

  std::vector<Declaration> declarations_;
  std::vector<std::string> variables_;
};

}  // namespace shoal
