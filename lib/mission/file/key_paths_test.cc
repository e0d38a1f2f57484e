#include "lib/mission/file/key_paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "lib/mission/file/load.h"

namespace shoal::key_paths_test {

std::string TextOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> PathsOf(const std::string& name) {
  const std::string path = SHOAL_SOURCE_DIR "/missions/" + name + ".toml";
  const LoadedMission loaded = LoadMission(path, {});
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  return KeyPaths(loaded.mission, TextOf(path));
}

bool Has(const std::vector<std::string>& paths, const std::string& path) {
  return std::find(paths.begin(), paths.end(), path) != paths.end();
}

TEST(KeyPaths, HaveDefaultsAndNameTheElementsOfLists) {
  const std::vector<std::string> paths = PathsOf("berta");
  EXPECT_TRUE(Has(paths, "mission.seed"));
  EXPECT_TRUE(Has(paths, "comms.drop_percentage")) << "a default";
  EXPECT_TRUE(Has(paths, "vehicle.alpha.start.x_m")) << "within an inline table";
  EXPECT_TRUE(Has(paths, "event.1.at_s")) << "an element without a name";
}

TEST(KeyPaths, AreAllAcceptedAsOverrides) {
  for (const std::string name : {"berta", "acoustic", "remus_path"}) {
    const std::vector<std::string> paths = PathsOf(name);
    ASSERT_GT(paths.size(), 50U);
    for (const std::string& path : paths) {
      // A value that no key takes: the error is of the value, not of the way to it.
      const LoadedMission loaded =
          LoadMission(SHOAL_SOURCE_DIR "/missions/" + name + ".toml", {path + "=[[[[true]]]]"});
      ASSERT_FALSE(loaded.errors.empty()) << path;
      for (const std::string& error : loaded.errors) {
        EXPECT_EQ(error.find("there is no [["), error.npos) << error;
        EXPECT_EQ(error.find("unknown key"), error.npos) << error;
      }
    }
  }
}

TEST(KeyPaths, LeaveOutTheVehiclesOfAFleetWhichTheFileDoesNotName) {
  for (const std::string& path : PathsOf("fleet")) {
    EXPECT_FALSE(path.starts_with("vehicle.")) << path;
  }
}

}  // namespace shoal::key_paths_test
