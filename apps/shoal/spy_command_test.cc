#include "apps/shoal/spy_command.h"

#include <gtest/gtest.h>

#include <set>

namespace shoal::spy_command_test {

/// A machine that has all, installed below /opt.
class SpyTest : public ::testing::Test {
 protected:
  SpyTest() {
    place_.exists = [this](const std::string& path) { return files_.contains(path); };
    place_.java = "/usr/lib/jvm/java-17/bin/java";
    place_.program_dir = "/opt/lib/shoal/bin";
  }

  std::string ErrorOf(const SpyOptions& options = {}) const {
    const auto command = SpyCommand(place_, options, "udpm://x");
    return command.ok() ? "" : command.error();
  }

  std::set<std::string> files_ = {"/usr/share/java/lcm.jar", "/usr/share/java/jchart2d.jar",
                                  "/usr/lib/jvm/java-17/lib/libawt_xawt.so",
                                  "/opt/share/shoal/shoal_types.jar"};
  SpyPlace place_;
};

TEST_F(SpyTest, StartsLcmSpyWithTheInstalledTypesAndOnesOwn) {
  files_.insert("mine.jar");
  place_.class_path = "other.jar";
  const auto command =
      SpyCommand(place_, {.types = {"mine.jar"}}, "udpm://239.255.76.67:7667?ttl=0");
  ASSERT_TRUE(command.ok()) << command.error();
  EXPECT_EQ(command->front(), place_.java);
  EXPECT_EQ((*command)[4],
            "/usr/share/java/lcm.jar:/usr/share/java/jchart2d.jar:"
            "/opt/share/shoal/shoal_types.jar:mine.jar:other.jar");
  EXPECT_EQ((*command)[5], "lcm.spy.Spy");
  EXPECT_EQ(command->back(), "--lcm-url=udpm://239.255.76.67:7667?ttl=0");
}

TEST_F(SpyTest, FindsTheTypesOfABuild) {
  files_.erase("/opt/share/shoal/shoal_types.jar");
  files_.insert("/home/ada/shoal/build/shoal_types.jar");
  place_.program_dir = "/home/ada/shoal/build/bin";
  EXPECT_EQ(ErrorOf(), "");
}

TEST_F(SpyTest, StatesWhatIsMissingAndHowToGetIt) {
  place_.java = "";
  EXPECT_NE(ErrorOf().find("apt-get install"), std::string::npos);
  place_.java = "/usr/lib/jvm/headless/bin/java";
  EXPECT_NE(ErrorOf().find("cannot open windows"), std::string::npos);
  place_.java = "/usr/lib/jvm/java-17/bin/java";
  EXPECT_EQ(ErrorOf(), "");
  EXPECT_NE(ErrorOf({.types = {"mine.jar"}}).find("--types mine.jar"), std::string::npos);
  place_.has_screen = false;
  EXPECT_NE(ErrorOf().find("DISPLAY"), std::string::npos);
  files_.erase("/opt/share/shoal/shoal_types.jar");
  EXPECT_NE(ErrorOf().find("shoal_types_jar"), std::string::npos);
  files_.erase("/usr/share/java/jchart2d.jar");
  EXPECT_NE(ErrorOf().find("jchart2d.jar is missing"), std::string::npos);
}

}  // namespace shoal::spy_command_test
