#include "lib/helm/modes/mode_tree.h"

#include <algorithm>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

/// Splits "VARIABLE = VALUE"; returns what is wrong.
std::string SplitSetting(const std::string& text, std::string& variable, std::string& value) {
  const size_t sign = text.find('=');
  if (sign == std::string::npos) return "set = \"" + text + "\": write it as \"MODE = ACTIVE\"";
  variable = Trimmed(std::string_view(text).substr(0, sign));
  value = Trimmed(std::string_view(text).substr(sign + 1));
  return VariableNameProblem(variable);
}

/// A mode's own name: part of a value between colons.
std::string ModeNameProblem(const std::string& name) {
  if (name.empty()) return "the name of a mode is missing";
  if (name.find_first_of(": =\"()") == std::string::npos) return {};
  return "'" + name +
         "' is not a name of a mode: it must not hold blanks : = ( ) or quotes; parents come from "
         "conditions";
}

}  // namespace

Result<ModeTree> ModeTree::Parse(std::span<const ModeOptions> options) {
  ModeTree tree;
  for (const ModeOptions& option : options) {
    Declaration declaration;
    std::string problem = SplitSetting(option.set, declaration.variable, declaration.value);
    if (problem.empty()) problem = ModeNameProblem(declaration.value);
    declaration.otherwise = option.otherwise;
    if (problem.empty() && !option.otherwise.empty()) problem = ModeNameProblem(option.otherwise);
    if (!problem.empty()) return Error{problem};
    auto conditions = ParseConditions(option.condition);
    if (!conditions.ok()) return Error{conditions.error()};
    for (Condition& condition : *conditions) {
      const bool is_about_itself =
          condition.VariablesUsed() == std::vector<std::string>{declaration.variable};
      auto& list = is_about_itself ? declaration.about_itself : declaration.others;
      list.push_back(std::move(condition));
    }
    const auto known =
        std::find(tree.variables_.begin(), tree.variables_.end(), declaration.variable);
    if (known == tree.variables_.end()) tree.variables_.push_back(declaration.variable);
    tree.declarations_.push_back(std::move(declaration));
  }
  return tree;
}

std::vector<std::string> ModeTree::Apply(Variables& variables, double time_s) const {
  Condition::Overlay now;
  for (const std::string& variable : variables_) {
    const Variables::Entry* entry = variables.Find(variable);
    if (entry != nullptr) now[variable] = TextOf(entry->value);
  }
  const Condition::Overlay before = now;
  for (const Declaration& declaration : declarations_) {
    if (!AllHold(declaration.about_itself, variables, now)) continue;
    const std::string& value =
        AllHold(declaration.others, variables, now) ? declaration.value : declaration.otherwise;
    if (value.empty()) continue;
    std::string& mode = now[declaration.variable];
    if (declaration.about_itself.empty()) mode.clear();
    if (!mode.empty()) mode += ':';
    mode += value;
  }
  std::vector<std::string> changes;
  for (const auto& [variable, value] : now) {
    const auto old = before.find(variable);
    if (old != before.end() && old->second == value) continue;
    if (!variables.Set(variable, value, time_s)) continue;
    changes.emplace_back(variable).append(" = ").append(value);
  }
  return changes;
}

std::vector<std::string> ModeTree::Values() const {
  std::vector<std::string> values;
  for (const Declaration& declaration : declarations_) {
    values.push_back(declaration.value);
    if (!declaration.otherwise.empty()) values.push_back(declaration.otherwise);
  }
  return values;
}

}  // namespace shoal
