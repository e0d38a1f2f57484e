// Everything that is wrong with a mission file, gathered and told in one go.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lib/mission/value.h"

namespace shoal {

class Problems {
 public:
  /// `file` and `overrides` as the user gave them: messages repeat them.
  Problems(std::string file, std::vector<std::string> overrides);

  /// Notes what is wrong at `place` and how to mend it. A template's error that many vehicles
  /// inherit is told once.
  void Add(const Place& place, std::string text);

  bool empty() const { return problems_.empty(); }

  /// Returns "file:line" or "--set key=value".
  std::string LineOf(const Place& place) const;

  /// Returns all messages in the order of the file and then of the overrides; the first hundred
  /// and a count where there are more.
  std::vector<std::string> InOrder() const;

 private:
  std::string WhereIs(const Place& place) const;

  std::string file_;
  std::vector<std::string> overrides_;
  std::set<std::pair<Place, std::string>> problems_;
};

}  // namespace shoal
