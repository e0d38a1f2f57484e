#include "lib/tools/moos/bhv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"
#include "lib/mission/toml/table_writer.h"
#include "lib/run/moos_text/numbers.h"

namespace shoal {

std::string_view WithoutQuotes(std::string_view text) {
  text = Trimmed(text);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

std::vector<std::string> PartsOf(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of(separators), text.size());
    if (!Trimmed(text.substr(0, end)).empty()) parts.emplace_back(Trimmed(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

void CollectVariables(std::string_view text, std::set<std::string, std::less<>>* variables) {
  while (!text.empty()) {
    const auto begin = std::find_if(text.begin(), text.end(), IsNameCharacter);
    const auto end = std::find_if_not(begin, text.end(), IsNameCharacter);
    if (begin != end) variables->emplace(begin, end);
    text = std::string_view(end, text.end());
  }
}

std::string ConditionText(std::string_view text) {
  std::string condition(WithoutQuotes(text));
  const bool has_relation = condition.find_first_of("=<>") != condition.npos;
  const size_t comma = condition.find(',');
  if (!has_relation && comma != condition.npos) condition.replace(comma, 1, " =");
  return condition;
}

std::string TomlTexts(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + TomlString(text);
  return "[" + list + "]";
}

Result<std::string> TomlNumbers(std::string_view text, bool is_pairs) {
  std::string list;
  for (const std::string& part : PartsOf(text, is_pairs ? ":" : ",:")) {
    std::vector<double> numbers;
    for (const std::string& word : PartsOf(part, ",")) {
      const auto number = NumberIn(word);
      if (!number) return Error{"not numbers"};
      numbers.push_back(*number);
    }
    if (is_pairs && numbers.size() == 1) numbers.push_back(0);
    if (numbers.size() != (is_pairs ? 2U : 1U)) return Error{"not DEPTH,SECONDS : ..."};
    list += list.empty() ? "" : ", ";
    list += is_pairs ? fmt::format("[{}, {}]", TomlNumber(numbers[0]), TomlNumber(numbers[1]))
                     : TomlNumber(numbers[0]);
  }
  if (list.empty()) return Error{"is empty"};
  return "[" + list + "]";
}

}  // namespace shoal
