#include "lib/run/hosts/host_offer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lib/bus/os/read_file.h"
#include "lib/mission/file/load.h"

namespace shoal::host_offer_test {

namespace fs = std::filesystem;

class HostOffers : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = testing::TempDir() + "offerXXXXXX";
    folder_ = mkdtemp(pattern.data());
    fs::create_directories(folder_ / "home/missions");
    fs::create_directories(folder_ / "home/modems");
    fs::create_directories(folder_ / "host");
    fs::copy(fs::path(SHOAL_SOURCE_DIR) / "data/modems/nanomodem_v3.toml",
             folder_ / "home/modems/own.toml");
    std::ofstream(folder_ / "home/missions/m.toml")
        << "[mission]\nduration_s = 60\n[acoustics]\nmodem = \"../modems/own\"\n"
           "[[vehicle]]\nname = \"alpha\"\n";
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(HostOffers, CarryAllFilesOfAMission) {
  const auto files = FilesOfMission((folder_ / "home/missions/m.toml").string(), {});
  ASSERT_TRUE(files.ok()) << files.error();
  ASSERT_EQ(files->size(), 2U);
  EXPECT_EQ((*files)[0].path, "missions/m.toml");
  EXPECT_EQ((*files)[1].path, "modems/own.toml");
  const auto written = WriteOfferedFiles(*files, (folder_ / "host").string());
  ASSERT_TRUE(written.ok()) << written.error();
  EXPECT_EQ(*written, (folder_ / "host/missions/m.toml").string());
  const LoadedMission there = LoadMission(*written);
  EXPECT_EQ(there.errors, std::vector<std::string>{});
  const LoadedMission here = LoadMission((folder_ / "home/missions/m.toml").string());
  EXPECT_EQ(MissionDigest(there.mission, *files), MissionDigest(here.mission, *files));
}

TEST_F(HostOffers, CarryGridsThatWereReadBefore) {
  const fs::path mission = folder_ / "home/missions/grids.toml";
  fs::create_directories(folder_ / "home/sea");
  for (const char* name : {"u.asc", "v.asc", "bay.asc"}) {
    std::ofstream(folder_ / "home/sea" / name)
        << "ncols 1\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 9\n-1\n";
  }
  std::ofstream(mission) << "[mission]\nduration_s = 60\n[environment]\ncurrent = {grid_east = "
                            "\"../sea/u.asc\", grid_north = \"../sea/v.asc\"}\nfloor = {grid = "
                            "\"../sea/bay.asc\"}\n[[vehicle]]\nname = \"alpha\"\n";
  // As `shoal run --on` does it: what was read for the mission is kept for its offer.
  EXPECT_EQ(LoadMission(mission.string()).errors, std::vector<std::string>{});
  const auto files = FilesOfMission(mission.string(), {});
  ASSERT_TRUE(files.ok()) << files.error();
  std::vector<std::string> paths;
  for (const OfferedFile& file : *files) paths.push_back(file.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"missions/grids.toml", "sea/bay.asc", "sea/u.asc",
                                             "sea/v.asc"}));
}

TEST_F(HostOffers, DifferWhereAnyFileOrKeyDiffers) {
  const std::string file = (folder_ / "home/missions/m.toml").string();
  const auto files = FilesOfMission(file, {});
  ASSERT_TRUE(files.ok());
  const Mission mission = LoadMission(file).mission;
  auto others = *files;
  others[1].text += "\n";
  EXPECT_NE(MissionDigest(mission, others), MissionDigest(mission, *files));
  EXPECT_NE(MissionDigest(LoadMission(file, {"mission.seed=2"}).mission, *files),
            MissionDigest(mission, *files));
}

TEST_F(HostOffers, WriteNothingOutsideOfTheFolder) {
  for (const std::string path : {"../x.toml", "a/../../x.toml", "/tmp/x.toml", ""}) {
    const auto written = WriteOfferedFiles({{.path = path, .text = "x"}}, folder_ / "host");
    ASSERT_FALSE(written.ok()) << path;
    EXPECT_NE(written.error().find("outside"), std::string::npos) << written.error();
  }
}

TEST(HostOffer, ArrivesAsItWasSent) {
  const HostOffer offer{.build = "b",
                        .host = "lab2",
                        .files = {{.path = "m.toml", .text = "x"}, {.path = "g", .text = ""}},
                        .overrides = {"mission.seed=2", "mission.name=a"},
                        .digest = "d",
                        .participants = {"helm_alpha"},
                        .grouping = {.kind = Grouping::Kind::kHost, .num_processes = 3},
                        .secret = RandomSecret(),
                        .layout = Layout::kCommunities,
                        .timeout_s = 0.9};
  const auto read = OfferOf(ToLinkMessage(offer, 5));
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read->files, offer.files);
  EXPECT_EQ(read->overrides, offer.overrides);
  EXPECT_EQ(read->participants, offer.participants);
  EXPECT_EQ(read->grouping, offer.grouping);
  EXPECT_EQ(read->secret, offer.secret);
  EXPECT_EQ(read->layout, offer.layout);
  EXPECT_EQ(read->timeout_s, 0.9);
  EXPECT_FALSE(OfferOf({.kind = LinkKind::kOffer}).ok());
  LinkMessage wrong = ToLinkMessage(offer, 5);
  std::erase_if(wrong.parts, [](const LinkPart& part) { return part.name == "grouping"; });
  wrong.AddText("grouping", "boats");
  EXPECT_NE(OfferOf(wrong).error().find("'boats' is no grouping"), std::string::npos);
}

TEST(HostExit, ArrivesAsItWasSent) {
  const HostExit exit{.name = "helm_alpha",
                      .pid = 12,
                      .clean = true,
                      .how = "exited with code 0",
                      .last_lines = {"a", "b"}};
  EXPECT_EQ(ExitOf(ToLinkMessage(exit, 5)), exit);
}

}  // namespace shoal::host_offer_test
