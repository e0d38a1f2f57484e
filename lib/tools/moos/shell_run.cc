#include "lib/tools/moos/shell_run.h"

#include <fmt/format.h>

#include <algorithm>

#include "lib/mission/toml/suggest.h"
#include "lib/tools/moos/shell_sum.h"

namespace shoal {

void ShellRun::Note(int line, const std::string& text) {
  std::string note = fmt::format("{}:{}: {}", script_.name, line, text);
  if (noted_.insert(text).second) notes_.push_back(CleanUtf8(note));
}

bool ShellRun::Count(int num_commands) {
  num_commands_ = std::min(num_commands_ + num_commands, 10 * kMaxShellCommands);
  return !IsTooLong();
}

std::optional<MoosSource> ShellRun::Find(std::string_view name) const {
  if (find_ == nullptr) return std::nullopt;
  if (name.starts_with("./")) name.remove_prefix(2);
  return find_(name, script_.from);
}

const std::string* ShellRun::FindMade(std::string_view name) const {
  const auto made = made_files_.find(name);
  return made == made_files_.end() ? nullptr : &made->second;
}

bool ShellRun::HasFile(std::string_view name) const {
  return FindMade(name) != nullptr || Find(name).has_value();
}

void ShellRun::Write(const std::string& name, bool appends, const std::string& line) {
  std::string& text = made_files_[name];
  if (!appends) text.clear();
  if (text.size() < kMaxShellText) text += line + "\n";
}

std::string ShellRun::Sum(std::string_view plain, int line,
                          const std::function<std::string_view(std::string_view)>& value_of) {
  bool is_exact = true;
  const long long sum = ShellSum(plain, value_of, &is_exact);
  if (!is_exact) {
    Note(line, fmt::format("{} divides by 0 or leaves +-1e9: taken as {}", Quoted(plain), sum));
  }
  return fmt::format("{}", sum);
}

}  // namespace shoal
