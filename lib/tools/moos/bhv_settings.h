// The settings of one behavior as they are gathered from its lines: a key for several lines, or the
// last of several lines for one key.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lib/tools/moos/import_behaviors.h"
#include "lib/tools/moos/mission_draft.h"
#include "lib/tools/moos/moos_file.h"

namespace shoal {

class BhvSettings {
 public:
  explicit BhvSettings(std::string header) : table_{.header = std::move(header), .lines = {}} {}

  /// Adds a line above all that is gathered.
  void Add(DraftLine line) { table_.lines.push_back(std::move(line)); }
  /// Adds a comment.
  void Remark(const MoosLine& line, std::string reason);

  /// Sets a key; a value of an earlier line becomes a comment.
  void Set(const std::string& key, std::string value, const MoosLine& line, bool is_essential,
           std::string remark = "");
  /// Adds to the list of a key.
  void Append(const std::string& key, const std::vector<std::string>& texts, const MoosLine& line,
              bool is_essential);
  /// Sets a key that MOOS-IvP does not set, but that has another default there.
  void Assume(const std::string& key, std::string value, std::string remark);
  /// Gives a key another value; its lines stay. An empty remark leaves the remark.
  void Move(const std::string& key, std::string value, std::string remark);

  bool IsSet(const std::string& key) const { return gathered_.contains(key); }
  /// Returns the value as TOML; empty where it is not set.
  std::string_view ValueOf(const std::string& key) const;
  double NumberAt(const std::string& key, double otherwise) const;

  /// Returns the table of all.
  BhvTable Finished() &&;

 private:
  struct Gathered {
    std::vector<std::string> texts;  ///< Of a list.
    std::string value;               ///< Of anything else, as TOML.
    std::string origins;
    std::string line_texts;
    std::string remark;
    bool is_essential = false;
  };

  Gathered& At(const std::string& key);

  BhvTable table_;
  std::vector<std::string> order_;
  std::map<std::string, Gathered> gathered_;
};

}  // namespace shoal
