#include "apps/shoal_encounters/encounters_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <ostream>
#include <utility>

#include "lib/bus/bus/channels.h"
#include "lib/helm/encounters/encounter_score.h"
#include "lib/helm/encounters/swing_watch.h"
#include "lib/mission/file/load.h"
#include "lib/mission/toml/suggest.h"
#include "sim/director_app.h"
#include "sim/simulation.h"

namespace shoal {

namespace {

std::string OptionWords(const EncounterMissionOptions& options) {
  std::string words;
  if (options.scale.length != ScenarioScale().length) {
    words += fmt::format(" --scale {:g}", options.scale.length);
  }
  if (options.scale.speed_mps != ScenarioScale().speed_mps) {
    words += fmt::format(" --speed {:g}", options.scale.speed_mps);
  }
  if (options.others_hold) words += " --hold";
  if (options.lead_m > 0) words += fmt::format(" --lead {:g}", options.lead_m);
  return words;
}

int VesselsOf(const EncounterChoice& choice) {
  constexpr uint64_t kNumCounts = kMaxRandomVessels - 1;
  return choice.num_vessels > 0 ? choice.num_vessels
                                : 2 + static_cast<int>(choice.seed % kNumCounts);
}

/// What came of one trial.
struct TrialNumbers {
  int64_t num_collisions = 0;
  int64_t num_encounters = 0;
  double closest_m = std::numeric_limits<double>::infinity();
  double lowest_score = 100;
  double sum_of_scores = 0;
  int64_t num_scores = 0;
  bool passed = false;
  int64_t num_swinging = 0;    ///< Vessels that swung three times, and ...
  int64_t num_port_turns = 0;  ///< ... that stood on, and turned to port for one on that side.
  double fastest_share = 0;    ///< Of a vessel: its greatest speed by the one that it is asked.
};

/// What one vessel did, from its true headings and speeds.
struct VesselTrace {
  SwingWatch swings;
  double fastest_mps = 0;
};

/// `only_first`: only what the first vessel was part of counts, and its own score.
TrialNumbers RunTrial(const Mission& mission, bool only_first) {
  Simulation simulation(mission, "");
  std::vector<VesselTrace> traces(mission.vehicles.size());
  for (size_t i = 0; i < traces.size(); ++i) {
    Subscribe(simulation.bus(), channels::Nav(mission.vehicles[i].name),
              [trace = &traces[i]](const nav_t& nav) {
                trace->swings.Look(nav.heading_deg);
                trace->fastest_mps = std::max(trace->fastest_mps, nav.speed_mps);
              });
  }
  while (simulation.Step()) {
  }
  simulation.End();
  TrialNumbers numbers;
  for (size_t i = 0; i < (only_first ? 1 : traces.size()); ++i) {
    constexpr int kZigzag = 3;
    if (traces[i].swings.num_swings() >= kZigzag) ++numbers.num_swinging;
    const double asked_mps = mission.vehicles[i].start.speed_mps;
    if (asked_mps <= 0) continue;
    numbers.fastest_share = std::max(numbers.fastest_share, traces[i].fastest_mps / asked_mps);
  }
  const Judge& judge = simulation.director().judge();
  for (const CollisionFact& each : judge.collisions()) {
    if (!only_first || each.collision.first == 0) ++numbers.num_collisions;
  }
  numbers.passed = simulation.Passed();
  const EncounterWatch* watch = judge.encounter_watch();
  if (watch == nullptr) return numbers;
  for (const Encounter& encounter : watch->Encounters()) {
    if (only_first && encounter.sides[0].vessel != 0) continue;
    ++numbers.num_encounters;
    numbers.closest_m = std::min(numbers.closest_m, encounter.closest_m);
    for (size_t i = 0; i < (only_first ? 1 : 2); ++i) {
      const double score = ScoreOf(encounter, i, watch->options()).overall;
      numbers.lowest_score = std::min(numbers.lowest_score, score);
      numbers.sum_of_scores += score;
      ++numbers.num_scores;
      if (encounter.sides[i].conduct.turned_to_port_while_standing_on) ++numbers.num_port_turns;
    }
  }
  return numbers;
}

/// Every encounter of the set, with one seed.
std::vector<EncounterChoice> ChoicesOfSeed(const EncounterTrialsOptions& options, uint64_t seed) {
  EncounterChoice choice = options.choice;
  choice.seed = choice.mission.seed = seed;
  std::vector<EncounterChoice> choices;
  if (choice.set == "imazu") {
    for (choice.number = 1; choice.number <= kNumImazuCases; ++choice.number) {
      choices.push_back(choice);
    }
  } else if (choice.set == "overtaking") {
    for (choice.number = 1; choice.number <= kNumOvertakingCases; ++choice.number) {
      choices.push_back(choice);
    }
  } else if (choice.set == "single") {
    for (const std::string_view name : SingleTargetNames()) {
      choice.name = name;
      choices.push_back(choice);
    }
  } else {
    choices.push_back(choice);
  }
  return choices;
}

}  // namespace

Result<ChosenEncounter> ChooseEncounter(const EncounterChoice& choice) {
  ChosenEncounter chosen;
  std::string words;
  if (choice.set == "imazu") {
    if (choice.number < 1 || choice.number > kNumImazuCases) {
      return Error{
          fmt::format("Imazu has no case {}: they are 1 to {}", choice.number, kNumImazuCases)};
    }
    chosen.scenario = ImazuCase(choice.number, choice.mission.scale);
    words = fmt::format("imazu {}", choice.number);
  } else if (choice.set == "overtaking") {
    if (choice.number < 1 || choice.number > kNumOvertakingCases) {
      return Error{fmt::format("overtaking: case {} does not exist; the cases are 1 to {}",
                               choice.number, kNumOvertakingCases)};
    }
    chosen.scenario = OvertakingCase(choice.number, choice.mission.scale);
    words = fmt::format("overtaking {}", choice.number);
  } else if (choice.set == "single") {
    auto scenario = SingleTarget(choice.name, choice.mission.scale);
    if (!scenario) {
      const std::vector<std::string_view> names(SingleTargetNames().begin(),
                                                SingleTargetNames().end());
      return Error{fmt::format("there is no encounter {}{}; `shoal encounters list` names them",
                               Quoted(choice.name), DidYouMean(choice.name, names))};
    }
    chosen.scenario = *std::move(scenario);
    words = "single " + choice.name;
  } else {
    const int num_vessels = VesselsOf(choice);
    if (num_vessels < 2 || num_vessels > kMaxRandomVessels) {
      return Error{fmt::format("random encounters have 2 to {} vessels, not {}", kMaxRandomVessels,
                               num_vessels)};
    }
    chosen.scenario = RandomEncounter(choice.seed, num_vessels, choice.mission.scale);
    words = fmt::format("random --vessels {} --seed {}", num_vessels, choice.seed);
  }
  words += OptionWords(choice.mission);
  chosen.mission = MissionTextOf(chosen.scenario, choice.mission, words);
  return chosen;
}

int WriteEncounter(const EncounterChoice& choice, std::ostream& out, std::ostream& err) {
  const Result<ChosenEncounter> chosen = ChooseEncounter(choice);
  if (!chosen.ok()) {
    err << "shoal: " << chosen.error() << '\n';
    return kExitUsage;
  }
  out << (*chosen).mission;
  return kExitOk;
}

int ListEncounters(std::ostream& out) {
  for (int number = 1; number <= kNumImazuCases; ++number) {
    const EncounterScenario scenario = ImazuCase(number, {});
    out << fmt::format("{:<28} {}, {} vessels\n", fmt::format("imazu {}", number),
                       scenario.description, scenario.vessels.size());
  }
  for (int number = 1; number <= kNumOvertakingCases; ++number) {
    out << fmt::format("{:<28} {}\n", fmt::format("overtaking {}", number),
                       OvertakingCase(number, {}).description);
  }
  for (const std::string_view name : SingleTargetNames()) {
    out << fmt::format("{:<28} {}\n", fmt::format("single {}", name),
                       SingleTarget(name, {})->description);
  }
  out << fmt::format("{:<28} 2 to {} vessels, as many encounters as there are seeds\n",
                     "random --vessels N --seed S", kMaxRandomVessels);
  return kExitOk;
}

int RunEncounterTrials(const EncounterTrialsOptions& options, std::ostream& out,
                       std::ostream& err) {
  int64_t num_trials = 0;
  int64_t num_with_collision = 0;
  int64_t num_passed = 0;
  std::string collided;
  out << "encounter,seed,vessels,collisions,encounters,closest_m,lowest_score,mean_score,passed,"
         "swinging,port_turns,fastest_share\n";
  for (int64_t i = 0; i < options.num_seeds; ++i) {
    const uint64_t seed = options.first_seed + static_cast<uint64_t>(i);
    for (const EncounterChoice& choice : ChoicesOfSeed(options, seed)) {
      const Result<ChosenEncounter> chosen = ChooseEncounter(choice);
      if (!chosen.ok()) {
        err << "shoal: " << chosen.error() << '\n';
        return kExitUsage;
      }
      const EncounterScenario& scenario = (*chosen).scenario;
      const LoadedMission loaded =
          LoadMissionText((*chosen).mission, scenario.name + ".toml", options.overrides);
      if (!loaded.errors.empty()) {
        for (const std::string& error : loaded.errors) err << error << '\n';
        return kExitUsage;
      }
      const TrialNumbers numbers = RunTrial(loaded.mission, choice.mission.others_hold);
      ++num_trials;
      if (numbers.passed) ++num_passed;
      const bool has_encounter = numbers.num_encounters > 0;
      out << fmt::format(
          "{},{},{},{},{},{},{},{},{:d},{},{},{:.3f}\n", scenario.name, seed,
          scenario.vessels.size(), numbers.num_collisions, numbers.num_encounters,
          has_encounter ? fmt::format("{:.3f}", numbers.closest_m) : "",
          has_encounter ? fmt::format("{:.2f}", numbers.lowest_score) : "",
          has_encounter ? fmt::format("{:.2f}", numbers.sum_of_scores /
                                                    static_cast<double>(numbers.num_scores))
                        : "",
          numbers.passed, numbers.num_swinging, numbers.num_port_turns, numbers.fastest_share);
      if (numbers.num_collisions == 0) continue;
      ++num_with_collision;
      constexpr int64_t kMaxNamed = 20;
      if (num_with_collision <= kMaxNamed) {
        collided += fmt::format("  {} with seed {}\n", scenario.name, seed);
      }
    }
    out.flush();
  }
  err << fmt::format("{} trials, {} without collision, {} passed\n", num_trials,
                     num_trials - num_with_collision, num_passed);
  if (!collided.empty()) err << "Collisions:\n" << collided;
  return num_with_collision == 0 ? kExitOk : kExitMissionFailed;
}

}  // namespace shoal
