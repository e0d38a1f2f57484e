#include "lib/mission/file/drawn_seed.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "lib/mission/file/load_testing.h"

namespace shoal::drawn_seed_test {

/// A mission file with this line in [mission]; removed at the end.
class SeedFile : public testing::Test {
 protected:
  std::string Write(const std::string& line) {
    std::ofstream(path_) << "[mission]\nduration_s = 60\n"
                         << line << "\n[[vehicle]]\nname = \"alpha\"\n";
    return path_;
  }
  void TearDown() override { std::filesystem::remove(path_); }

  const std::string path_ =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml";
};

TEST_F(SeedFile, WithRandomGetsTheDrawnNumberAsAnOverride) {
  std::vector<std::string> overrides = {"mission.name=x"};
  int num_drawn = 0;
  const auto draw = [&] { return ++num_drawn, uint64_t{4711}; };
  const LoadedMission loaded = LoadMissionToRun(Write("seed = \"random\""), draw, &overrides);
  EXPECT_EQ(loaded.errors, std::vector<std::string>());
  EXPECT_EQ(loaded.mission.seed, 4711U);
  EXPECT_FALSE(loaded.mission.draws_seed);
  EXPECT_EQ(num_drawn, 1);
  EXPECT_EQ(overrides, (std::vector<std::string>{"mission.name=x", "mission.seed=4711"}));
  EXPECT_NE(Explain(loaded.mission).find("seed = 4711\n"), std::string::npos);
}

TEST_F(SeedFile, WithANumberDrawsNone) {
  std::vector<std::string> overrides;
  const auto draw = []() -> uint64_t { throw std::runtime_error("not asked for"); };
  EXPECT_EQ(LoadMissionToRun(Write("seed = 5"), draw, &overrides).mission.seed, 5U);
  EXPECT_TRUE(overrides.empty());
  overrides = {"mission.seed=6"};
  EXPECT_EQ(LoadMissionToRun(Write("seed = \"random\""), draw, &overrides).mission.seed, 6U);
  EXPECT_EQ(overrides.size(), 1U);
}

TEST(Seed, OfAMissionThatIsNotRunStaysRandom) {
  const Mission mission =
      LoadMissionText(std::string(kShortest), "m.toml", {"mission.seed=random"}).mission;
  EXPECT_TRUE(mission.draws_seed);
  EXPECT_NE(Explain(mission).find("seed = \"random\"\n"), std::string::npos);
  EXPECT_TRUE(LoadMissionText(Explain(mission), "").mission.draws_seed);
}

TEST(Seed, IsANumberOrRandom) {
  EXPECT_EQ(ErrorsOf("[mission]\nduration_s = 60\nseed = \"randm\"\n[[vehicle]]\nname = \"a\"\n"),
            "3:8: seed must be a whole number, or \"random\", not 'randm'\n");
}

TEST(DrawSeed, DrawsDifferentOnes) {
  EXPECT_FALSE(DrawSeed() == DrawSeed() && DrawSeed() == DrawSeed());
}

}  // namespace shoal::drawn_seed_test
