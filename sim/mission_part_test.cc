#include "sim/mission_part.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "lib/mission/file/load.h"
#include "sim/director_app.h"
#include "sim/simulation.h"

namespace shoal::mission_part_test {

namespace fs = std::filesystem;

/// A file of its own for each call.
std::string LogPath() {
  static int counter = 0;
  return (fs::temp_directory_path() /
          ("shoal-part-" + std::to_string(getpid()) + "-" + std::to_string(counter++) + ".lcm"))
      .string();
}

/// What comes of a mission that all can see.
struct Outcome {
  std::string log;
  std::string summary;
  std::string fault;
  std::vector<std::string> losses;
  int64_t step = -1;

  bool operator==(const Outcome&) const = default;
};

std::string TakeFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  in.close();
  fs::remove(path);
  return bytes;
}

Outcome InOneProcess(const Mission& mission) {
  const std::string log = LogPath();
  Simulation simulation(mission, log);
  while (simulation.Step()) {
  }
  simulation.End();
  return {.log = TakeFile(log),
          .summary = simulation.Summary(),
          .fault = simulation.Fault(),
          .losses = simulation.losses(),
          .step = simulation.step()};
}

/// The parts of a mission in one process, with a log where `log_path` is not empty.
class Parts {
 public:
  Parts(const Mission& mission, const Placement& placement, const std::string& log_path) {
    for (size_t i = 0; i < placement.num_parts; ++i) {
      parts_.push_back(std::make_unique<MissionPart>(mission, placement, i, log_path));
    }
    ForEachPair([](MissionPart& from, size_t from_number, MissionPart& to, size_t) {
      EXPECT_TRUE(to.TakeInterests(from_number, from.Interests()));
    });
  }

  void Step() {
    for (auto& part : parts_) part->Step();
    ForEachPair([this](MissionPart& from, size_t from_number, MissionPart& to, size_t to_number) {
      num_bytes_ += from.BatchFor(to_number).size();
      ASSERT_TRUE(to.TakeBatch(from_number, from.BatchFor(to_number)));
    });
    for (auto& part : parts_) part->Decide();
    for (auto& part : parts_) ASSERT_EQ(part->MustEnd(), first().MustEnd());
  }

  void Run() {
    while (!first().MustEnd()) Step();
    for (auto& part : parts_) part->End();
    for (size_t i = 1; i < parts_.size(); ++i) {
      ASSERT_TRUE(first().TakeFates(parts_[i]->FatesForFirst()));
    }
  }

  MissionPart& first() { return *parts_.front(); }
  std::vector<std::unique_ptr<MissionPart>>& all() { return parts_; }
  size_t num_bytes() const { return num_bytes_; }

 private:
  template <class F>
  void ForEachPair(F use) {
    for (size_t from = 0; from < parts_.size(); ++from) {
      for (size_t to = 0; to < parts_.size(); ++to) {
        if (from != to) use(*parts_[from], from, *parts_[to], to);
      }
    }
  }

  std::vector<std::unique_ptr<MissionPart>> parts_;
  size_t num_bytes_ = 0;
};

Outcome InParts(const Mission& mission, const Placement& placement) {
  const std::string log = LogPath();
  Parts parts(mission, placement, log);
  parts.Run();
  for (auto& part : parts.all()) EXPECT_EQ(part->Fault(), parts.first().Fault());
  return {.log = TakeFile(log),
          .summary = parts.first().director()->Summary(true),
          .fault = parts.first().Fault(),
          .losses = parts.first().losses(),
          .step = parts.first().step()};
}

/// The first seconds of one of missions/.
Mission Load(const std::string& file, double duration_s) {
  LoadedMission loaded = LoadMission(std::string(SHOAL_SOURCE_DIR) + "/missions/" + file);
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  loaded.mission.duration_s = duration_s;
  return loaded.mission;
}

void ExpectTheSameInParts(const Mission& mission, std::vector<size_t> nums_of_parts) {
  const Outcome whole = InOneProcess(mission);
  EXPECT_GT(whole.log.size(), 10'000U);
  for (const size_t num_parts : nums_of_parts) {
    const Outcome parts = InParts(mission, *MakePlacement(mission, num_parts));
    EXPECT_TRUE(parts.log == whole.log) << mission.name << " in " << num_parts << " parts";
    EXPECT_EQ(parts.summary, whole.summary);
    EXPECT_EQ(parts.fault, whole.fault);
    EXPECT_EQ(parts.losses, whole.losses);
    EXPECT_EQ(parts.step, whole.step);
  }
}

TEST(MissionPart, GivesTheLogAndTheVerdictOfOneProcess) {
  ExpectTheSameInParts(Load("alpha.toml", 60), {1, 2, 4});
  ExpectTheSameInParts(Load("berta.toml", 60), {2, 3});
}

TEST(MissionPart, GivesTheLogOfAFleetAndOfAcousticNetworks) {
  ExpectTheSameInParts(Load("fleet.toml", 30), {3});
  ExpectTheSameInParts(Load("swarm_fdma.toml", 60), {2, 4});
  ExpectTheSameInParts(Load("acoustic_shared.toml", 60), {2});
  ExpectTheSameInParts(Load("search_gateway.toml", 60), {3});
}

TEST(MissionPart, GivesTheSameWhateverThePlacement) {
  const Mission mission = Load("fleet.toml", 20);
  const Outcome whole = InOneProcess(mission);
  for (size_t shift = 0; shift < 3; ++shift) {
    Placement placement = OnePart(mission);
    placement.num_parts = 3;
    for (size_t i = 0; i < mission.vehicles.size(); ++i) {
      placement.part_of_vehicle[i] = (i * 2 + shift) % 3;
    }
    EXPECT_TRUE(InParts(mission, placement) == whole) << shift;
  }
}

/// 150 vessels in three blocks that meet, send messages and change rules while they do, so that all
/// kinds of decisions about reports happen: counted together, too far, too soon, lost, wanted
/// whatever the rules.
Mission BusyFleet() {
  std::string text = R"(
[mission]
duration_s = 30
[comms]
comms_range = 150
each_fate_up_to = 100
min_rpt_interval = 0.7
drop_percentage = 10
shared_node_reports = 2
groups = false
[template.boat]
group = "boats"
helm_options = { deploy_at_start = true }
[[template.boat.task]]
name = "go"
kind = "waypoints"
points = [[0, 0], [400, 400]]
speed_mps = 3
[[fleet]]
template = "boat"
count = 150
name = "boat_{n:03}"
spacing_m = 60
)";
  const auto event = [&](const std::string& fields) { text += "[[event]]\n" + fields + "\n"; };
  event("at_s = 8\nrule = \"full_report\"\nvehicle = \"boat_030\"");
  event("at_s = 12\nrule = \"comms_range\"\nvalue = 90");
  event("at_s = 15\nrule = \"full_report\"\nvehicle = \"boat_120\"");
  event("at_s = 16\nrule = \"stealth\"\nvehicle = \"boat_077\"\nvalue = 0.5");
  event(
      "at_s = 20\nmessage = {src_node = \"boat_001\", dest_node = \"all\", var_name = \"HELLO\", "
      "string_val = \"ahoy\"}");
  LoadedMission loaded = LoadMissionText(text, "busy.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

TEST(MissionPart, GivesTheLogOfAFleetWhoseReportsSeveralPartsRoute) {
  const Mission mission = BusyFleet();
  for (const size_t num_parts : {2U, 3U}) {
    const Placement placement = *MakePlacement(mission, num_parts);
    EXPECT_GT(std::set(placement.part_of_block.begin(), placement.part_of_block.end()).size(), 1U);
  }
  ExpectTheSameInParts(mission, {2, 3, 5});
}

TEST(MissionPart, GivesTheSameWhicheverPartsRouteReports) {
  const Mission mission = BusyFleet();
  const Outcome whole = InOneProcess(mission);
  for (const std::vector<size_t>& part_of_block :
       {std::vector<size_t>{2, 0, 1}, {1, 1, 1}, {0, 2, 0}}) {
    Placement placement = *MakePlacement(mission, 3);
    placement.broker_part = 2;
    placement.part_of_block = part_of_block;
    EXPECT_TRUE(InParts(mission, placement) == whole);
  }
}

constexpr char kTwoVessels[] = R"(
[mission]
duration_s = 30
[[vehicle]]
name = "alpha"
helm_options = { deploy_at_start = true }
[[vehicle.task]]
name = "go"
kind = "waypoints"
points = [[40, 0]]
speed_mps = 2
[[vehicle]]
name = "bravo"
start = { x_m = 100, y_m = 0 }
helm_options = { deploy_at_start = true }
[[vehicle.task]]
name = "go"
kind = "waypoints"
points = [[140, 0]]
speed_mps = 2
)";

/// Both helms crash, `bravo` a second after `alpha` where `apart`.
Mission Crashing(const std::string& on_loss, bool apart) {
  std::string text = kTwoVessels;
  text.insert(text.find("[[vehicle]]"), "on_loss = \"" + on_loss + "\"\n");
  const auto fault = [](const std::string& after_s) {
    return "[[vehicle.behavior]]\nname = \"fault\"\nkind = \"test_failure\"\nduration = " +
           after_s + "\n";
  };
  const size_t second = text.rfind("[[vehicle]]");
  text += fault(apart ? "6" : "5");
  text.insert(second, fault("5"));
  LoadedMission loaded = LoadMissionText(text, "crashing.toml");
  EXPECT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  return loaded.mission;
}

TEST(MissionPart, EndsGoesOnAndRestartsAfterALossAsInOneProcess) {
  for (const char* on_loss : {"end", "continue", "restart"}) {
    for (const bool apart : {false, true}) {
      const Mission mission = Crashing(on_loss, apart);
      const Outcome whole = InOneProcess(mission);
      EXPECT_FALSE(whole.losses.empty() && whole.fault.empty());
      Placement placement = OnePart(mission);
      placement.num_parts = 3;
      placement.part_of_vehicle = {2, 1};
      EXPECT_TRUE(InParts(mission, placement) == whole) << on_loss << apart;
    }
  }
}

TEST(MissionPart, EndsAllInTheStepInWhichTheDirectorEndsTheMission) {
  std::string text = kTwoVessels;
  const std::string options = "deploy_at_start = true";
  for (size_t at = text.find(options); at != std::string::npos; at = text.find(options, at + 60)) {
    text.insert(at + options.size(), ", end_of_tasks = \"end_mission\"");
  }
  const LoadedMission loaded = LoadMissionText(text, "ending.toml");
  ASSERT_TRUE(loaded.errors.empty()) << loaded.errors.front();
  const Outcome whole = InOneProcess(loaded.mission);
  ASSERT_LT(whole.step, loaded.mission.LastStep());
  EXPECT_TRUE(InParts(loaded.mission, *MakePlacement(loaded.mission, 2)) == whole);
}

TEST(MissionPart, SendsOnlyWhatIsReadWhereNothingIsRecorded) {
  const Mission mission = Load("fleet.toml", 10);
  const Placement placement = *MakePlacement(mission, 2);
  Parts quiet(mission, placement, "");
  quiet.Run();
  const std::string log = LogPath();
  Parts recorded(mission, placement, log);
  recorded.Run();
  TakeFile(log);
  EXPECT_GT(quiet.num_bytes(), 10'000U);
  EXPECT_LT(quiet.num_bytes(), recorded.num_bytes() * 9 / 10);
}

TEST(MissionPart, LeavesALogOfAllStepsBeforeTheOneInWhichAnotherPartIsLost) {
  const Mission mission = Load("berta.toml", 10);
  const std::string whole = InOneProcess(mission).log;
  const std::string path = LogPath();
  {
    Parts parts(mission, *MakePlacement(mission, 2), path);
    for (int step = 0; step < 50; ++step) parts.Step();
    parts.first().Step();  // The other part does not answer any more.
    parts.first().Abandon();
  }
  const std::string log = TakeFile(path);
  EXPECT_TRUE(whole.starts_with(log));
  EXPECT_GT(log.size(), whole.size() / 3);
  EXPECT_LT(log.size(), whole.size() * 2 / 3);
}

TEST(MissionPart, RefusesInterestsAndBatchesThatAreDamaged) {
  const Mission mission = Load("alpha.toml", 10);
  const Placement placement = *MakePlacement(mission, 2);
  MissionPart part(mission, placement, 0, "");
  MissionPart other(mission, placement, 1, "");
  const Bytes interests = other.Interests();
  EXPECT_FALSE(part.TakeInterests(1, {}));
  EXPECT_FALSE(part.TakeInterests(1, std::span(interests).first(interests.size() - 1)));
  EXPECT_TRUE(part.TakeInterests(1, interests));
  EXPECT_TRUE(other.TakeInterests(0, part.Interests()));
  part.Step();
  other.Step();
  const std::span<const uint8_t> batch = other.BatchFor(0);
  ASSERT_GT(batch.size(), 100U);
  EXPECT_FALSE(part.TakeBatch(1, batch.first(batch.size() - 1)));
}

TEST(MissionPart, EndsAllPartsAfterTheStepInWhichOneIsInterrupted) {
  const Mission mission = Load("berta.toml", 10);
  Parts parts(mission, *MakePlacement(mission, 2), "");
  parts.all()[1]->Interrupt();
  parts.Run();
  EXPECT_EQ(parts.first().step(), 0);
  EXPECT_TRUE(parts.first().was_interrupted());
}

}  // namespace shoal::mission_part_test
