#include "lib/helm/modes/condition.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/helm/modes/value_text.h"

namespace shoal {

/// How two values are compared. (Named outside the anonymous namespace: Condition::Node holds one.)
enum class ConditionRelation { kEqual, kPartEquals, kNotEqual, kLess, kGreater, kAtMost, kAtLeast };

namespace {

using Relation = ConditionRelation;

/// Two characters before one of them.
constexpr std::pair<std::string_view, Relation> kRelations[] = {
    {"==", Relation::kPartEquals}, {"!=", Relation::kNotEqual}, {"<=", Relation::kAtMost},
    {">=", Relation::kAtLeast},    {"=", Relation::kEqual},     {"<", Relation::kLess},
    {">", Relation::kGreater}};

template <class T>
bool Compare(Relation relation, const T& left, const T& right) {
  switch (relation) {
    case Relation::kEqual:
    case Relation::kPartEquals:
      return left == right;
    case Relation::kNotEqual:
      return left != right;
    case Relation::kLess:
      return left < right;
    case Relation::kGreater:
      return left > right;
    case Relation::kAtMost:
      return left <= right;
    case Relation::kAtLeast:
      return left >= right;
  }
  return false;
}

bool CompareValues(Relation relation, const VariableValue& left, const VariableValue& right) {
  const auto* left_text = std::get_if<std::string>(&left);
  const auto* right_text = std::get_if<std::string>(&right);
  if (left_text != nullptr && right_text != nullptr) {
    return Compare(relation, *left_text, *right_text);
  }
  const auto number = [](const VariableValue& value) -> std::optional<double> {
    if (const auto* text = std::get_if<std::string>(&value)) return NumberIn(*text);
    return std::get<double>(value);
  };
  const std::optional<double> a = number(left);
  const std::optional<double> b = number(right);
  return a && b && Compare(relation, *a, *b);
}

/// `left` with colons: whether one of its parts equals `right`.
bool AnyPartEquals(const VariableValue& left, const VariableValue& right) {
  const auto* text = std::get_if<std::string>(&left);
  if (text == nullptr) return CompareValues(Relation::kEqual, left, right);
  std::string_view rest = *text;
  while (true) {
    const size_t colon = rest.find(':');
    const std::string part(rest.substr(0, colon));
    if (CompareValues(Relation::kEqual, part, right)) return true;
    if (colon == std::string_view::npos) return false;
    rest.remove_prefix(colon + 1);
  }
}

/// Returns true where `text` has the word at `place`, in any case.
bool HasWordAt(std::string_view text, size_t place, std::string_view word) {
  if (place + word.size() > text.size()) return false;
  if (place > 0 && IsNameCharacter(text[place - 1])) return false;
  if (place + word.size() < text.size() && IsNameCharacter(text[place + word.size()])) return false;
  for (size_t i = 0; i < word.size(); ++i) {
    if (LowerCase(text[place + i]) != word[i]) return false;
  }
  return true;
}

std::string InQuotes(std::string_view text) { return "'" + std::string(text) + "'"; }

}  // namespace

/// A comparison, or parts joined by and / or.
struct Condition::Node {
  bool is_negated = false;
  bool any = false;  ///< One of `parts` is enough.
  std::vector<Node> parts = {};
  // Without parts:
  std::string variable = {};
  ConditionRelation relation = ConditionRelation::kEqual;
  VariableValue value = {};
  std::string other = {};  ///< A variable instead of `value`.

  bool Holds(const Variables& variables, const Overlay& overlay) const {
    return IsTrue(variables, overlay) != is_negated;
  }

  template <class Visit>
  void EachComparison(const Visit& visit) const {
    if (parts.empty()) visit(*this);
    for (const Node& part : parts) part.EachComparison(visit);
  }

 private:
  static std::optional<VariableValue> ValueOf(const std::string& name, const Variables& variables,
                                              const Overlay& overlay) {
    const auto covered = overlay.find(name);
    if (covered != overlay.end()) return covered->second;
    const Variables::Entry* entry = variables.Find(name);
    if (entry == nullptr) return std::nullopt;
    return entry->value;
  }

  bool IsTrue(const Variables& variables, const Overlay& overlay) const {
    const auto holds = [&](const Node& part) { return part.Holds(variables, overlay); };
    if (!parts.empty()) {
      return any ? std::any_of(parts.begin(), parts.end(), holds)
                 : std::all_of(parts.begin(), parts.end(), holds);
    }
    const std::optional<VariableValue> left = ValueOf(variable, variables, overlay);
    if (!left) return false;
    std::optional<VariableValue> right = value;
    if (!other.empty()) right = ValueOf(other, variables, overlay);
    if (!right) return false;
    if (relation == Relation::kPartEquals) return AnyPartEquals(*left, *right);
    return CompareValues(relation, *left, *right);
  }
};

class Condition::Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  /// Returns nothing where something is wrong: problem().
  std::optional<Node> Parse() { return ParseAny(text_, 0); }
  const std::string& problem() const { return problem_; }

 private:
  static constexpr int kDeepest = 50;

  std::optional<Node> Fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
    return std::nullopt;
  }

  /// Returns the place behind the bracket that closes the one at `open`, or npos.
  static size_t Closing(std::string_view text, size_t open) {
    int depth = 0;
    bool in_quotes = false;
    for (size_t i = open; i < text.size(); ++i) {
      if (text[i] == '"') in_quotes = !in_quotes;
      if (in_quotes) continue;
      if (text[i] == '(') ++depth;
      if (text[i] == ')' && --depth == 0) return i + 1;
    }
    return std::string_view::npos;
  }

  std::optional<Node> ParseAny(std::string_view text, int depth) {
    text = Trimmed(text);
    if (depth > kDeepest) return Fail("its parentheses are nested too deeply");
    if (text.empty()) return Fail("a comparison is missing; write it like (DEPLOY = true)");
    if (text.front() != '(' && text.front() != '!') return ParseComparison(text);
    std::vector<Node> parts;
    std::string_view joined_by;
    std::string_view rest = text;
    while (true) {
      auto part = ParsePart(rest, depth);
      if (!part) return std::nullopt;
      parts.push_back(std::move(*part));
      rest = Trimmed(rest);
      if (rest.empty()) break;
      const std::string_view op = HasWordAt(rest, 0, "and")  ? "and"
                                  : HasWordAt(rest, 0, "or") ? "or"
                                                             : "";
      if (op.empty()) {
        return Fail("there is " + InQuotes(rest) + " behind a ')'; join parts by and, or");
      }
      if (!joined_by.empty() && joined_by != op) {
        return Fail("and, or are side by side; add parentheses: ((A) and (B)) or (C)");
      }
      joined_by = op;
      rest = Trimmed(rest.substr(op.size()));
      if (rest.empty() || (rest.front() != '(' && rest.front() != '!')) {
        return Fail("what is behind " + std::string(op) + " needs parentheses: (A = 1) " +
                    std::string(op) + " (B = 2)");
      }
    }
    if (parts.size() == 1) return std::move(parts.front());
    Node node;
    node.any = joined_by == "or";
    node.parts = std::move(parts);
    return node;
  }

  /// Takes "( ... )" or "! ( ... )" off the front of `text`.
  std::optional<Node> ParsePart(std::string_view& text, int depth) {
    const bool negated = text.front() == '!';
    if (negated) text = Trimmed(text.substr(1));
    if (text.empty() || text.front() != '(') {
      return Fail("what is behind ! needs parentheses: !(DEPLOY = true)");
    }
    const size_t end = Closing(text, 0);
    if (end == std::string_view::npos) return Fail("a ')' is missing");
    auto node = ParseAny(text.substr(1, end - 2), depth + 1);
    text.remove_prefix(end);
    if (!node || !negated) return node;
    Node outer;
    outer.is_negated = true;
    outer.parts.push_back(std::move(*node));
    return outer;
  }

  std::optional<Node> ParseComparison(std::string_view text) {
    if (HasWordAt(text, 0, "not")) return Fail("for not, write !( ... ): !(DEPLOY = true)");
    size_t place = text.find_first_of("=!<>");
    std::string_view sign;
    Node node;
    if (place == std::string_view::npos) {
      place = text.find(',');  // VARIABLE, value: as others write it.
      if (place == std::string_view::npos) {
        return Fail(InQuotes(text) + " compares nothing; write it like " +
                    std::string(Trimmed(text)) + " = true");
      }
      sign = ",";
    } else {
      for (const auto& [word, relation] : kRelations) {
        if (sign.empty() && text.substr(place).starts_with(word)) {
          sign = word;
          node.relation = relation;
        }
      }
    }
    if (sign.empty()) return Fail("a '!' needs parentheses behind it: !(DEPLOY = true)");
    node.variable = Trimmed(text.substr(0, place));
    const std::string name_problem = VariableNameProblem(node.variable);
    if (!name_problem.empty()) return Fail(name_problem);
    return ParseValue(Trimmed(text.substr(place + sign.size())), std::move(node));
  }

  std::optional<Node> ParseValue(std::string_view value, Node node) {
    if (value.empty()) return Fail("the value behind " + node.variable + " is missing");
    if (value.front() == '"') {
      if (value.size() < 2 || value.find('"', 1) != value.size() - 1) {
        return Fail("the quotes of the value of " + node.variable + " do not enclose it");
      }
      node.value = ValueIn(value);
      return node;
    }
    if (value.starts_with("$(") && value.ends_with(')')) {
      node.other = Trimmed(value.substr(2, value.size() - 3));
      const std::string problem = VariableNameProblem(node.other);
      if (!problem.empty()) return Fail(problem);
      return node;
    }
    for (size_t i = 0; i < value.size(); ++i) {
      if (HasWordAt(value, i, "and") || HasWordAt(value, i, "or")) {
        return Fail(
            "put each comparison in parentheses, (A = 1) and (B = 2), or text with the words and, "
            "or in quotes");
      }
    }
    if (value.find_first_of("=<>()!\"") != std::string_view::npos) {
      return Fail("the value " + InQuotes(value) + " holds one of = < > ( ) !; put it in quotes");
    }
    node.value = ValueIn(value);
    return node;
  }

  std::string_view text_;
  std::string problem_;
};

Result<Condition> Condition::Parse(std::string_view text) {
  Parser parser(text);
  auto root = parser.Parse();
  if (!root) return Error{"condition " + InQuotes(text) + ": " + parser.problem()};
  Condition condition;
  condition.text_ = Trimmed(text);
  condition.root_ = std::make_shared<const Node>(std::move(*root));
  return condition;
}

bool Condition::Holds(const Variables& variables, const Overlay& overlay) const {
  return root_->Holds(variables, overlay);
}

std::vector<std::string> Condition::VariablesUsed() const {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    names.push_back(name);
  };
  root_->EachComparison([&](const Node& node) {
    add(node.variable);
    add(node.other);
  });
  return names;
}

std::multimap<std::string, std::string> Condition::ValuesCompared() const {
  std::multimap<std::string, std::string> values;
  root_->EachComparison([&](const Node& node) {
    const bool equals = node.relation == Relation::kEqual || node.relation == Relation::kPartEquals;
    if (equals && node.other.empty()) values.emplace(node.variable, TextOf(node.value));
  });
  return values;
}

Result<std::vector<Condition>> ParseConditions(const std::vector<std::string>& texts) {
  std::vector<Condition> conditions;
  for (const std::string& text : texts) {
    auto condition = Condition::Parse(text);
    if (!condition.ok()) return Error{condition.error()};
    conditions.push_back(std::move(*condition));
  }
  return conditions;
}

bool AllHold(const std::vector<Condition>& conditions, const Variables& variables,
             const Condition::Overlay& overlay) {
  return std::all_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    return condition.Holds(variables, overlay);
  });
}

}  // namespace shoal
