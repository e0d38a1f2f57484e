// Reads updates of a running behavior by the same description as the mission file's table, so that
// keys, ranges and messages are the same. Values are written as in the file, or as MOOS-IvP's
// texts:
//
//   points = [[0, 0], [10, 0]]      points = 0,0:10,0        polygon = radial:: x=0,y=0,...
//   capture_line = true             use_alt_speed = toggle   name = henry (which behavior)
#pragma once

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/helm/behaviors/update_text.h"
#include "lib/mission/toml/fields.h"
#include "lib/mission/toml/problems.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal {

class UpdateReader final : public Fields {
 public:
  /// `items` and `problems` outlive the reader. Its destructor reports keys that were not asked
  /// for.
  UpdateReader(std::span<const UpdateItem> items, Problems& problems);
  ~UpdateReader() override;
  UpdateReader(const UpdateReader&) = delete;
  UpdateReader& operator=(const UpdateReader&) = delete;

  void Key(std::string_view key, const Field& field) override;
  /// No behavior has tables below it.
  void Below(std::string_view key, const DescribeTable& describe) override;
  void Inline(std::string_view key, const DescribeTable& describe) override;
  void EachBelow(std::string_view key, size_t count, const std::function<void(size_t)>& resize,
                 const std::function<void(Fields&, size_t)>& describe_one) override;
  bool reading() const override { return true; }
  bool demands_keys() const override { return false; }
  bool Has(std::string_view key, bool present) override;
  bool HoldsText(std::string_view key) override;
  bool IsSound() const override { return problems_.empty(); }
  void NoKey(std::string_view name, const std::string& hint) override;
  void Skip(std::string_view key) override;
  void Refuse(std::string_view key, const std::string& text) override;

 private:
  /// Returns the text of `key`, which is known from now on, or nullptr.
  const std::string* Take(std::string_view key);

  std::span<const UpdateItem> items_;
  Problems& problems_;
  std::vector<std::string> known_;
  std::map<std::string, std::string, std::less<>> hints_;
};

}  // namespace shoal
