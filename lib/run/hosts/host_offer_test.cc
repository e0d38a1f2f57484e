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

/// Returns the offer of the fixture's mission as home makes it.
HostOffer OfferOfFile(const fs::path& file, const std::vector<std::string>& overrides = {}) {
  const auto files = FilesOfMission(file.string(), overrides);
  EXPECT_TRUE(files.ok()) << files.error();
  if (!files.ok()) return {};
  return {.host = "lab2",
          .files = *files,
          .overrides = overrides,
          .digest = MissionDigest(LoadMission(file.string(), overrides).mission, *files),
          .participants = {"helm_alpha"},
          .secret = {},
          .timeout_s = 0.9};
}

TEST_F(HostOffers, AreLoadedAsAtHome) {
  const HostOffer offer = OfferOfFile(folder_ / "home/missions/m.toml", {"mission.seed=2"});
  const Result<Mission> loaded = LoadOffered(offer, (folder_ / "host").string());
  ASSERT_TRUE(loaded.ok()) << loaded.error();
  EXPECT_EQ(loaded->seed, 2U);
  EXPECT_EQ(loaded->file, (folder_ / "host/missions/m.toml").string());
}

constexpr char kHead[] = "[mission]\nduration_s = 60\n[[vehicle]]\nname = \"alpha\"\n";
constexpr char kGrid[] = "ncols 1\nnrows 1\nxllcenter 0\nyllcenter 0\ncellsize 9\n-7\n";

TEST_F(HostOffers, AreNotMadeOfAFileThatIsNamedByAnAbsolutePath) {
  const std::string grid = (folder_ / "home/bay.asc").string();
  const std::string mission = (folder_ / "home/missions/far.toml").string();
  std::ofstream(grid) << kGrid;
  std::ofstream(mission) << kHead << "[environment]\nfloor = {grid = \"" << grid << "\"}\n";
  const auto files = FilesOfMission(mission, {});
  ASSERT_FALSE(files.ok());
  EXPECT_NE(files.error().find("names " + grid + " by an absolute path"), std::string::npos)
      << files.error();
  // The same by --set, and with a path that leads back.
  std::ofstream(folder_ / "home/missions/none.toml") << kHead;
  EXPECT_FALSE(FilesOfMission((folder_ / "home/missions/none.toml").string(),
                              {"environment.floor.grid=" + grid})
                   .ok());
}

/// One way in which a mission can name a file.
struct NamedFile {
  const char* what;
  const char* mission;  ///< With @ for the path.
};

class ForeignFiles : public HostOffers, public testing::WithParamInterface<NamedFile> {
 protected:
  /// Returns the error of loading a mission that names `path`, as a home that means no good offers
  /// it.
  std::string ErrorFor(const std::string& path) {
    std::string text = std::string(kHead) + GetParam().mission;
    for (size_t at = 0; (at = text.find('@', at)) != text.npos; at += path.size()) {
      text.replace(at, 1, path);
    }
    const HostOffer offer = {.files = {{.path = "missions/m.toml", .text = text}}, .secret = {}};
    fs::remove_all(folder_ / "host");
    fs::create_directory(folder_ / "host");
    const Result<Mission> loaded = LoadOffered(offer, (folder_ / "host").string());
    return loaded.ok() ? "" : loaded.error();
  }
};

INSTANTIATE_TEST_SUITE_P(
    HostOffers, ForeignFiles,
    testing::Values(NamedFile{"Floor", "[environment]\nfloor = {grid = \"@\"}\n"},
                    NamedFile{"NetcdfFloor", "[environment]\nfloor = {grid = \"@.nc\"}\n"},
                    NamedFile{"Current",
                              "[environment]\ncurrent = {grid_east = \"@\", grid_north = "
                              "\"@\"}\n"},
                    NamedFile{"Track", "model = \"track\"\ntrack = {file = \"@.csv\"}\n"},
                    NamedFile{"Modem", "[acoustics]\nmodem = \"@\"\n"}),
    [](const auto& each) { return each.param.what; });

TEST_P(ForeignFiles, OfAHostAreNotReadAndNotLookedFor) {
  const std::string secret = (folder_ / "secret").string();
  for (const char* ending : {"", ".nc", ".csv", ".toml"}) {
    std::ofstream(secret + ending) << "password hunter2\n";
  }
  for (const std::string& path : {secret, std::string("../../secret")}) {
    const std::string error = ErrorFor(path);
    ASSERT_NE(error.find("it does not load there: "), std::string::npos) << error;
    EXPECT_EQ(error.find("hunter2"), std::string::npos) << error;
    EXPECT_EQ(error.find("password"), std::string::npos) << error;
    // Whether it is there is not to be learned either.
    const std::string other = path.substr(0, path.size() - 6) + "secrex";
    std::string of_missing = ErrorFor(other);
    for (size_t at = 0; (at = of_missing.find("secrex", at)) != of_missing.npos;) {
      of_missing.replace(at, 6, "secret");
    }
    EXPECT_EQ(of_missing, error);
  }
}

TEST_F(HostOffers, AreRefusedWhereTheDigestIsOfOtherFiles) {
  HostOffer offer = OfferOfFile(folder_ / "home/missions/m.toml");
  offer.files[1].text += "\n";
  const Result<Mission> loaded = LoadOffered(offer, (folder_ / "host").string());
  ASSERT_FALSE(loaded.ok());
  EXPECT_NE(loaded.error().find("its digest differs"), std::string::npos) << loaded.error();
}

class OfferedRosters : public testing::Test {
 protected:
  static Mission Placed(const std::string& hosts) {
    const LoadedMission loaded =
        LoadMissionText(std::string(kHead) +
                            "[[vehicle]]\nname = \"bravo\"\n[[participant]]\nname = "
                            "\"mine\"\ncommand = [\"/bin/false\"]\n[netsim]\n" +
                            hosts,
                        "m.toml");
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    return loaded.mission;
  }
  /// Returns why the host lab2 does not run the participants; empty: it does.
  static std::string Problem(std::vector<std::string> participants, bool allow_programs = false) {
    HostOffer offer{.host = "lab2", .secret = {}};
    offer.participants = std::move(participants);
    const auto roster = OfferedRoster(
        offer,
        Placed("[[host]]\nname = \"lab2\"\nvehicles = [\"alpha\"]\nparticipants = [\"mine\"]\n"),
        allow_programs);
    return roster.ok() ? "" : roster.error();
  }
};

TEST_F(OfferedRosters, HaveTheProcessesOfVehiclesThatAreOnTheHost) {
  EXPECT_EQ(Problem({"helm_alpha", "vehicle_sim_alpha", "node_reporter_alpha"}), "");
  EXPECT_NE(Problem({"helm_bravo"}).find("does not place helm_bravo on host lab2"),
            std::string::npos);
  EXPECT_NE(Problem({"helm_alpha", "helm_alpha"}).find("twice"), std::string::npos);
  EXPECT_NE(Problem({"helm_alpha", "helm_charlie"}).find("1 of the 2 participants"),
            std::string::npos);
}

TEST_F(OfferedRosters, HaveNoneOfHomesOwnProcessesEvenWherePrograms) {
  for (const char* name : {"netsim_manager", "shore_broker"}) {
    for (const bool allow_programs : {false, true}) {
      EXPECT_NE(Problem({name}, allow_programs).find(std::string(name) + " runs at home"),
                std::string::npos)
          << Problem({name}, allow_programs);
    }
  }
  EXPECT_NE(Problem({"recorder"}, true), "");
}

TEST_F(OfferedRosters, HaveProgramsOnlyWhereTheyAreAllowed) {
  EXPECT_NE(Problem({"mine"}).find("only where it was started with --allow-programs"),
            std::string::npos);
  EXPECT_EQ(Problem({"mine"}, true), "");
}

TEST_F(HostOffers, WriteNothingOutsideOfTheFolder) {
  for (const std::string path : {"../x.toml", "a/../../x.toml", "/tmp/x.toml", ""}) {
    const auto written = WriteOfferedFiles({{.path = path, .text = "x"}}, folder_ / "host");
    ASSERT_FALSE(written.ok()) << path;
    EXPECT_NE(written.error().find("outside"), std::string::npos) << written.error();
  }
}

TEST(HostOffer, ArrivesAsItWasSent) {
  const HostOffer offer{.build = {.version = "1", .build = "b", .arithmetic = "a"},
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
  EXPECT_EQ(read->build, offer.build);
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
  EXPECT_NE(OfferOf(wrong).error().find("'boats' is not a grouping"), std::string::npos);
}

/// Returns the error of an offer one of whose parts has another text.
std::string ErrorWith(const std::string& part, const std::string& text) {
  LinkMessage message = ToLinkMessage({.host = "lab2",
                                       .files = {{.path = "m.toml", .text = "x"}},
                                       .participants = {"helm_alpha"},
                                       .secret = RandomSecret(),
                                       .timeout_s = 0.9},
                                      5);
  std::erase_if(message.parts, [&](const LinkPart& each) { return each.name == part; });
  message.AddText(part, text);
  const auto offer = OfferOf(message);
  return offer.ok() ? "" : offer.error();
}

TEST(HostOffer, HasATimeOutThatAMissionFileMayHave) {
  for (const char* fits : {"0.1", "3600"}) EXPECT_EQ(ErrorWith("timeout_s", fits), "") << fits;
  for (const char* wrong : {"9e12", "3600.1", "0.09", "0", "-1", "nan", "inf", "", "soon"}) {
    EXPECT_NE(ErrorWith("timeout_s", wrong).find("it is 0.1 to 3600 s"), std::string::npos)
        << wrong << ": " << ErrorWith("timeout_s", wrong);
  }
  const auto problems = [](const std::string& timeout_s) {
    return LoadMissionText(
               std::string(kHead) + "[[host]]\nname = \"lab2\"\ntimeout_s = " + timeout_s + "\n",
               "m.toml")
        .errors.size();
  };
  EXPECT_EQ(problems("0.1") + problems("3600.0"), 0U);
  EXPECT_EQ(problems("0.09") + problems("3600.1"), 2U);
}

TEST(HostOffer, HasALayoutAndAHostThatExist) {
  EXPECT_EQ(ErrorWith("layout", "towers"), "an offer of layout 'towers'");
  EXPECT_NE(ErrorWith("host", "../lab").find("an offer for a host '../lab': "), std::string::npos)
      << ErrorWith("host", "../lab");
}

TEST(HostOffer, IsRefusedWithItsIdSoThatHomeTakesIt) {
  LinkIntake home;
  home.set_mission_id(5);
  const auto taken = home.Take(EncodeLinkMessage(RefusalOf(5, "it runs another mission now"), 0));
  ASSERT_TRUE(taken.ok()) << taken.error();
  EXPECT_EQ(taken->kind, LinkKind::kRefuse);
  EXPECT_EQ(taken->TextOf("why"), "it runs another mission now");
}

TEST(HostOffer, LosesControlCharactersInTexts) {
  const auto taken = RefusalOf(5, "no\x1b[2J\nVerdict: PASS").TextOf("why");
  EXPECT_EQ(taken, "no?[2J?Verdict: PASS");
}

TEST(HostExit, LosesControlCharactersAndAllButAFewLines) {
  const HostExit exit{.name = "helm_alpha\n",
                      .how = "\x1b]0;x\x07",
                      .last_lines = std::vector<std::string>(100'000, "a\rb\nVerdict: PASS")};
  const HostExit read = ExitOf(ToLinkMessage(exit, 5));
  EXPECT_EQ(read.name, "helm_alpha?");
  EXPECT_EQ(read.how, "?]0;x?");
  EXPECT_EQ(read.last_lines, std::vector<std::string>(10, "a?b?Verdict: PASS"));
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
