#include "apps/shoal_encounters/encounters_options.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "apps/shoal_encounters/encounters_command.h"

namespace shoal {

namespace {

void AddSize(CLI::App* command, EncounterMissionOptions* options) {
  constexpr double kSmallest = 0.005;
  constexpr double kLargest = 2;
  constexpr double kSlowest_mps = 0.3;
  constexpr double kFastest_mps = 30;
  command
      ->add_option("--scale", options->scale.length,
                   "Lengths relative to those of ships; default: 0.0324, 6 NM are 360 m")
      ->check(CLI::Range(kSmallest, kLargest));
  command->add_option("--speed", options->scale.speed_mps, "Of own ship in m/s; default: 3")
      ->check(CLI::Range(kSlowest_mps, kFastest_mps));
  command->add_flag("--hold", options->others_hold,
                    "All but the first vessel hold course, without a behavior");
}

CLI::Option* AddNumVessels(CLI::App* command, EncounterChoice* choice) {
  return command->add_option("--vessels", choice->num_vessels, "2 to 8; default: by the seed")
      ->check(CLI::Range(2, kMaxRandomVessels));
}

}  // namespace

void AddEncounterCommands(CLI::App* encounters, CommandAction* action) {
  encounters->require_subcommand(1);

  const auto writes = [action](CLI::App* command, const std::shared_ptr<EncounterChoice>& choice) {
    command->callback([choice, action] {
      *action = [choice] { return WriteEncounter(*choice, std::cout, std::cerr); };
    });
  };

  CLI::App* imazu = encounters->add_subcommand("imazu", "A case of Imazu's problem");
  auto of_imazu = std::make_shared<EncounterChoice>();
  of_imazu->set = "imazu";
  imazu->add_option("N", of_imazu->number, "1 to 22")->required();
  AddSize(imazu, &of_imazu->mission);
  writes(imazu, of_imazu);

  CLI::App* single = encounters->add_subcommand("single", "An encounter with one target");
  auto of_single = std::make_shared<EncounterChoice>();
  of_single->set = "single";
  single->add_option("NAME", of_single->name, "As `shoal encounters list` names them")->required();
  AddSize(single, &of_single->mission);
  writes(single, of_single);

  CLI::App* random = encounters->add_subcommand("random", "A random encounter");
  auto of_random = std::make_shared<EncounterChoice>();
  AddNumVessels(random, of_random.get());
  random->add_option("--seed", of_random->seed, "Which one");
  AddSize(random, &of_random->mission);
  writes(random, of_random);

  encounters->add_subcommand("list", "The names of all encounters")->callback([action] {
    *action = [] { return ListEncounters(std::cout); };
  });

  CLI::App* run = encounters->add_subcommand(
      "run", "Run many in this process, one line of CSV for each on standard output");
  auto trials = std::make_shared<EncounterTrialsOptions>();
  run->add_option("SET", trials->choice.set, "random, or every case of imazu or single")
      ->required()
      ->check(CLI::IsMember({"random", "imazu", "single"}));
  AddNumVessels(run, &trials->choice);
  run->add_option("--first", trials->first_seed, "The first seed; default: 1");
  constexpr int64_t kMaxSeeds = 100'000'000;
  run->add_option("--seeds", trials->num_seeds, "How many seeds; default: 100")
      ->check(CLI::Range(int64_t{1}, kMaxSeeds));
  run->add_option("--set", trials->overrides, "Override a key of every mission file")
      ->take_all()
      ->allow_extra_args(false);
  AddSize(run, &trials->choice.mission);
  run->callback([trials, action] {
    *action = [trials] { return RunEncounterTrials(*trials, std::cout, std::cerr); };
  });
}

}  // namespace shoal
