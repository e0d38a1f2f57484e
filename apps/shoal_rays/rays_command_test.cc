#include "apps/shoal_rays/rays_command.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "lib/base/check/result.h"

namespace shoal::rays_command_test {

namespace fs = std::filesystem;

class Rays : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("shoal_rays_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  int Run() {
    out_.str("");
    err_.str("");
    return RunRays(options_, out_, err_);
  }

  fs::path folder_;
  RaysOptions options_;
  std::ostringstream out_;
  std::ostringstream err_;
};

constexpr const char* kMission =
    "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n"
    "[acoustics]\nmodem = \"whoi_micromodem2\"\n[acoustics.channel]\nmodel = \"rays\"\n"
    "bottom_depth_m = 100\nprofile = [[0, 1500]]\n";

TEST_F(Rays, AreATableOfArrivals) {
  options_ = {.file = Write("m.toml", kMission), .from = "0,0,30", .to = "600,800,60"};
  ASSERT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find("range 1000.0 m"), std::string::npos) << out_.str();
  EXPECT_NE(out_.str().find("    0.666967       0.000"), std::string::npos) << out_.str();
  EXPECT_NE(out_.str().find("a modem gets"), std::string::npos) << out_.str();
}

TEST_F(Rays, StateTheShadowAndItsReason) {
  options_ = {.file = Write("m.toml", kMission),
              .from = "0,0,60",
              .to = "3000,0,5",
              .overrides = {"acoustics.channel.profile=[[0,1520],[20,1519],[30,1490],[100,1488]]"}};
  ASSERT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find("shadow zone: sound is slower below and bends down"), std::string::npos)
      << out_.str();
}

TEST_F(Rays, AreThoseOfAnEnv) {
  options_ = {.file = Write("bay.env",
                            "'a bay'\n25000\n1\n'CVWT'\n2 0.0 100\n0 1500 /\n100 1500 /\n'R' 0\n"
                            "1\n30 /\n1\n60 /\n1\n1 /\n'A'\n100\n-60 60 /\n0 110 1.1\n")};
  ASSERT_EQ(Run(), kExitOk) << err_.str();
  EXPECT_NE(out_.str().find("a bay: range 1000.0 m, from 30 m to 60 m deep"), std::string::npos);
  EXPECT_NE(out_.str().find("    0.666967"), std::string::npos);
  options_.to = "500,0,70";
  ASSERT_EQ(Run(), kExitOk);
  EXPECT_NE(out_.str().find("range 500.0 m"), std::string::npos);
}

TEST_F(Rays, RefuseWhatCannotBeWithTheRemedy) {
  options_ = {.file = Write("m.toml", kMission)};
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("--from is needed"), std::string::npos) << err_.str();
  options_.from = "0,0";
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("three numbers"), std::string::npos);
  options_.from = "0,0,30";
  options_.to = "1000,0,130";
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("--to is at 130 m, and the water there is from 0 to 100 m"),
            std::string::npos);
  options_.to = "0,0,60";
  EXPECT_EQ(Run(), kExitUsage);
  options_ = {.file = Write("s.toml", "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"a\"\n"),
              .from = "0,0,1",
              .to = "9,0,1"};
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("sound goes straight in this mission"), std::string::npos);
  options_.file = Write("x.env", "'a bay'\n25000\n2\n");
  EXPECT_EQ(Run(), kExitUsage);
  EXPECT_NE(err_.str().find("x.env:3: the number of media must be 1"), std::string::npos);
}

TEST_F(Rays, AreDrawnAsThreeFigures) {
  // A gnuplot that draws the name of its script.
  fs::create_directory(folder_ / "bin");
  const std::string program =
      Write("bin/gnuplot", "#!/bin/sh\necho \"$2\" > \"../${2%.gp}.svg\"\n");
  fs::permissions(program, fs::perms::owner_all);
  options_ = {.file = Write("m.toml", kMission),
              .from = "0,0,30",
              .to = "600,800,60",
              .plot = true,
              .out_dir = (folder_ / "figures").string(),
              .keep = true,
              .search_path = (folder_ / "bin").string()};
  ASSERT_EQ(Run(), kExitOk) << err_.str();
  for (const char* name : {"impulse", "fan", "loss"}) {
    EXPECT_TRUE(fs::exists(folder_ / "figures" / (std::string(name) + ".svg"))) << name;
    EXPECT_GT(fs::file_size(folder_ / "figures/gnuplot" / (std::string(name) + ".dat")), 100U);
  }
}

}  // namespace shoal::rays_command_test
