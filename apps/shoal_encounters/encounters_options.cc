#include "apps/shoal_encounters/encounters_options.h"

#include <iostream>
#include <memory>
#include <string>

#include "apps/shoal_encounters/encounters_command.h"
#include "lib/run/command_line/tool_commands.h"

namespace shoal {

namespace {

void AddSize(Command command, EncounterMissionOptions* options) {
  constexpr double kSmallest = 0.005;
  constexpr double kLargest = 2;
  constexpr double kSlowest_mps = 0.3;
  constexpr double kFastest_mps = 30;
  command
      .AddOption("--scale", &options->scale.length,
                 "Lengths relative to those of ships; default: 0.0324, 6 NM are 360 m")
      .InRange(kSmallest, kLargest);
  command.AddOption("--speed", &options->scale.speed_mps, "Of own ship in m/s; default: 3")
      .InRange(kSlowest_mps, kFastest_mps);
  command.AddFlag("--hold", &options->others_hold,
                  "All but the first vessel hold course, without a behavior");
  constexpr double kLongestLead_m = 1000;
  command
      .AddOption("--lead", &options->lead_m,
                 "Vessels follow the line to their goal with this lead in m; default: 0, they "
                 "steer for the goal")
      .InRange(0.0, kLongestLead_m);
}

Option AddNumVessels(Command command, EncounterChoice* choice) {
  return command.AddOption("--vessels", &choice->num_vessels, "2 to 8; default: by the seed")
      .InRange(2, kMaxRandomVessels);
}

}  // namespace

void AddEncounterCommands(Command encounters, CommandAction* action) {
  encounters.RequireSubcommand();

  const auto writes = [action](Command command, const std::shared_ptr<EncounterChoice>& choice) {
    command.Callback([choice, action] {
      *action = [choice] { return WriteEncounter(*choice, std::cout, std::cerr); };
    });
  };

  const Command imazu = encounters.AddSubcommand("imazu", "A case of Imazu's problem");
  auto of_imazu = std::make_shared<EncounterChoice>();
  of_imazu->set = "imazu";
  imazu.AddOption("N", &of_imazu->number, "1 to 22").Required();
  AddSize(imazu, &of_imazu->mission);
  writes(imazu, of_imazu);

  const Command overtaking =
      encounters.AddSubcommand("overtaking", "A vessel that overtakes another from dead astern");
  auto of_overtaking = std::make_shared<EncounterChoice>();
  of_overtaking->set = "overtaking";
  overtaking.AddOption("N", &of_overtaking->number, "1 to 22").Required();
  AddSize(overtaking, &of_overtaking->mission);
  writes(overtaking, of_overtaking);

  const Command single = encounters.AddSubcommand("single", "An encounter with one target");
  auto of_single = std::make_shared<EncounterChoice>();
  of_single->set = "single";
  single.AddOption("NAME", &of_single->name, "As `shoal encounters list` names them").Required();
  AddSize(single, &of_single->mission);
  writes(single, of_single);

  const Command random = encounters.AddSubcommand("random", "A random encounter");
  auto of_random = std::make_shared<EncounterChoice>();
  AddNumVessels(random, of_random.get());
  random.AddOption("--seed", &of_random->seed, "Which one");
  AddSize(random, &of_random->mission);
  writes(random, of_random);

  encounters.AddSubcommand("list", "The names of all encounters").Callback([action] {
    *action = [] { return ListEncounters(std::cout); };
  });

  const Command run = encounters.AddSubcommand(
      "run", "Run many in this process, one line of CSV for each on standard output");
  auto trials = std::make_shared<EncounterTrialsOptions>();
  run.AddOption("SET", &trials->choice.set, "random, or every case of imazu, single or overtaking")
      .Required()
      .OneOf({"random", "imazu", "single", "overtaking"});
  AddNumVessels(run, &trials->choice);
  run.AddOption("--first", &trials->first_seed, "The first seed; default: 1");
  constexpr int64_t kMaxSeeds = 100'000'000;
  run.AddOption("--seeds", &trials->num_seeds, "How many seeds; default: 100")
      .InRange(int64_t{1}, kMaxSeeds);
  run.AddOption("--set", &trials->overrides, "Override a key of every mission file").Repeatable();
  AddSize(run, &trials->choice.mission);
  run.Callback([trials, action] {
    *action = [trials] { return RunEncounterTrials(*trials, std::cout, std::cerr); };
  });
}

int RunShoalEncounters(int argc, char** argv) {
  return RunToolCommand("encounters", argc, argv, AddEncounterCommands);
}

}  // namespace shoal
