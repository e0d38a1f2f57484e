#include "lib/tools/moos/shell_condition.h"

#include <cstddef>
#include <set>
#include <string>

#include "lib/base/text/numbers.h"

namespace shoal {
namespace {

/// Returns what one comparison of a test gives; moves `at` behind it.
bool Primary(const ShellWords& words, const ShellRun& run, size_t* at) {
  if (*at >= words.size()) return false;
  const std::string& first = words[*at];
  if (*at + 1 < words.size() && (first == "-z" || first == "-n" || first == "-f" || first == "-e" ||
                                 first == "-d" || first == "-x" || first == "-r")) {
    const std::string& value = words[*at + 1];
    *at += 2;
    if (first == "-z") return value.empty();
    if (first == "-n") return !value.empty();
    return first != "-d" && run.HasFile(value);
  }
  if (*at + 2 >= words.size()) {
    ++*at;
    return !first.empty();
  }
  const std::string& relation = words[*at + 1];
  const std::string& second = words[*at + 2];
  const std::set<std::string> known = {"=",   "!=",  "-eq", "-ne", "-lt",
                                       "-gt", "-le", "-ge", "<",   ">"};
  if (!known.contains(relation)) {
    ++*at;
    return !first.empty();
  }
  *at += 3;
  if (relation == "=") return first == second;
  if (relation == "!=") return first != second;
  const double left = NumberIn(first).value_or(0);
  const double right = NumberIn(second).value_or(0);
  if (relation == "-eq") return left == right;
  if (relation == "-ne") return left != right;
  if (relation == "-lt" || relation == "<") return left < right;
  if (relation == "-gt" || relation == ">") return left > right;
  return relation == "-le" ? left <= right : left >= right;
}

}  // namespace

bool HoldsInShell(const ShellCommand& command, ShellValues* values) {
  ShellWords raw = RawShellWords(command.text);
  if (raw.empty()) return false;
  if (raw.front() != "[" && raw.front() != "[[" && raw.front() != "test") {
    return FirstShellWord(command.text) == "true";
  }
  // Each word is one argument. With an empty X, `[ $X = a ]` is an error of the shell, and false
  // here.
  ShellWords words;
  for (size_t i = 1; i < raw.size(); ++i) {
    if (raw[i] == "]" || raw[i] == "]]") break;
    words.push_back(JoinShellWords(values->Expand(raw[i], command.line)));
    if (raw[i] == "=" || raw[i] == "==") words.back() = "=";
  }
  bool result = true;
  bool is_first = true;
  for (size_t at = 0; at < words.size();) {
    bool is_or = false;
    if (!is_first) {
      is_or = words[at] == "-o" || words[at] == "||";
      ++at;
    }
    bool is_not = false;
    while (at < words.size() && words[at] == "!") {
      is_not = !is_not;
      ++at;
    }
    const bool holds = Primary(words, values->run(), &at) != is_not;
    if (is_first) result = holds;
    if (!is_first) result = is_or ? result || holds : result && holds;
    is_first = false;
  }
  return result && !is_first;
}

}  // namespace shoal
