#include "lib/mission/toml/table_place.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "lib/mission/toml/parse.h"
#include "lib/mission/toml/table_reader.h"

namespace shoal::table_place_test {

using Texts = std::vector<std::string>;

/// A file of two tables [[vehicle]], the second with two tasks.
struct ReadFile {
  Problems problems{"m.toml", {}};
  std::optional<Value> root = ParseToml(R"([swarm]
leader = "a"
[[vehicle]]
name = "a"
[[vehicle]]
name = "b"
[[vehicle.task]]
kind = "return"
[[vehicle.task]]
kind = "loiter"
)",
                                        problems);
  TablePlace file{*root, problems};
};

TEST(TablePlace, RefusesAKeyWhereItStands) {
  ReadFile read;
  read.file.Below("vehicle", 1).Below("task", 1).Refuse("kind", "too round");
  read.file.Below("swarm").Refuse("leader", "too slow");
  EXPECT_EQ(read.problems.InOrder(), (Texts{"m.toml:2:10: too slow", "m.toml:10:8: too round"}));
}

TEST(TablePlace, RefusesTheTableWhereTheKeyIsAbsent) {
  ReadFile read;
  read.file.Below("vehicle", 1).Refuse("start", "too deep");
  EXPECT_EQ(read.problems.InOrder(), Texts{"m.toml:5:1: too deep"});
}

TEST(TablePlace, StandsWhereTheTableAboveDoesWhereTheFileHasNone) {
  ReadFile read;
  for (const TablePlace& none : {read.file.Below("swarm").Below("leader", 0),
                                 read.file.Below("swarm").Below("slots").Below("first")}) {
    EXPECT_FALSE(none.Has("leader"));
    none.Warn("leader", "lost");
  }
  EXPECT_EQ(read.problems.WarningsInOrder(), Texts{"m.toml:1:1: warning: lost"});
  EXPECT_FALSE(read.file.Below("vehicle", 2).Has("name"));
}

TEST(TablePlace, IsUnsoundOnceSomethingBelowItIsRefused) {
  ReadFile read;
  EXPECT_TRUE(read.file.Below("vehicle", 1).IsSound());
  read.file.Below("vehicle", 1).Below("task", 0).Refuse("kind", "wrong");
  EXPECT_FALSE(read.file.Below("vehicle", 1).Below("task", 0).IsSound());
  EXPECT_FALSE(read.file.Below("vehicle", 1).IsSound());
  EXPECT_TRUE(read.file.Below("vehicle", 1).Below("task", 1).IsSound());
  EXPECT_TRUE(read.file.Below("vehicle", 0).IsSound());
}

TEST(TablePlace, IsSoundAfterAWarning) {
  ReadFile read;
  read.file.Below("swarm").Warn("leader", "odd");
  EXPECT_TRUE(read.file.Below("swarm").IsSound());
}

TEST(TablePlace, IsUnsoundWhereItsReaderFoundAWrongValue) {
  ReadFile read;
  {
    TableReader reader(*read.root, "the file", read.problems);
    reader.SkipRest();
    reader.Below("swarm", [](Fields& fields) {
      double number = 0;
      fields.Number("leader", number, Between(0, 1));
    });
  }
  EXPECT_FALSE(read.file.Below("swarm").IsSound());
  EXPECT_TRUE(read.file.Below("vehicle", 0).IsSound());
}

}  // namespace shoal::table_place_test
