// Campaigns whose trials fail, crash, hang or are wrong; folders of others.
#include <gtest/gtest.h>

#include "tests/campaigns/campaign_runs.h"

namespace shoal::campaign_outcomes_test {

bool Holds(const Finished& finished, const std::string& text) {
  return finished.output.find(text) != std::string::npos;
}

TEST(CampaignOutcomes, OfAMissionThatIsWrongAtOnePointOnlyAreErrorsThereAndNowhereElse) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"" + MissionFile("berta.toml") +
                                   "\"\nrepetitions = 3\n[sweep]\n"
                                   "\"comms.comms_range\" = [100, \"far\"]\n");
  const Finished check = RunShoal(folder, {"campaign", "check", (folder / "c.toml").string()});
  EXPECT_EQ(check.exit_code, 2) << check.output;
  EXPECT_TRUE(Holds(check, "case comms.comms_range=\"far\":")) << check.output;
  const Finished run = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_TRUE(Holds(run, "6 trials: 3 pass, 0 fail, 3 error, 0 timeout")) << run.output;
  EXPECT_TRUE(Holds(run, "comms_range must be 0 to 10000000 or \"nolimit\"")) << run.output;
  const Finished report = RunShoal(folder, {"campaign", "report", (folder / "out").string()});
  EXPECT_EQ(report.exit_code, 1) << report.output;
  EXPECT_TRUE(Holds(report, "3 error")) << report.output;
}

TEST(CampaignOutcomes, OfAMissionThatTakesForEverAreTimeouts) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"" + MissionFile("berta.toml") +
                                   "\"\nrepetitions = 2\ntimeout_s = 0.5\n[set]\n"
                                   "\"mission.duration_s\" = 100000\n");
  const Finished run = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_TRUE(Holds(run, "2 trials: 0 pass, 0 fail, 0 error, 2 timeout")) << run.output;
  EXPECT_TRUE(Holds(run, "did not end within 0.5 s of wall time (timeout_s), at ")) << run.output;
}

TEST(CampaignOutcomes, OfAHelmThatCrashesAreErrorsThatNameIt) {
  const TestFolder folder;
  WriteFile(folder / "m.toml",
            "[mission]\nduration_s = 20\n[[vehicle]]\nname = \"alpha\"\n"
            "helm_options = {deploy_at_start = true}\n"
            "[[vehicle.task]]\nkind = \"waypoints\"\npoints = [[100, 0]]\nspeed_mps = 1\n"
            "[[vehicle.behavior]]\nkind = \"test_failure\"\nname = \"broken\"\nduration = 5\n"
            "failure_type = \"crash\"\n"
            "[[expect]]\nkind = \"helm\"\nvehicle = \"alpha\"\nstate = \"DRIVE\"\n");
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"m.toml\"\nrepetitions = 2\n");
  const Finished run = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_TRUE(Holds(run, "2 error")) << run.output;
  EXPECT_TRUE(Holds(run, "LOST: helm_alpha")) << run.output;
}

TEST(CampaignOutcomes, ThatAreFailsAreRecordedAndCanBeReplayedToTheSameLog) {
  const TestFolder folder;
  // At 50 m the two are out of range of each other for longer than berta allows.
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"" + MissionFile("berta.toml") +
                                   "\"\nrepetitions = 3\n[set]\n\"comms.comms_range\" = 50\n");
  const Finished run = RunCampaignTo(folder, "c.toml", "out", {"--keep", "2"});
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(Holds(run, "3 trials: 0 pass, 3 fail")) << run.output;
  EXPECT_TRUE(Holds(run, "2 recorded in")) << run.output;
  std::vector<std::string> trials;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out" / "failures")) {
    trials.push_back(entry.path().filename().string());
  }
  ASSERT_EQ(trials.size(), 2U);
  const Finished replay =
      RunShoal(folder, {"campaign", "replay", (folder / "out").string(), trials[0]});
  EXPECT_EQ(replay.exit_code, 1) << replay.output;
  const std::filesystem::path kept = folder / "out" / "failures" / trials[0];
  const std::string log = ReadFile(kept / "mission.lcm");
  EXPECT_GT(log.size(), 100'000U);
  EXPECT_EQ(ReadFile(folder / "out" / "replays" / trials[0] / "mission.lcm"), log);
  EXPECT_TRUE(ReadFile(kept / "why.txt").starts_with("fail: at least 50 reports delivered"));
}

/// A campaign of one repetition whose mission has a program that leaves a mark.
struct MarkingCampaign {
  MarkingCampaign() {
    WriteFile(folder / "mark.sh", "#!/bin/sh\ntouch " + mark + "\nexit 1\n");
    std::filesystem::permissions(folder / "mark.sh", std::filesystem::perms::owner_all);
    WriteFile(folder / "m.toml",
              "[mission]\nduration_s = 1\n[[vehicle]]\nname = \"alpha\"\n[[participant]]\nname = "
              "\"mine\"\ncommand = [\"" +
                  (folder / "mark.sh").string() + "\"]\n");
    WriteFile(folder / "c.toml", "[campaign]\nmission = \"m.toml\"\nrepetitions = 1\n");
  }
  bool HasRun() const { return std::filesystem::exists(mark); }

  TestFolder folder;
  std::string mark = (folder / "mark").string();
};

TEST(CampaignPrograms, OfAMissionAreNotStartedByACheck) {
  const MarkingCampaign campaign;
  const Finished finished =
      RunShoal(campaign.folder, {"campaign", "check", (campaign.folder / "c.toml").string()});
  EXPECT_EQ(finished.exit_code, 0) << finished.output;
  EXPECT_NE(finished.output.find("runs or opens mine: "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("not timed, since a check starts no process"), std::string::npos)
      << finished.output;
  EXPECT_FALSE(campaign.HasRun());
}

TEST(CampaignPrograms, OfAMissionAreShownBeforeTheyRun) {
  const MarkingCampaign campaign;
  const Finished finished = RunCampaignTo(campaign.folder, "c.toml", "out");
  EXPECT_NE(finished.output.find("with your rights, the trials run or open:\n  mine: " +
                                 (campaign.folder / "mark.sh").string()),
            std::string::npos)
      << finished.output;
  EXPECT_TRUE(campaign.HasRun());
}

TEST(CampaignFolders, WithALinkForReplaysLoseNothingBehindIt) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(1));
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "out", {"--keep", "none"}).exit_code, 0);
  const std::string line = StoredLines(folder / "out").at(0);
  const size_t at = line.find("\"case\":\"") + 8;
  const std::string trial = line.substr(at, line.find('"', at) - at) + "-1";
  std::filesystem::create_directories(folder / ("mine/" + trial));
  WriteFile(folder / ("mine/" + trial + "/thesis.tex"), "mine");
  std::filesystem::create_directory_symlink(folder / "mine", folder / "out/replays");
  const Finished finished =
      RunShoal(folder, {"campaign", "replay", (folder / "out").string(), trial});
  EXPECT_EQ(finished.exit_code, 2) << finished.output;
  EXPECT_NE(finished.output.find("out/replays: is a link"), std::string::npos) << finished.output;
  EXPECT_EQ(ReadFile(folder / ("mine/" + trial + "/thesis.tex")), "mine");
}

TEST(CampaignOutcomes, AreThoseOfTheTrialsWhereTheStandardDescriptorsAreClosed) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(2));
  const std::string command = Program("shoal") + " campaign run " + (folder / "c.toml").string() +
                              " --out " + (folder / "out").string() +
                              " --quiet <&- >&- 2>&-; exit 0";
  RunningProcess process(folder, {"/bin/sh", "-c", command});
  process.Wait();
  const std::vector<std::string> lines = StoredLines(folder / "out");
  EXPECT_EQ(lines.size(), 4U);
  for (const std::string& line : lines) {
    EXPECT_EQ(line.find("error"), std::string::npos) << line;
  }
}

TEST(CampaignFolders, OfAnotherBuildOrMissionAreRefusedAndStayAsTheyAre) {
  const TestFolder folder;
  WriteFile(folder / "m.toml", ReadFile(MissionFile("berta.toml")));
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"m.toml\"\nrepetitions = 2\n");
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "out").exit_code, 0);
  const std::string shard = ReadFile(folder / "out" / "shards" / "1-of-1.jsonl");

  WriteFile(folder / "m.toml", ReadFile(MissionFile("berta.toml")) + "# The same mission.\n");
  EXPECT_EQ(RunCampaignTo(folder, "c.toml", "out").exit_code, 0);
  WriteFile(folder / "m.toml",
            ReadFile(MissionFile("berta.toml")) + "[[expect]]\nkind = \"separation\"\nmin_m = 1\n");
  const Finished other_mission = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(other_mission.exit_code, 2) << other_mission.output;
  EXPECT_TRUE(Holds(other_mission, "another text of the mission")) << other_mission.output;
  WriteFile(folder / "m.toml", ReadFile(MissionFile("berta.toml")));

  std::string facts = ReadFile(folder / "out" / "campaign.json");
  const size_t build = facts.find("\"build\": \"") + 10;
  facts.replace(build, 16, "0123456789abcdef");
  WriteFile(folder / "out" / "campaign.json", facts);
  const Finished other_build = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(other_build.exit_code, 2) << other_build.output;
  EXPECT_TRUE(Holds(other_build, "results of another build of shoal (0123456789abcdef"))
      << other_build.output;
  EXPECT_EQ(ReadFile(folder / "out" / "campaign.json"), facts);
  EXPECT_EQ(ReadFile(folder / "out" / "shards" / "1-of-1.jsonl"), shard);
}

TEST(CampaignFolders, ThatCannotBeMadeAreTheMachinesFault) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(2));
  const Finished run = RunShoal(
      folder, {"campaign", "run", (folder / "c.toml").string(), "--out", "/proc/campaign"});
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_TRUE(Holds(run, "/proc/campaign: cannot be made or written")) << run.output;
  EXPECT_TRUE(Holds(run, "give --out another folder")) << run.output;
}

TEST(CampaignFolders, WithTwoPoliciesThatDoTheSameDifferByExactlyNothing) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", "[campaign]\nmission = \"" + MissionFile("berta.toml") +
                                   "\"\nrepetitions = 5\n[policy.as_it_is]\n[policy.colored]\n"
                                   "\"vehicle.alpha.color\" = \"red\"\n"
                                   "[metrics]\nway = {kind = \"distance_travelled\"}\n");
  ASSERT_EQ(RunCampaignTo(folder, "c.toml", "out").exit_code, 0);
  const Finished compared = RunShoal(folder, {"campaign", "compare", (folder / "out").string(),
                                              "--a", "policy=as_it_is", "--b", "policy=colored"});
  EXPECT_EQ(compared.exit_code, 0) << compared.output;
  size_t count = 0;
  for (size_t at = 0;
       (at = compared.output.find("the same in every pair", at)) != std::string::npos; ++at) {
    ++count;
  }
  EXPECT_EQ(count, 5U) << compared.output;  // Four expectations and a metric.
}

TEST(CampaignFolders, OfACampaignThatRunsAreNotRunASecondTime) {
  const TestFolder folder;
  WriteFile(folder / "c.toml", BertaCampaign(2000));
  RunningProcess first(folder, {Program("shoal"), "campaign", "run", (folder / "c.toml").string(),
                                "--out", (folder / "out").string(), "--quiet"});
  ASSERT_TRUE(AwaitThat([&] { return !StoredLines(folder / "out").empty(); }));
  const Finished second = RunCampaignTo(folder, "c.toml", "out");
  EXPECT_EQ(second.exit_code, 3) << second.output;
  EXPECT_TRUE(Holds(second, "another process runs this shard")) << second.output;
  const Finished status = RunShoal(folder, {"campaign", "status", (folder / "out").string()});
  EXPECT_EQ(status.exit_code, 0) << status.output;
  EXPECT_TRUE(Holds(status, " missing")) << status.output;
}

/// A campaign of one trial whose folder holds what a terminal would execute.
struct FolderOfOthers {
  FolderOfOthers() {
    WriteFile(folder / "m.toml",
              "[mission]\nduration_s = 5\n[[vehicle]]\nname = \"alpha\"\n"
              "[[vehicle.task]]\nkind = \"waypoints\"\npoints = [[100, 0]]\nspeed_mps = 1\n");
    WriteFile(folder / "c.toml",
              "[campaign]\nmission = \"m.toml\"\nrepetitions = 1\n[sweep]\n"
              "\"mission.duration_s\" = [5]\n");
    EXPECT_EQ(RunCampaignTo(folder, "c.toml", "out").exit_code, 0);
  }
  /// Replaces `old` by `text` in a file of the folder.
  void Edit(const std::string& name, const std::string& old, const std::string& text) {
    std::string content = ReadFile(folder / "out" / name);
    const size_t at = content.find(old);
    ASSERT_NE(at, std::string::npos) << content;
    WriteFile(folder / "out" / name, content.replace(at, old.size(), text));
  }
  Finished Shoal(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "campaign");
    return RunShoal(folder, std::move(arguments));
  }
  const TestFolder folder;
  const std::string out = (folder / "out").string();
};

TEST(ResultsFolderOfOthers, HasItsTextsShownWithoutWhatATerminalExecutes) {
  FolderOfOthers others;
  const std::string evil = "\\u001b[2J\\u009b5m\\u202e\\nVerdict: PASS";
  others.Edit("campaign.json", "\"values\": [\n    \"5\"", "\"values\": [\n    \"" + evil + "\"");
  for (const std::string trial : {"zz", "1"}) {
    const Finished finished = others.Shoal({"replay", others.out, trial});
    EXPECT_EQ(finished.exit_code, 2) << finished.output;
    EXPECT_EQ(finished.output.find_first_of("\x1b\xe2\xc2"), std::string::npos) << finished.output;
    EXPECT_EQ(finished.output.find("\nVerdict"), std::string::npos) << finished.output;
    EXPECT_NE(finished.output.find("[2J"), std::string::npos) << finished.output;
  }
  FolderOfOthers other;
  other.Edit("campaign.json", "\"build\": \"", "\"build\": \"" + evil);
  const std::string digits = ReadFile(other.folder / "out/campaign.json");
  const size_t id = digits.find("\"id\": \"") + 7;
  const Finished finished = other.Shoal({"replay", other.out, digits.substr(id, 6) + "-1"});
  EXPECT_NE(finished.output.find("another build (?[2J"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find_first_of("\x1b\xe2\xc2"), std::string::npos) << finished.output;
  EXPECT_EQ(finished.output.find("\nVerdict"), std::string::npos) << finished.output;
}

}  // namespace shoal::campaign_outcomes_test
