// Everything that is wrong, or suspicious, with a mission file, gathered and reported in one go.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/mission/toml/value.h"

namespace shoal {

class Problems {
 public:
  /// `file` and `overrides` as the user gave them: messages repeat them.
  Problems(std::string file, std::vector<std::string> overrides);

  /// Notes what is wrong at `place` and how to fix it. A template's error that many vehicles
  /// inherit is noted once.
  void Add(const Place& place, std::string text);
  /// Notes what is legal but suspicious.
  void Warn(const Place& place, std::string text);
  /// The same where it makes the mission fail, whatever happens in it.
  void WarnOfFailure(const Place& place, std::string text);

  /// Sets what returns the table, "[comms]", that has a key; nothing for keys that none has. For
  /// keys that are in the wrong one.
  void SetHomes(std::function<std::string(std::string_view key)> home_of) {
    home_of_ = std::move(home_of);
  }
  std::string HomeOf(std::string_view key) const {
    return home_of_ ? home_of_(key) : std::string();
  }

  /// Notes that something of `table`, or below it, was refused.
  void MarkUnsound(const Value& table) { unsound_.insert(&table); }
  bool IsSound(const Value& table) const { return !unsound_.contains(&table); }

  bool empty() const { return problems_.empty(); }
  size_t size() const { return problems_.size(); }

  /// Returns "file:line" or "--set key=value".
  std::string LineOf(const Place& place) const;

  /// Return all errors, or all warnings, in the order of the file and then of the overrides; the
  /// first hundred and a count where there are more.
  std::vector<std::string> InOrder() const;
  std::vector<std::string> WarningsInOrder() const;
  /// Returns how many warnings are of failures.
  size_t num_failures() const { return num_failures_; }

 private:
  using Notes = std::set<std::pair<Place, std::string>>;

  std::string WhereIs(const Place& place) const;
  std::vector<std::string> Lines(const Notes& notes, std::string_view prefix,
                                 std::string_view noun) const;

  std::string file_;
  std::vector<std::string> overrides_;
  Notes problems_;
  Notes warnings_;
  size_t num_failures_ = 0;
  std::set<const Value*> unsound_;
  std::function<std::string(std::string_view key)> home_of_;
};

}  // namespace shoal
