#include "lib/tools/trials/campaign_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "lib/base/arithmetic/arithmetic_id.h"
#include "lib/tools/campaign/folder_testing.h"
#include "lib/tools/trials/reduce.h"
#include "lib/tools/trials/shard_file.h"
#include "lib/tools/trials/submit.h"

namespace shoal {
namespace {

constexpr char kBuild[] = "0123456789abcdef";

std::string TextOfFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class CampaignFolderTest : public testing::Test {
 protected:
  CampaignFolderTest() { WriteMission(kShortMission); }

  void WriteMission(const std::string& text) { std::ofstream(tmp_ / "m.toml") << text; }

  LoadedCampaign Load(const std::string& text) const {
    return LoadCampaignText(text, tmp_ / "c.toml", tmp_ / "");
  }

  Result<CampaignFolder> Open(const std::string& text, const std::string& build = kBuild) const {
    const LoadedCampaign loaded = Load(text);
    EXPECT_EQ(loaded.errors, std::vector<std::string>{});
    const MadePlan made = MakePlan(loaded.campaign, build);
    EXPECT_EQ(made.errors, std::vector<std::string>{});
    return OpenCampaignFolder(tmp_ / "out", loaded, made.plan);
  }

  std::string WhyRefused(const std::string& text, const std::string& build = kBuild) const {
    const Result<CampaignFolder> opened = Open(text, build);
    return opened.ok() ? "" : opened.error();
  }

  void Append(const CampaignFolder& folder, size_t number, int64_t repetition,
              const TrialResult& result, const std::string& shard = "1-of-1") const {
    Result<ShardFile> file = ShardFile::Open(tmp_ / ("out/shards/" + shard + ".jsonl"));
    ASSERT_TRUE(file.ok());
    const FinishedTrial trial{.key = {folder.plan.cases[number].id, repetition}, .result = result};
    EXPECT_EQ(file->Append(TrialLine(trial, folder.plan.metrics)), "");
  }

  TemporaryFolder tmp_;
};

/// Makes `name` of the results a link to a folder or a file of the user's own.
class LinkedCampaignFolder : public CampaignFolderTest {
 protected:
  LinkedCampaignFolder() {
    EXPECT_TRUE(Open(CampaignText(10)).ok());
    std::filesystem::create_directories(tmp_ / "mine/T");
    std::ofstream(tmp_ / "mine/T/file") << "mine";
  }
  void Link(const std::string& name, const std::string& target) const {
    std::filesystem::remove_all(tmp_ / ("out/" + name));
    std::filesystem::create_symlink(tmp_ / target, tmp_ / ("out/" + name));
  }
  void ExpectMineIsAsItWas() const {
    EXPECT_EQ(TextOfFile(tmp_ / "mine/T/file"), "mine");
    int count = 0;
    for ([[maybe_unused]] const auto& each :
         std::filesystem::recursive_directory_iterator(tmp_ / "mine")) {
      ++count;
    }
    EXPECT_EQ(count, 2);
  }
};

TEST_F(LinkedCampaignFolder, HasNoFolderOfTrialsReplacedBehindALink) {
  for (const std::string kind : {"replays", "failures"}) {
    Link(kind, "mine");
    const auto made = NewTrialFolder(tmp_ / ("out/" + kind + "/T"));
    ASSERT_FALSE(made.ok());
    EXPECT_NE(made.error().find(kind + ": is a link"), std::string::npos) << made.error();
    ExpectMineIsAsItWas();
  }
}

TEST_F(LinkedCampaignFolder, HasATrialThatIsALinkReplacedByAFolder) {
  std::filesystem::create_directories(tmp_ / "out/replays");
  Link("replays/T", "mine/T");
  const auto made = NewTrialFolder(tmp_ / "out/replays/T");
  ASSERT_TRUE(made.ok()) << made.error();
  EXPECT_TRUE(std::filesystem::is_empty(*made));
  EXPECT_FALSE(std::filesystem::is_symlink(*made));
  ExpectMineIsAsItWas();
}

TEST_F(LinkedCampaignFolder, HasNoShardOrLockWrittenThroughALink) {
  Link("shards/1-of-1.jsonl", "mine/T/file");
  const auto shard = ShardFile::Open(tmp_ / "out/shards/1-of-1.jsonl");
  ASSERT_FALSE(shard.ok());
  EXPECT_NE(shard.error().find("1-of-1.jsonl: is a link"), std::string::npos) << shard.error();
  Link("lock", "mine/new");
  EXPECT_NE(WhyRefused(CampaignText(10)).find("lock: is a link"), std::string::npos)
      << WhyRefused(CampaignText(10));
  Link("shards", "mine");
  EXPECT_NE(MakeCampaignFolder(tmp_ / "out").find("shards: is a link"), std::string::npos);
  EXPECT_FALSE(ShardFile::Open(tmp_ / "out/shards/1-of-1.jsonl").ok());
  ExpectMineIsAsItWas();
}

/// Each file is sound where the link leads, so that following it would go unseen.
TEST_F(LinkedCampaignFolder, HasNothingReadThroughALink) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  Append(*folder, 0, 1, {.outcome = TrialOutcome::kPass, .why = {}, .metrics = {}}, "1-of-2");
  ASSERT_TRUE(ReadShards(*folder).ok());
  std::filesystem::copy(tmp_ / "out", tmp_ / "whole", std::filesystem::copy_options::recursive);
  for (const std::string name : {"shards/1-of-2.jsonl", "shards"}) {
    Link(name, "whole/" + name);
    const auto read = ReadShards(*folder);
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_NE(read.error().find(name + ": is a link"), std::string::npos) << read.error();
    std::filesystem::remove(tmp_ / ("out/" + name));
    std::filesystem::copy(tmp_ / ("whole/" + name), tmp_ / ("out/" + name),
                          std::filesystem::copy_options::recursive);
  }
  for (const std::string name : {"campaign.toml", "campaign.json"}) {
    Link(name, "whole/" + name);
    const auto read = ReadCampaignFolder(tmp_ / "out");
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_NE(read.error().find(name + ": is a link"), std::string::npos) << read.error();
    std::filesystem::remove(tmp_ / ("out/" + name));
    std::filesystem::copy(tmp_ / ("whole/" + name), tmp_ / ("out/" + name));
    EXPECT_TRUE(ReadCampaignFolder(tmp_ / "out").ok());
  }
}

TEST_F(CampaignFolderTest, DoesNotWaitForAMissionThatIsAPipe) {
  std::filesystem::remove(tmp_ / "m.toml");
  ASSERT_EQ(mkfifo(std::string(tmp_ / "m.toml").c_str(), 0600), 0);
  const MadePlan made = MakePlan(Load(CampaignText(10)).campaign, kBuild);
  ASSERT_EQ(made.errors.size(), 1U);
  EXPECT_NE(made.errors[0].find("m.toml: is not a regular file"), std::string::npos)
      << made.errors[0];
}

TEST_F(LinkedCampaignFolder, HasNoJobAppendedThroughALink) {
  std::filesystem::create_directories(tmp_ / "out/slurm");
  Link("slurm/jobs", "mine/T/file");
  EXPECT_NE(AppendSlurmJob(tmp_ / "out/slurm/jobs", {.id = 1}).find("jobs: is a link"),
            std::string::npos);
  ExpectMineIsAsItWas();
}

TEST_F(CampaignFolderTest, ReadsBackWhatItWasMadeFor) {
  const auto made = Open(CampaignText(10));
  ASSERT_TRUE(made.ok());
  const auto read = ReadCampaignFolder(tmp_ / "out");
  ASSERT_TRUE(read.ok()) << read.error();
  ASSERT_EQ(read->plan.cases.size(), 2U);
  EXPECT_EQ(read->plan.cases[1].id, made->plan.cases[1].id);
  EXPECT_EQ(read->plan.cases[1].values, std::vector<std::string>{"200"});
  EXPECT_EQ(read->plan.metrics, made->plan.metrics);
  EXPECT_EQ(read->campaign.repetitions, 10);
}

TEST_F(CampaignFolderTest, TakesMoreRepetitionsPointsAndPoliciesLater) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  EXPECT_EQ(WhyRefused(CampaignText(20)), "");
  EXPECT_EQ(WhyRefused("[campaign]\nmission = \"m.toml\"\nrepetitions = 20\n[sweep]\n"
                       "\"comms.comms_range\" = [50, 100, 150, 200]\n"),
            "");
}

TEST_F(CampaignFolderTest, RefusesWhatWouldMixOrDropResultsAndChangesNothing) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  const std::string facts = TextOfFile(tmp_ / "out/campaign.json");
  EXPECT_NE(WhyRefused(CampaignText(10), "fedcba9876543210").find("another build of shoal"),
            std::string::npos);
  EXPECT_NE(WhyRefused(CampaignText(9)).find("with 10 repetitions"), std::string::npos);
  EXPECT_NE(WhyRefused("[campaign]\nmission = \"m.toml\"\nrepetitions = 10\n[sweep]\n"
                       "\"comms.comms_range\" = [100]\n")
                .find("has the case comms.comms_range=200"),
            std::string::npos);
  EXPECT_NE(WhyRefused(CampaignText(10, "[metrics]\nd = {kind = \"distance_travelled\"}\n"))
                .find("other metrics"),
            std::string::npos);
  EXPECT_NE(
      WhyRefused(CampaignText(10, "[sample]\n\"vehicle.alpha.start.x_m\" = {uniform = [0, 1]}\n"))
          .find("other samples"),
      std::string::npos);
  WriteMission(std::string(kShortMission) + "within_m = 30\n");
  EXPECT_NE(WhyRefused(CampaignText(10)).find("another text of the mission"), std::string::npos);
  EXPECT_EQ(TextOfFile(tmp_ / "out/campaign.json"), facts);
}

TEST_F(CampaignFolderTest, TakesAMissionWhoseCommentsAloneHaveChanged) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  WriteMission("# A comment.\n" + std::string(kShortMission));
  EXPECT_EQ(WhyRefused(CampaignText(10)), "");
}

TEST_F(CampaignFolderTest, RefusesAFolderOfOtherFiles) {
  std::filesystem::create_directories(tmp_ / "out");
  std::ofstream(tmp_ / "out/thesis.tex") << "years";
  EXPECT_NE(WhyRefused(CampaignText(10)).find("holds other files (thesis.tex)"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(tmp_ / "out/campaign.json"));
}

TEST_F(CampaignFolderTest, NamesFactsThatAreDamaged) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  const std::string facts = TextOfFile(tmp_ / "out/campaign.json");
  for (size_t size = 0; size < facts.size() - 2; size += 7) {
    std::ofstream(tmp_ / "out/campaign.json") << facts.substr(0, size);
    const auto read = ReadCampaignFolder(tmp_ / "out");
    ASSERT_FALSE(read.ok()) << size;
    EXPECT_NE(read.error().find("campaign.json: "), std::string::npos) << read.error();
  }
}

TEST_F(CampaignFolderTest, RefusesFactsThatWouldTakeMemory) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  const auto error_of = [&](const std::string& facts) {
    std::ofstream(tmp_ / "out/campaign.json") << facts;
    const auto read = ReadCampaignFolder(tmp_ / "out");
    return read.ok() ? "no error" : read.error();
  };
  const std::string deep = error_of("{\n\"cases\": " + std::string(1'000'000, '['));
  EXPECT_NE(deep.find("campaign.json: line 2: nested more than 8 deep"), std::string::npos) << deep;
  const std::string wide = error_of("[\n" + std::string(5'000'000, ','));
  EXPECT_NE(wide.find("campaign.json: line 2: more than 5000000 values"), std::string::npos)
      << wide;
  // The parser's message quotes what it read last.
  const std::string quoted = error_of("[\"\x1b[2J" + std::string(100'000, 'x') + "\" x]");
  EXPECT_NE(quoted.find("campaign.json: not what shoal writes"), std::string::npos) << quoted;
  EXPECT_LT(quoted.size(), 500U);
  EXPECT_EQ(quoted.find('\x1b'), std::string::npos);
}

TEST_F(CampaignFolderTest, ReadsShardsWithTornForeignAndRepeatedLines) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  Append(*folder, 0, 1, PassWith(1));
  std::ofstream(tmp_ / "out/shards/1-of-1.jsonl", std::ios::app) << R"({"case":"torn)";
  Append(*folder, 0, 2, PassWith(2));
  Append(*folder, 0, 1, PassWith(1), "2-of-2");
  Append(*folder, 1, 11, PassWith(1));  // Beyond the repetitions.
  std::ofstream(tmp_ / "out/shards/3-of-9.jsonl") << std::string(1'000'000, 'x') << '\n'
                                                  << std::string(5000, '\n');
  const auto stored = ReadShards(*folder);
  ASSERT_TRUE(stored.ok());
  EXPECT_EQ(stored->size(), 2);
  EXPECT_EQ(stored->num_torn, 2);
  EXPECT_EQ(stored->num_foreign, 1);
  EXPECT_TRUE(stored->differing.empty());
}

TEST_F(CampaignFolderTest, NamesATrialWithTwoResults) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  Append(*folder, 0, 1, PassWith(1));
  Append(*folder, 0, 1, PassWith(1.5), "1-of-2");
  const auto results = ReduceCampaign(*folder);
  ASSERT_FALSE(results.ok());
  EXPECT_NE(results.error().find(TrialName({folder->plan.cases[0].id, 1})), std::string::npos);
}

TEST_F(CampaignFolderTest, NamesShardsOfAnotherArithmetic) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  EXPECT_EQ(folder->plan.arithmetic, ArithmeticId());
  Append(*folder, 0, 1, PassWith(1));
  FinishedTrial other{.key = {folder->plan.cases[0].id, 2}, .result = PassWith(3)};
  const auto reduced_with = [&](const std::string& arithmetic) {
    other.arithmetic = arithmetic;
    std::ofstream(tmp_ / "out/shards/2-of-3.jsonl")
        << TrialLine(other, folder->plan.metrics) << '\n';
    const auto results = ReduceCampaign(*folder);
    return results.ok() ? "" : results.error();
  };
  EXPECT_EQ(reduced_with(ArithmeticId()), "");
  EXPECT_NE(reduced_with("0123").find("are in shards/2-of-3.jsonl (0123): results of two"),
            std::string::npos)
      << reduced_with("0123");
}

TEST_F(CampaignFolderTest, LetsTheLastAttemptOfATrialCount) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  Append(*folder, 0, 1, {.outcome = TrialOutcome::kError, .why = "x", .metrics = {}});
  FinishedTrial again{.key = {folder->plan.cases[0].id, 1}, .result = PassWith(3), .attempt = 1};
  std::ofstream(tmp_ / "out/shards/1-of-3.jsonl") << TrialLine(again, folder->plan.metrics) << '\n';
  const auto stored = ReadShards(*folder);
  ASSERT_TRUE(stored.ok());
  EXPECT_TRUE(stored->differing.empty());
  EXPECT_EQ(stored->by_case[0].at(1).result.outcome, TrialOutcome::kPass);
}

TEST_F(CampaignFolderTest, LocksAShardForOneProcess) {
  ASSERT_TRUE(Open(CampaignText(10)).ok());
  const auto first = ShardFile::Open(tmp_ / "out/shards/1-of-1.jsonl");
  ASSERT_TRUE(first.ok());
  const auto second = ShardFile::Open(tmp_ / "out/shards/1-of-1.jsonl");
  ASSERT_FALSE(second.ok());
  EXPECT_NE(second.error().find("another process runs this shard"), std::string::npos);
}

TEST_F(CampaignFolderTest, ReducesToTheSameBytesInWhateverOrderTrialsFinished) {
  const auto folder =
      Open(CampaignText(3, "[sample]\n\"vehicle.alpha.start.x_m\" = {uniform = [0, 1]}\n"));
  ASSERT_TRUE(folder.ok());
  const std::vector<std::pair<size_t, int64_t>> order = {{1, 2}, {0, 3}, {0, 1},
                                                         {1, 1}, {1, 3}, {0, 2}};
  for (const auto& [number, repetition] : order) {
    Append(*folder, number, repetition, PassWith(static_cast<double>(repetition) / 3));
  }
  ASSERT_TRUE(ReduceCampaign(*folder).ok());
  const std::string csv = TextOfFile(tmp_ / "out/results.csv");
  const std::string sqlite = TextOfFile(tmp_ / "out/results.sqlite");
  std::filesystem::remove(tmp_ / "out/shards/1-of-1.jsonl");
  for (auto each = order.rbegin(); each != order.rend(); ++each) {
    Append(*folder, each->first, each->second, PassWith(static_cast<double>(each->second) / 3),
           each->first == 0 ? "1-of-2" : "2-of-2");
  }
  ASSERT_TRUE(ReduceCampaign(*folder).ok());
  EXPECT_EQ(TextOfFile(tmp_ / "out/results.csv"), csv);
  EXPECT_EQ(TextOfFile(tmp_ / "out/results.sqlite"), sqlite);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "case,comms.comms_range,policy,repetition,seed,vehicle.alpha.start.x_m,outcome,why,"
            "expect_1");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
}

TEST_F(CampaignFolderTest, FindsATrialByTheFirstDigitsOfItsCase) {
  const auto folder = Open(CampaignText(10));
  ASSERT_TRUE(folder.ok());
  const std::string& id = folder->plan.cases[1].id;
  EXPECT_EQ(FindTrial(*folder, id + "-7")->case_id, id);
  EXPECT_EQ(FindTrial(*folder, id.substr(0, 4) + "-7")->repetition, 7);
  for (const std::string& bad : {id + "-0", id + "-11", id, std::string("-3"), std::string()}) {
    const auto found = FindTrial(*folder, bad);
    ASSERT_FALSE(found.ok()) << bad;
    EXPECT_NE(found.error().find("comms.comms_range=200"), std::string::npos);
  }
}

}  // namespace
}  // namespace shoal
