#include "lib/helm/modes/flag.h"

#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {
namespace {

/// Takes what follows the last `marker` off `text`; returns it, or nothing without marker.
std::optional<std::string> TakeSuffix(std::string_view& text, std::string_view marker) {
  const size_t place = text.rfind(marker);
  if (place == std::string_view::npos) return std::nullopt;
  std::string suffix(Trimmed(text.substr(place + marker.size())));
  text = Trimmed(text.substr(0, place));
  return suffix;
}

Error Wrong(std::string_view text, const std::string& problem) {
  return {"flag '" + std::string(text) + "': " + problem};
}

/// Calls `each` with the text before each $[NAME] and the name, and with the rest and no name.
template <class Each>
void SplitAtMacros(std::string_view text, const Each& each) {
  while (true) {
    const size_t begin = text.find("$[");
    const size_t end = begin == std::string_view::npos ? begin : text.find(']', begin);
    if (end == std::string_view::npos) break;
    each(text.substr(0, begin), text.substr(begin + 2, end - begin - 2));
    text.remove_prefix(end + 1);
  }
  each(text, std::string_view());
}

}  // namespace

Result<Flag> Flag::Parse(std::string_view text) {
  std::string_view rest = Trimmed(text);
  Flag flag;
  if (const auto condition_text = TakeSuffix(rest, "[if]")) {
    auto condition = Condition::Parse(*condition_text);
    if (!condition.ok()) return Wrong(text, condition.error());
    flag.condition_ = std::move(*condition);
  }
  if (auto destination = TakeSuffix(rest, "[to]")) {
    flag.own_too_ = destination->ends_with('+');
    if (flag.own_too_) destination->pop_back();
    flag.destination_ = Trimmed(*destination);
    if (flag.destination_.empty() || flag.destination_.find(' ') != std::string::npos) {
      return Wrong(text, "write a vehicle, group:NAME or all behind [to]: RETURN = true [to] all");
    }
  }
  const size_t sign = rest.find('=');
  if (sign == std::string_view::npos) return Wrong(text, "write it as VARIABLE = value");
  flag.variable_ = Trimmed(rest.substr(0, sign));
  const std::string problem = VariableNameProblem(flag.variable_);
  if (!problem.empty()) return Wrong(text, problem);
  std::string_view value = Trimmed(rest.substr(sign + 1));
  if (value.empty()) return Wrong(text, "the value is missing; empty text is \"\"");
  if (value.front() == '"') {
    if (value.size() < 2 || value.back() != '"') {
      return Wrong(text, "the quotes of the value do not enclose it");
    }
    flag.is_quoted_ = true;
    value = value.substr(1, value.size() - 2);
  }
  flag.value_ = value;
  return flag;
}

std::vector<VariablePost> Flag::Fire(const Variables& variables, const MacroValues& macros) const {
  if (condition_ && !condition_->Holds(variables)) return {};
  std::string text;
  SplitAtMacros(value_, [&](std::string_view before, std::string_view name) {
    text += before;
    if (name.data() == nullptr) return;
    const auto macro = macros ? macros(name) : std::nullopt;
    text += macro ? *macro : "$[" + std::string(name) + "]";
  });
  VariablePost post = {variable_, text, destination_};
  if (!is_quoted_) post.value = ValueIn(text);
  if (!own_too_) return {post};
  VariablePost own = post;
  own.destination.clear();
  return {own, post};
}

std::vector<std::string> Flag::MacrosUsed() const {
  std::vector<std::string> names;
  SplitAtMacros(value_, [&](std::string_view, std::string_view name) {
    if (name.data() != nullptr) names.emplace_back(name);
  });
  return names;
}

Result<std::vector<Flag>> ParseFlags(const std::vector<std::string>& texts) {
  std::vector<Flag> flags;
  for (const std::string& text : texts) {
    auto flag = Flag::Parse(text);
    if (!flag.ok()) return Error{flag.error()};
    flags.push_back(std::move(*flag));
  }
  return flags;
}

}  // namespace shoal
