#include "lib/tools/moos/shell_text.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "lib/base/text/blanks.h"
#include "lib/base/text/letters.h"

namespace shoal {

size_t ShellPartLength(std::string_view text, size_t at) {
  const char c = text[at];
  if (c == '\\') return std::min<size_t>(2, text.size() - at);
  if (c == '\'' || c == '`') {
    const size_t end = text.find(c, at + 1);
    return end == text.npos ? text.size() - at : end + 1 - at;
  }
  if (c == '"') {
    for (size_t i = at + 1; i < text.size(); ++i) {
      if (text[i] == '\\') {
        ++i;
      } else if (text[i] == '"') {
        return i + 1 - at;
      }
    }
    return text.size() - at;
  }
  if (c == '$' && at + 1 < text.size() && (text[at + 1] == '(' || text[at + 1] == '{')) {
    const char open = text[at + 1];
    const char close = open == '(' ? ')' : '}';
    int depth = 0;
    for (size_t i = at + 1; i < text.size(); ++i) {
      if (text[i] == open) ++depth;
      if (text[i] == close && --depth == 0) return i + 1 - at;
    }
    return text.size() - at;
  }
  return 1;
}

std::vector<ShellCommand> ShellCommandsOf(std::string_view text) {
  std::vector<ShellCommand> commands;
  ShellCommand command{.line = 1, .text = ""};
  int line = 1;
  int brackets = 0;
  const auto end = [&] {
    std::string_view rest = Trimmed(command.text);
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
      const bool is_keyword = word == "then" || word == "do" || word == "else";
      const std::string_view one = is_keyword ? word : rest;
      commands.push_back({.line = command.line, .text = std::string(one)});
      rest = Trimmed(rest.substr(one.size()));
    }
    command.text.clear();
  };
  for (size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (Trimmed(command.text).empty()) command.line = line;
    if (c == '\\' && i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r')) {
      command.text += ' ';
      i = text.find('\n', i) + 1;
      ++line;
      continue;
    }
    const bool is_word_start = command.text.empty() || command.text.back() == ' ' ||
                               command.text.back() == '\t' || command.text.back() == ';';
    if (c == '#' && is_word_start) {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '(' && command.text.ends_with('=')) ++brackets;
    if (c == ')' && brackets > 0) --brackets;
    if (c == '\n' || c == ';') {
      if (brackets > 0) {
        command.text += ' ';
      } else {
        end();
      }
      if (brackets == 0 && text.substr(i).starts_with(";;")) {
        commands.push_back({.line = line, .text = ";;"});
        ++i;
      }
      line += c == '\n' ? 1 : 0;
      ++i;
      continue;
    }
    const size_t length = ShellPartLength(text, i);
    const std::string_view part = text.substr(i, length);
    line += static_cast<int>(std::count(part.begin(), part.end(), '\n'));
    command.text += part;
    i += length;
  }
  end();
  return commands;
}

std::string FirstShellWord(std::string_view text) {
  text = Trimmed(text);
  return std::string(text.substr(0, text.find_first_of(" \t")));
}

std::string JoinShellWords(const ShellWords& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool MatchesShell(std::string_view pattern, std::string_view text) {
  size_t at = 0;
  size_t star = pattern.npos;
  size_t star_at = 0;
  size_t p = 0;
  while (at < text.size()) {
    if (p < pattern.size() &&
        (pattern[p] == '?' || (pattern[p] != '*' && pattern[p] == text[at]))) {
      ++p;
      ++at;
    } else if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_at = at;
    } else if (star != pattern.npos) {
      p = star + 1;
      at = ++star_at;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

ShellWords RawShellWords(std::string_view text) {
  ShellWords words;
  std::string word;
  bool is_open = false;
  int brackets = 0;
  for (size_t i = 0; i < text.size();) {
    const size_t length = ShellPartLength(text, i);
    const std::string_view part = text.substr(i, length);
    i += length;
    if (part == "(" && word.ends_with('=')) ++brackets;
    if (part == ")" && brackets > 0) --brackets;
    if (brackets == 0 && (part == " " || part == "\t" || part == "\r" || part == "\n")) {
      if (is_open) words.push_back(std::exchange(word, {}));
      is_open = false;
    } else {
      word += part;
      is_open = true;
    }
  }
  if (is_open) words.push_back(word);
  return words;
}

ShellWords AtShellBlanks(std::string_view text) {
  ShellWords words;
  while (true) {
    const size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == text.npos) return words;
    text.remove_prefix(begin);
    const size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    words.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
}

std::string WithoutAll(std::string value, std::string_view text) {
  const size_t slash = text.find('/');
  const std::string_view pattern = text.substr(0, slash);
  const std::string replacement(slash == text.npos ? "" : text.substr(slash + 1));
  if (pattern == "[^0-9]") {
    std::erase_if(value, [](char c) { return !IsDigit(c); });
    return value;
  }
  if (pattern.empty()) return value;
  for (size_t at = value.find(pattern); at != value.npos && value.size() < kMaxShellText;
       at = value.find(pattern, at + replacement.size())) {
    value.replace(at, pattern.size(), replacement);
  }
  return value;
}

std::string WithoutPrefix(const std::string& value, std::string_view text) {
  const bool is_longest = text.starts_with("##");
  const std::string_view pattern = text.substr(is_longest ? 2 : 1);
  std::optional<size_t> cut;
  for (size_t length = 0; length <= value.size(); ++length) {
    if (!MatchesShell(pattern, std::string_view(value).substr(0, length))) continue;
    cut = length;
    if (!is_longest) break;
  }
  return cut ? value.substr(*cut) : value;
}

std::string WithoutSuffix(const std::string& value, std::string_view text) {
  const bool is_longest = text.starts_with("%%");
  const std::string_view pattern = text.substr(is_longest ? 2 : 1);
  std::optional<size_t> cut;
  for (size_t length = 0; length <= value.size(); ++length) {
    if (!MatchesShell(pattern, std::string_view(value).substr(value.size() - length))) continue;
    cut = length;
    if (!is_longest) break;
  }
  return cut ? value.substr(0, value.size() - *cut) : value;
}

size_t ShellBlockEnd(const std::vector<ShellCommand>& commands, size_t at, size_t end,
                     const std::set<std::string>& middle) {
  int depth = 0;
  for (size_t i = at; i < end; ++i) {
    const std::string word = FirstShellWord(commands[i].text);
    const bool opens = word == "if" || word == "for" || word == "while" || word == "until" ||
                       word == "case" || word == "select";
    if (opens) ++depth;
    if (i > at && depth == 1 && middle.contains(word)) return i;
    if (word == "fi" || word == "done" || word == "esac") {
      if (--depth == 0) return i;
    }
  }
  return end;
}

int ShellBraces(std::string_view text, bool* is_open) {
  int depth = 0;
  for (size_t i = 0; i < text.size(); i += ShellPartLength(text, i)) {
    if (text[i] == '{') {
      ++depth;
      *is_open = true;
    } else if (text[i] == '}') {
      --depth;
    }
  }
  return depth;
}

}  // namespace shoal
