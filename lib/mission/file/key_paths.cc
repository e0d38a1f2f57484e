#include "lib/mission/file/key_paths.h"

#include <algorithm>
#include <optional>

#include "lib/mission/file/load.h"
#include "lib/mission/toml/override.h"
#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/value.h"

namespace shoal {

namespace {

bool IsArrayOfTables(const Value& value) {
  const auto* array = std::get_if<Array>(&value.data);
  return array != nullptr && !array->empty() && std::holds_alternative<Table>(array->front().data);
}

/// Returns the path of `key` in the table at `path`; the mission is at "".
std::string PathOfKey(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

/// Walks a mission with every default, and beside it the tree of its file.
class KeyWalk {
 public:
  /// `written`: the same table in the file, or nullptr.
  void Enter(const Table& table, const Table* written, const std::string& path) {
    for (const Entry& entry : table) {
      const std::string here = PathOfKey(path, entry.key);
      const Value* in_file = written == nullptr ? nullptr : Find(*written, entry.key);
      if (const auto* below = std::get_if<Table>(&entry.value.data)) {
        Enter(*below, in_file == nullptr ? nullptr : std::get_if<Table>(&in_file->data), here);
      } else if (!IsArrayOfTables(entry.value)) {
        paths_.push_back(here);
      } else if (in_file != nullptr) {
        EnterEach(entry, *in_file, here);
      }
    }
  }

  std::vector<std::string> TakePaths() { return std::move(paths_); }

 private:
  void EnterEach(const Entry& entry, const Value& in_file, const std::string& path) {
    const auto* written = std::get_if<Array>(&in_file.data);
    if (written == nullptr) return;
    const auto& elements = std::get<Array>(entry.value.data);
    for (size_t i = 0; i < written->size(); ++i) {
      const std::string* name = NameOfElement((*written)[i], entry.key);
      const auto is_same = [&](const Value& element) {
        const std::string* other = NameOfElement(element, entry.key);
        return other != nullptr && *other == *name;
      };
      auto found = elements.begin() + static_cast<std::ptrdiff_t>(std::min(i, elements.size()));
      if (name != nullptr) found = std::find_if(elements.begin(), elements.end(), is_same);
      if (found == elements.end()) continue;
      const std::string part = name == nullptr ? std::to_string(i + 1) : *name;
      const auto* table = std::get_if<Table>(&found->data);
      if (table != nullptr) {
        Enter(*table, std::get_if<Table>(&(*written)[i].data), PathOfKey(path, part));
      }
    }
  }

  std::vector<std::string> paths_;
};

}  // namespace

std::vector<std::string> KeyPaths(const Mission& mission, std::string_view text) {
  Problems problems(mission.file, {});
  const std::optional<Value> written = ParseToml(text, problems);
  const std::optional<Value> whole = ParseToml(Explain(mission), problems);
  KeyWalk walk;
  if (written && whole) {
    walk.Enter(std::get<Table>(whole->data), &std::get<Table>(written->data), "");
  }
  return walk.TakePaths();
}

}  // namespace shoal
