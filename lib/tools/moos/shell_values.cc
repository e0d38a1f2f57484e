#include "lib/tools/moos/shell_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "lib/base/text/letters.h"
#include "lib/base/text/numbers.h"
#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/shell_output.h"

namespace shoal {

ShellWords ShellValues::Expand(std::string_view raw, int line) {
  ShellWords words;
  std::string word;
  bool is_there = false;
  for (size_t i = 0; i < raw.size();) {
    const size_t length = ShellPartLength(raw, i);
    const std::string_view part = raw.substr(i, length);
    i += length;
    if (part.size() == 2 && part[0] == '\\') {
      word += part[1];
      is_there = true;
    } else if (part[0] == '\'' && part.size() >= 2) {
      word += part.substr(1, part.size() - 2);
      is_there = true;
    } else if (part[0] == '"' && part.size() >= 2) {
      word += Quoted(part.substr(1, part.size() - 2), line);
      is_there = true;
    } else if (part[0] == '$' || part[0] == '`') {
      std::string_view reference = part;
      if (part == "$") {
        size_t used = 1;
        while (i + used - 1 < raw.size() && IsNameCharacter(raw[i + used - 1])) ++used;
        if (used == 1 && i < raw.size()) used = 2;  // $?, $$, $@, $#
        reference = raw.substr(i - 1, used);
        i += used - 1;
      }
      const std::string value = Reference(reference, line);
      const bool joins_left = !value.empty() && value.front() != ' ';
      ShellWords parts = AtShellBlanks(value);
      if (parts.empty()) continue;
      if (!joins_left && is_there) words.push_back(std::exchange(word, {}));
      for (size_t k = 0; k < parts.size(); ++k) {
        if (k > 0) words.push_back(std::exchange(word, {}));
        word += parts[k];
      }
      is_there = true;
    } else {
      word += part;
      is_there = true;
    }
    if (word.size() > kMaxShellText) return words;
  }
  if (is_there) words.push_back(word);
  return words;
}

/// Returns what is in double quotes with its values.
std::string ShellValues::Quoted(std::string_view text, int line) {
  std::string value;
  for (size_t i = 0; i < text.size();) {
    size_t length = text[i] == '"' || text[i] == '\'' ? 1 : ShellPartLength(text, i);
    std::string_view part = text.substr(i, length);
    if (part.size() == 2 && part[0] == '\\') {
      value += part[1];
    } else if (part == "$" && i + 1 < text.size()) {
      length = 1;
      while (i + length < text.size() && IsNameCharacter(text[i + length])) ++length;
      if (length == 1) ++length;
      value += Reference(text.substr(i, length), line);
    } else if (part[0] == '$' || part[0] == '`') {
      value += Reference(part, line);
    } else {
      value += part;
    }
    i += length;
    if (value.size() > kMaxShellText) break;
  }
  return value;
}

const ShellWords& ShellValues::Values(std::string_view name) const {
  static const ShellWords kNone;
  const auto at = variables_.find(name);
  return at == variables_.end() ? kNone : at->second;
}

/// Returns the value of $X, ${X...}, $((...)), $(...) or `...`, each of which may hold others.
std::string ShellValues::Reference(std::string_view text, int line) {
  constexpr int kDeepestReference = 16;
  if (nesting_ == kDeepestReference) {
    run_.Note(line,
              fmt::format("values lie within one another more than {} deep", kDeepestReference));
    return "";
  }
  ++nesting_;
  std::string value = ValueOf(text, line);
  --nesting_;
  return value;
}

std::string ShellValues::ValueOf(std::string_view text, int line) {
  if (text.starts_with("$(("))
    return Sum(text.substr(3, text.size() - std::min<size_t>(5, text.size())), line);
  if (text.starts_with("$(") || text.starts_with('`')) {
    const size_t begin = text.starts_with('`') ? 1 : 2;
    const std::string_view command = text.substr(begin, text.size() - begin - 1);
    return ShellOutput(ExpandAll(RawShellWords(command), line), line, &run_);
  }
  if (!text.starts_with("${")) {
    const std::string_view name = text.substr(1);
    if (name == "@" || name == "*") return JoinShellWords(run_.script().arguments);
    if (name == "#") return std::to_string(run_.script().arguments.size());
    if (name == "?") return "0";
    if (name == "0") return run_.script().name;
    if (name.size() == 1 && IsDigit(name[0])) {
      const size_t index = static_cast<size_t>(name[0] - '1');
      return index < run_.script().arguments.size() ? run_.script().arguments[index] : "";
    }
    const std::string* value = FirstValue(name, line);
    return value == nullptr ? "" : *value;
  }
  std::string_view inner = text.substr(2, text.size() - std::min<size_t>(3, text.size()));
  const bool is_length = inner.starts_with('#') && inner.size() > 1;
  if (is_length) inner.remove_prefix(1);
  size_t end = 0;
  while (end < inner.size() && IsNameCharacter(inner[end])) ++end;
  const std::string_view name = inner.substr(0, end);
  std::string_view rest = inner.substr(end);
  const ShellWords& values = Values(name);
  std::string value = values.empty() ? "" : values.front();
  if (name.size() == 1 && IsDigit(name[0])) value = Reference("$" + std::string(name), line);
  if (rest.starts_with('[')) {
    const size_t close = rest.find(']');
    if (close == rest.npos) return "";
    const std::string_view index = rest.substr(1, close - 1);
    rest.remove_prefix(close + 1);
    if (index == "@" || index == "*") {
      if (is_length) return std::to_string(values.size());
      value = JoinShellWords(values);
    } else {
      const auto number = NumberIn(Sum(index, line));
      const bool is_inside = number && *number >= 0 && *number < static_cast<double>(values.size());
      value = is_inside ? values[static_cast<size_t>(*number)] : "";
    }
  }
  if (is_length) return std::to_string(value.size());
  if (rest.empty()) return value;
  if (rest.starts_with(":-") || rest.starts_with(":=")) {
    return value.empty() ? JoinShellWords(Expand(rest.substr(2), line)) : value;
  }
  if (rest.starts_with(':')) return Slice(value, rest.substr(1), line);
  // A pattern is compared with every part of the value: long values count as many commands.
  constexpr size_t kStepsOfACommand = 100'000;
  const auto steps = static_cast<int>(value.size() * value.size() / kStepsOfACommand);
  if (!run_.Count(steps)) return value;
  if (rest.starts_with("//")) return WithoutAll(value, rest.substr(2));
  if (rest.starts_with('#')) return WithoutPrefix(value, rest);
  if (rest.starts_with('%')) return WithoutSuffix(value, rest);
  run_.Note(line, fmt::format("{} is not read", shoal::Quoted(text)));
  return value;
}

std::string ShellValues::Slice(const std::string& value, std::string_view text, int line) {
  const size_t colon = text.find(':');
  const double from = NumberIn(Sum(text.substr(0, colon), line)).value_or(0);
  const double count =
      colon == text.npos ? 1e6 : NumberIn(Sum(text.substr(colon + 1), line)).value_or(1e6);
  if (from < 0 || count < 0 || from >= static_cast<double>(value.size())) return "";
  return value.substr(static_cast<size_t>(from), static_cast<size_t>(std::min(count, 1e6)));
}

/// Computes a sum of whole numbers and variables.
std::string ShellValues::Sum(std::string_view text, int line) {
  const std::string plain = Quoted(text, line);
  return run_.Sum(plain, line, [&](std::string_view name) {
    const std::string* value = FirstValue(name, line);
    return value == nullptr ? std::string_view() : std::string_view(*value);
  });
}

/// Returns the first value of a variable; one that bash draws is drawn, the same in each import.
/// Valid until the next call; nullptr: it has none.
const std::string* ShellValues::FirstValue(std::string_view name, int line) {
  const ShellWords& values = Values(name);
  if (!values.empty()) return &values.front();
  if (name != "RANDOM" && name != "SRANDOM") return nullptr;
  run_.Note(line, fmt::format("{} is random: drawn here, the same in each import", name));
  constexpr uint64_t kNumRandom = 32'768;
  constexpr uint64_t kNumLong = 4'294'967'296;
  drawn_ = std::to_string(stream_.UniformInt(name == "RANDOM" ? kNumRandom : kNumLong));
  return &drawn_;
}

ShellWords ShellValues::ExpandAll(const ShellWords& raw, int line) {
  ShellWords words;
  for (const std::string& each : raw) {
    for (std::string& word : Expand(each, line)) words.push_back(std::move(word));
  }
  return words;
}

bool ShellValues::Assign(const std::string& raw, int line) {
  size_t end = 0;
  while (end < raw.size() && IsNameCharacter(raw[end])) ++end;
  if (end == 0 || IsDigit(raw[0])) return false;
  const std::string name = raw.substr(0, end);
  std::string_view rest = std::string_view(raw).substr(end);
  std::optional<size_t> index;
  if (rest.starts_with('[')) {
    const size_t close = rest.find(']');
    if (close == rest.npos) return false;
    const double number = NumberIn(Sum(rest.substr(1, close - 1), line)).value_or(-1);
    if (number < 0 || number > 1'000) return false;
    index = static_cast<size_t>(number);
    rest.remove_prefix(close + 1);
  }
  const bool appends = rest.starts_with("+=");
  if (!appends && !rest.starts_with('=')) return false;
  rest.remove_prefix(appends ? 2 : 1);
  ShellWords values;
  if (rest.starts_with('(') && rest.ends_with(')')) {
    values = ExpandAll(RawShellWords(rest.substr(1, rest.size() - 2)), line);
    ShellWords& kept = variables_[name];
    if (!appends) kept.clear();
    kept.insert(kept.end(), values.begin(), values.end());
    return true;
  }
  // An assigned word is not cut at blanks.
  std::string value;
  for (size_t i = 0; i < rest.size();) {
    const size_t length = ShellPartLength(rest, i);
    const std::string_view part = rest.substr(i, length);
    if (part[0] == '"' || part[0] == '\'') {
      const std::string_view inner = part.size() < 2 ? part : part.substr(1, part.size() - 2);
      value += part[0] == '"' ? Quoted(inner, line) : std::string(inner);
      i += length;
    } else {
      size_t stop = i + length;
      while (stop < rest.size() && rest[stop] != '"' && rest[stop] != '\'') {
        stop += ShellPartLength(rest, stop);
      }
      value += Quoted(rest.substr(i, stop - i), line);
      i = stop;
    }
  }
  ShellWords& kept = variables_[name];
  const size_t place = index.value_or(0);
  if (kept.size() <= place) kept.resize(place + 1);
  kept[place] = appends ? kept[place] + value : value;
  if (kept[place].size() > kMaxShellText) kept[place].resize(kMaxShellText);
  return true;
}

}  // namespace shoal
