#include "lib/run/run/run_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "lib/bus/record/log_testing.h"
#include "lib/run/run/run_registry.h"

namespace shoal::run_folder_test {

namespace fs = std::filesystem;

mode_t ModeOf(const fs::path& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

/// A folder of its own for each test, and the environment as it was afterwards.
class RunFolderTest : public ::testing::Test {
 protected:
  RunFolderTest() { setenv("SHOAL_RUN_DIR", (scratch_ / "run").c_str(), 1); }
  ~RunFolderTest() override {
    Restore("SHOAL_RUN_DIR", run_dir_);
    Restore("XDG_RUNTIME_DIR", xdg_);
  }

  const TestDirectory directory_;
  const fs::path scratch_ = directory_.File("");

 private:
  static std::optional<std::string> Get(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  }
  static void Restore(const char* name, const std::optional<std::string>& value) {
    if (value) {
      setenv(name, value->c_str(), 1);
    } else {
      unsetenv(name);
    }
  }

  const std::optional<std::string> run_dir_ = Get("SHOAL_RUN_DIR");
  const std::optional<std::string> xdg_ = Get("XDG_RUNTIME_DIR");
};

RunningMission MissionAt(int port_base, int pid) {
  RunningMission mission;
  mission.name = "m";
  mission.port_base = port_base;
  mission.pid = pid;
  mission.vehicles = {"a", "b"};
  mission.folder = "/home/ada";
  return mission;
}

/// Expects that nothing reads or writes the folder, and that the error holds `text` and a remedy.
void ExpectRefused(const std::string& text) {
  const std::string remedy = "SHOAL_RUN_DIR=~/.shoal";
  for (const Result<std::string>& result :
       {OpenRunFolder(), WriteRunFile("7665.run", "x"), ReadRunFile("7665.run"),
        MakeRunSubfolder("7665-logs")}) {
    ASSERT_FALSE(result.ok());
    EXPECT_NE(result.error().find(text), std::string::npos) << result.error();
    EXPECT_NE(result.error().find(remedy), std::string::npos) << result.error();
  }
  EXPECT_FALSE(Register(MissionAt(7665, getpid())).ok());
  EXPECT_FALSE(RunningMissions().ok());
  EXPECT_FALSE(FindRunningMission(0).ok());
}

TEST_F(RunFolderTest, IsMadeForItsOwnerAlone) {
  setenv("SHOAL_RUN_DIR", (scratch_ / "a/b/run/").c_str(), 1);
  const Result<std::string> folder = OpenRunFolder();
  ASSERT_TRUE(folder.ok()) << folder.error();
  EXPECT_EQ(*folder, (scratch_ / "a/b/run").string());
  EXPECT_EQ(ModeOf(*folder), 0700U);
}

TEST_F(RunFolderTest, OfAnotherUserIsRefused) {
  if (geteuid() == 0) {
    fs::create_directory(scratch_ / "run");
    fs::permissions(scratch_ / "run", fs::perms::owner_all);
    ASSERT_EQ(chown((scratch_ / "run").c_str(), 12345, 12345), 0);
  } else {
    setenv("SHOAL_RUN_DIR", "/usr", 1);  // Of root.
  }
  ExpectRefused("and not to you");
}

TEST_F(RunFolderTest, ThatIsASymbolicLinkIsRefused) {
  fs::create_directory(scratch_ / "elsewhere");
  fs::permissions(scratch_ / "elsewhere", fs::perms::owner_all);
  fs::create_symlink(scratch_ / "elsewhere", scratch_ / "run");
  ExpectRefused("is a symbolic link");
  setenv("SHOAL_RUN_DIR", (scratch_ / "run/").c_str(), 1);
  ExpectRefused("is a symbolic link");
  EXPECT_TRUE(fs::is_empty(scratch_ / "elsewhere"));
}

TEST_F(RunFolderTest, ThatOthersCanWriteIsRefused) {
  fs::create_directory(scratch_ / "run");
  for (const mode_t mode : {0777, 01777, 0770, 0702}) {
    ASSERT_EQ(chmod((scratch_ / "run").c_str(), mode), 0);
    ExpectRefused("other users can write");
  }
  setenv("XDG_RUNTIME_DIR", scratch_.c_str(), 1);
  unsetenv("SHOAL_RUN_DIR");
  fs::rename(scratch_ / "run", scratch_ / "shoal");
  ExpectRefused("other users can write");
}

TEST_F(RunFolderTest, ThatOthersCanReadIsRefusedWhereTheUserNamedItAndClosedWhereItIsTheDefault) {
  fs::create_directory(scratch_ / "run");
  ASSERT_EQ(chmod((scratch_ / "run").c_str(), 0755), 0);
  ExpectRefused("chmod 700 " + (scratch_ / "run").string());
  EXPECT_EQ(ModeOf(scratch_ / "run"), 0755U);

  setenv("XDG_RUNTIME_DIR", scratch_.c_str(), 1);
  unsetenv("SHOAL_RUN_DIR");
  fs::rename(scratch_ / "run", scratch_ / "shoal");
  ASSERT_TRUE(OpenRunFolder().ok());
  EXPECT_EQ(ModeOf(scratch_ / "shoal"), 0700U);
}

TEST_F(RunFolderTest, FileIsPrivateAndReplacesALinkInsteadOfFollowingIt) {
  ASSERT_TRUE(OpenRunFolder().ok());
  std::ofstream(scratch_ / "victim") << "precious";
  for (const char* name : {"7665.run", "7665.run.new"}) {
    fs::create_symlink(scratch_ / "victim", scratch_ / "run" / name);
  }
  EXPECT_FALSE(ReadRunFile("7665.run").ok()) << "a link is not read";
  for (const char* text : {"first", "second"}) {
    const Result<std::string> path = WriteRunFile("7665.run", text);
    ASSERT_TRUE(path.ok()) << path.error();
    EXPECT_EQ(*path, (scratch_ / "run/7665.run").string());
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(*path)));
    EXPECT_EQ(ModeOf(*path), 0600U);
    EXPECT_EQ(*ReadRunFile("7665.run"), text);
  }
  EXPECT_EQ(TextOfFile(scratch_ / "victim"), "precious");
  RemoveRunFile("7665.run");
  EXPECT_TRUE(fs::is_empty(scratch_ / "run"));
}

TEST_F(RunFolderTest, FileThatOthersCanWriteOrThatIsNoFileIsNotRead) {
  ASSERT_TRUE(WriteRunFile("7665.run", "x").ok());
  ASSERT_EQ(chmod((scratch_ / "run/7665.run").c_str(), 0666), 0);
  EXPECT_FALSE(ReadRunFile("7665.run").ok());
  ASSERT_EQ(mkfifo((scratch_ / "run/7805.run").c_str(), 0600), 0);
  EXPECT_FALSE(ReadRunFile("7805.run").ok());
  EXPECT_FALSE(ReadRunFile("7945.run").ok()) << "it does not exist";
}

TEST_F(RunFolderTest, FileOfAnotherUserIsNotRead) {
  if (geteuid() != 0)
    GTEST_SKIP() << "this machine cannot test it for this user: only root can give a file away";
  ASSERT_TRUE(WriteRunFile("7665.run", "x").ok());
  ASSERT_EQ(chown((scratch_ / "run/7665.run").c_str(), 12345, 12345), 0);
  EXPECT_FALSE(ReadRunFile("7665.run").ok());
}

TEST_F(RunFolderTest, FileOfMoreThanFourMebibytesIsNotRead) {
  const std::string text((size_t{4} << 20) + 1, 'x');
  ASSERT_TRUE(WriteRunFile("7665.run", text).ok());
  EXPECT_FALSE(ReadRunFile("7665.run").ok());
  ASSERT_TRUE(WriteRunFile("7665.run", std::string_view(text).substr(1)).ok());
  EXPECT_TRUE(ReadRunFile("7665.run").ok());
}

TEST_F(RunFolderTest, SubfolderIsMadeAnewInPlaceOfWhatWasLaidOut) {
  ASSERT_TRUE(OpenRunFolder().ok());
  fs::create_directory(scratch_ / "elsewhere");
  std::ofstream(scratch_ / "elsewhere/kept") << "precious";
  fs::create_symlink(scratch_ / "elsewhere", scratch_ / "run/7665-logs");
  for (int i = 0; i < 2; ++i) {
    const Result<std::string> logs = MakeRunSubfolder("7665-logs");
    ASSERT_TRUE(logs.ok()) << logs.error();
    EXPECT_TRUE(fs::is_directory(fs::symlink_status(*logs)));
    EXPECT_EQ(ModeOf(*logs), 0700U);
    EXPECT_TRUE(fs::is_empty(*logs));
    std::ofstream(fs::path(*logs) / "shoal-viewer.txt") << "token";
  }
  EXPECT_EQ(TextOfFile(scratch_ / "elsewhere/kept"), "precious");
}

/// The base ports of the mission that is chosen, 0 with an error that holds `text`.
int Chosen(const std::vector<RunningMission>& missions, int port_base, Purpose purpose,
           const std::string& text = "") {
  const Result<RunningMission> chosen = ChooseMission(missions, port_base, "/home/ada", purpose);
  if (chosen.ok()) return chosen->port_base;
  EXPECT_NE(chosen.error().find(text), std::string::npos) << chosen.error();
  for (const RunningMission& mission : missions) {
    const std::string option = "--port " + std::to_string(mission.port_base);
    EXPECT_NE(chosen.error().find(option), std::string::npos) << chosen.error();
  }
  return 0;
}

TEST_F(RunFolderTest, APlaybackIsMarkedInItsEntry) {
  RunningMission playback = MissionAt(7665, getpid());
  playback.playback_of = "/tmp/with blanks.lcm";
  ASSERT_TRUE(Register(playback).ok());
  ASSERT_TRUE(Register(MissionAt(7805, getpid())).ok());
  const auto missions = RunningMissions();
  ASSERT_TRUE(missions.ok());
  ASSERT_EQ(missions->size(), 2U);
  EXPECT_EQ(missions->at(0).playback_of, "/tmp/with blanks.lcm");
  EXPECT_NE(Describe(missions->at(0)).find("PLAYBACK of /tmp/with blanks.lcm"), std::string::npos);
  EXPECT_EQ(missions->at(1).playback_of, "");
}

TEST(ChooseMission, PrefersTheOneThatWasStartedInTheFolder) {
  std::vector<RunningMission> missions = {MissionAt(7665, 1), MissionAt(7805, 1),
                                          MissionAt(7945, 1)};
  missions[0].folder = "/home/bob";
  missions[1].folder = "/home/ada";
  missions[2].folder = "/home/ada/sub";
  for (const Purpose purpose : {Purpose::kLook, Purpose::kCommand}) {
    EXPECT_EQ(Chosen(missions, 0, purpose), 7805);
    EXPECT_EQ(Chosen(missions, 7665, purpose), 7665) << "a port that is named decides";
    EXPECT_EQ(Chosen(missions, 7000, purpose, "no mission runs at port 7000"), 0);
    EXPECT_EQ(Chosen({}, 0, purpose, "no mission is running"), 0);
  }
  missions[2].folder = "/home/ada";
  EXPECT_EQ(Chosen(missions, 0, Purpose::kLook, "several missions that were started in this"), 0);
  missions[1].folder = missions[2].folder = "/home/bob";
  EXPECT_EQ(Chosen(missions, 0, Purpose::kLook, "none was started in this folder"), 0);
}

TEST(ChooseMission, TakesNoFolderThatWasRemovedForAnother) {
  std::vector<RunningMission> missions = {MissionAt(7665, 1)};
  missions[0].folder = "";
  EXPECT_FALSE(ChooseMission(missions, 0, "", Purpose::kCommand).ok());
}

TEST(ChooseMission, TakesTheOnlyOneFromElsewhereToLookAtButNotToCommand) {
  std::vector<RunningMission> missions = {MissionAt(7665, 1)};
  missions[0].folder = "/home/bob";
  EXPECT_EQ(Chosen(missions, 0, Purpose::kLook), 7665);
  EXPECT_EQ(Chosen(missions, 0, Purpose::kCommand, "was not started in this folder (/home/ada)"),
            0);
  EXPECT_EQ(Chosen(missions, 7665, Purpose::kCommand), 7665);
}

TEST_F(RunFolderTest, EntriesOfMissionsAreFoundAndThoseOfDeadLaunchersRemoved) {
  RunningMission mission = MissionAt(7665, getpid());
  mission.name = "two lines\nport_base 9000";
  mission.grouping = "host=3";
  mission.groups = {{"the red ones", {"b", "a"}}, {"x", {"c"}}};
  ASSERT_TRUE(Register(mission).ok());
  ASSERT_TRUE(Register(MissionAt(7805, 1 << 30)).ok());  // No process has this number.
  fs::create_symlink(scratch_ / "run/7665.run", scratch_ / "run/7945.run");
  const Result<std::vector<RunningMission>> missions = RunningMissions();
  ASSERT_TRUE(missions.ok()) << missions.error();
  ASSERT_EQ(missions->size(), 1U);
  EXPECT_EQ(missions->front().port_base, 7665);
  EXPECT_EQ(missions->front().name, "two lines port_base 9000");
  EXPECT_EQ(missions->front().file, "");
  EXPECT_EQ(missions->front().vehicles, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(missions->front().folder, "/home/ada");
  EXPECT_EQ(missions->front().grouping, "host=3");
  EXPECT_EQ(missions->front().groups, mission.groups);
  EXPECT_FALSE(fs::exists(scratch_ / "run/7805.run"));
  Unregister(7665);
  EXPECT_TRUE(RunningMissions()->empty());
}

}  // namespace shoal::run_folder_test
