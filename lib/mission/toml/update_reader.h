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

  void Number(std::string_view key, double& value, NumberLimits range) override;
  void NumberOrWord(std::string_view key, double& value, double max, std::string_view word,
                    double meaning) override;
  void Scalar(std::string_view key, std::string& word) override;
  void Integer(std::string_view key, int64_t& value, int64_t min, int64_t max) override;
  void Flag(std::string_view key, bool& value) override;
  void Text(std::string_view key, std::string& value, TextRule rule) override;
  void Word(std::string_view key, std::string& value,
            std::span<const std::string_view> words) override;
  void Numbers(std::string_view key, std::vector<double>& values, size_t max_count) override;
  void Pair(std::string_view key, Eigen::Vector2d& pair, NumberLimits range) override;
  void Pairs(std::string_view key, std::vector<Eigen::Vector2d>& pairs, NumberLimits range,
             size_t max_count) override;
  void Triple(std::string_view key, Eigen::Vector3d& triple, NumberLimits range) override;
  void Triples(std::string_view key, std::vector<Eigen::Vector3d>& triples, NumberLimits range,
               size_t max_count) override;
  void Texts(std::string_view key, std::vector<std::string>& texts, size_t max_count) override;
  void TextMap(std::string_view key, std::map<std::string, std::string>& texts,
               size_t max_count) override;
  void Scalars(std::string_view key,
               std::map<std::string, std::variant<std::string, double>>& values,
               size_t max_count) override;
  /// No behavior has tables below it.
  void Below(std::string_view key, const DescribeTable& describe) override;
  void Inline(std::string_view key, const DescribeTable& describe) override;
  void EachBelow(std::string_view key, size_t count, const std::function<void(size_t)>& resize,
                 const std::function<void(Fields&, size_t)>& describe_one) override;
  bool reading() const override { return true; }
  bool demands_keys() const override { return false; }
  bool Has(std::string_view key, bool present) override;
  bool HoldsText(std::string_view key) override;
  bool HoldsArray(std::string_view) override { return false; }
  bool IsSound() const override { return problems_.empty(); }
  void Require(std::string_view, std::string_view) override {}
  void NoKey(std::string_view name, std::string hint) override;
  void Skip(std::string_view key) override;
  void SkipRest() override {}
  void Refuse(std::string_view key, std::string text) override;
  void Warn(std::string_view, std::string) override {}
  std::string Where() const override { return {}; }

 private:
  /// Returns the text of `key`, which is known from now on, or nullptr.
  const std::string* Take(std::string_view key);
  /// Reads `value` under `key` as a table of the file does.
  template <class Read>
  void AsInTheFile(std::string_view key, Value value, const Read& read);
  /// The same for the text that is given for `key`, if any, taken as a value of the file's.
  template <class Read>
  void Parsed(std::string_view key, const Read& read);

  std::span<const UpdateItem> items_;
  Problems& problems_;
  std::vector<std::string> known_;
  std::map<std::string, std::string, std::less<>> hints_;
};

}  // namespace shoal
