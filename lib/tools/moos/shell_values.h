// The values of a shell script's words: its variables, and what refers to them.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "lib/base/random/stream.h"
#include "lib/tools/moos/shell_run.h"
#include "lib/tools/moos/shell_text.h"

namespace shoal {

class ShellValues {
 public:
  using Variables = std::map<std::string, ShellWords, std::less<>>;

  /// `find` may be empty, and outlives this.
  explicit ShellValues(const FindMoosFile& find) : run_(find) {}

  ShellRun& run() { return run_; }

  /// Returns the values of a raw word: without quotes it may become several, or none.
  ShellWords Expand(std::string_view raw, int line);
  /// Returns the values of all.
  ShellWords ExpandAll(const ShellWords& raw, int line);

  /// Sets variables; returns false where the word is not NAME=VALUE.
  bool Assign(const std::string& raw, int line);
  void Set(const std::string& name, std::string value) { variables_[name] = {std::move(value)}; }
  /// Scripts that this one calls have the variable too.
  void Export(const std::string& name) { exported_[name] = variables_[name]; }

  /// Begins with the variables that are exported, or with none. Returns those of before.
  Variables Begin(bool is_called) {
    return std::exchange(variables_, is_called ? exported_ : Variables());
  }
  void Resume(Variables variables) { variables_ = std::move(variables); }

 private:
  std::string Quoted(std::string_view text, int line);
  const ShellWords& Values(std::string_view name) const;
  std::string Reference(std::string_view text, int line);
  std::string ValueOf(std::string_view text, int line);
  std::string Slice(const std::string& value, std::string_view text, int line);
  std::string Sum(std::string_view text, int line);
  const std::string* FirstValue(std::string_view name, int line);

  ShellRun run_;
  Variables variables_;
  Variables exported_;
  int nesting_ = 0;  ///< Of references.
  Stream stream_{1, "RANDOM"};
  std::string drawn_;  ///< The last.
};

}  // namespace shoal
