#include "lib/mission/file/key_homes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lib/mission/file/load.h"

namespace shoal::key_homes_test {

TEST(KeyHomes, AreTheTablesOfMissionFiles) {
  EXPECT_EQ(HomeOfKey("packet_loss"), "[acoustics]");
  EXPECT_EQ(HomeOfKey("comms_range"), "[comms]");
  EXPECT_EQ(HomeOfKey("length_m"), "[[vehicle]]");
  EXPECT_EQ(HomeOfKey("no_such_key"), "");
}

std::string FirstError(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const LoadedMission loaded = LoadMissionText(
      "[mission]\nduration_s = 60\n" + text + "\n[[vehicle]]\nname = \"a\"\n", "m", overrides);
  return loaded.errors.empty() ? "no error" : loaded.errors.front();
}

TEST(KeyHomes, AreNamedWhereAKeyStandsInAnotherTable) {
  EXPECT_EQ(FirstError("[comms]\npacket_loss = 0.1"),
            "m:4:1: unknown key 'packet_loss'; it is a key of [acoustics]");
  EXPECT_EQ(FirstError("", {"comms_range=50"}),
            "--set comms_range=50: unknown key 'comms_range'; it is a key of [comms]: write "
            "comms.comms_range=...");
  EXPECT_EQ(FirstError("", {"start.x_m=50"}),
            "--set start.x_m=50: unknown key 'start'; it is a key of [[vehicle]]: write "
            "vehicle.NAME.start=...");
  EXPECT_EQ(FirstError("", {"points=[[1, 2]]"}),
            "--set points=[[1, 2]]: unknown key 'points'; it is a key of [[vehicle.task]]: write "
            "vehicle.NAME.task.NAME.points=...");
}

TEST(BeginnersMistakes, AreMetWithPlaceRuleAndRemedy) {
  EXPECT_EQ(FirstError("seed = 7.0"),
            "m:3:8: seed must be a whole number without a point: write seed = 7");
  EXPECT_EQ(FirstError("seed = 7.5"), "m:3:8: seed must be a whole number, not 7.5");
  EXPECT_EQ(FirstError("name = carl"),
            "m:3:8: not TOML: a text needs quotes: write name = \"carl\"");
  EXPECT_EQ(
      FirstError("origin = [40, -30]"),
      "m:3:10: origin is a table: write origin = {lat_deg = ..., lon_deg = ...} in braces, not "
      "an array");
  EXPECT_EQ(FirstError("[[vehicle.task]]\nkind = \"loiter\""),
            "m:5:1: not TOML: a table of vehicle, such as [vehicle.x] or [[vehicle.x]], comes "
            "before the first [[vehicle]]: write [[vehicle]] first, and what belongs to it after "
            "it");
  EXPECT_EQ(FirstError("name = \"c\u00e4rl"),
            "m:3:13: not TOML: the text has no closing quote on its line");
  EXPECT_EQ(FirstError("name = 'carl"),
            "m:3:13: not TOML: the text has no closing quote on its line");
  EXPECT_EQ(FirstError("name = \"c\x01rl\""),
            "m:3:10: not TOML: Error while parsing string: unescaped control characters other than "
            "TAB (U+0009) are explicitly prohibited");
  EXPECT_EQ(FirstError("name = \u201ccarl\u201d"),
            "m:3:8: not TOML: quotes around a text are straight ones: \" or '");
  EXPECT_EQ(FirstError("origin = {40, -30}"),
            "m:3:13: not TOML: values in braces have keys: {key = value, key = value}");
  EXPECT_EQ(FirstError("seed = 1e30"), "m:3:8: seed must be a whole number, not 1e+30");
  EXPECT_EQ(
      LoadMissionText("[mission]\nduration_s = 60\n[[vehicle.task]]\nkind = \"loiter\"\n", "m")
          .errors.front(),
      "m:3:1: [[vehicle.task]] belongs to a [[vehicle]], and none is above it: write "
      "[[vehicle]] with its keys first");
}

TEST(BeginnersMistakes, OfAMissionsPathAreMetWithTheFileThatIsThere) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "key_homes_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "alpha.toml") << "";
  const std::string path = (folder / "alpha").string();
  ASSERT_FALSE(LoadMission(path).errors.empty());
  EXPECT_TRUE(LoadMission(path).errors.front().ends_with(" (did you mean " + path + ".toml?)"))
      << LoadMission(path).errors.front();
  std::filesystem::remove_all(folder);
}

}  // namespace shoal::key_homes_test
