#include "apps/shoal_log/log_options.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/shoal_log/log_comms.h"
#include "apps/shoal_log/log_encounters.h"
#include "apps/shoal_log/log_helm.h"
#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/moos_text/alog.h"
#include "lib/run/run/log_arguments.h"
#include "lib/run/run/reading_bar.h"

namespace shoal {

namespace {

void AddLogEncounters(Command log, CommandAction* action) {
  const Command command = log.AddSubcommand(
      "encounters", "Show the encounters of vessels, and how well each kept to the rules");
  auto options = std::make_shared<LogEncountersOptions>();
  command.AddOption("LOG", &options->path, kLogArgument).Required();
  const Option csv = command.AddFlag("--csv", &options->csv, "Every number, as CSV");
  command.AddFlag("--explain", &options->explain, "Every number, in words").Excludes(csv);
  command.AddFlag("--all", &options->all, "Show all encounters, however many there are");
  command.AddFlag("--skip-damage", &options->skip_damage, "Read what can be read of a damaged log");
  const auto distance = [command](const char* name, double* value_m, const char* what) {
    constexpr double kShortest_m = 0.1;
    constexpr double kLongest_m = 1e6;
    command.AddOption(name, value_m, fmt::format("{}; default: {:g} m", what, *value_m))
        .InRange(kShortest_m, kLongest_m);
  };
  EncounterOptions& encounter = options->encounter;
  distance("--entry-range", &encounter.entry_range_m, "Encounters begin nearer than this");
  distance("--risk", &encounter.risk_m, "Where holding on would take them nearer than this");
  distance("--end-range", &encounter.end_range_m, "They end farther apart than this");
  distance("--preferred", &encounter.preferred_m, "Passing at this distance is scored in full");
  distance("--acceptable", &encounter.acceptable_m, "Nearer than this is not safe");
  distance("--near-miss", &encounter.near_miss_m, "Nearer than this is a near miss");
  command.Callback([options, action] {
    *action = [options] { return LogEncounters(*options, std::cout, std::cerr); };
  });
}

void AddLogCopy(Command log, CommandAction* action) {
  const Command command = log.AddSubcommand(
      "copy", "Copy a log or a part of it; a name that ends in .zst makes it compressed");
  auto options = std::make_shared<LogCopyOptions>();
  command.AddOption("A", &options->path, kLogArgument).Required();
  command.AddOption("B", &options->out_path, "The copy, in place of a file of this name")
      .Required();
  AddLogSelection(command, &options->selection);
  command.AddFlag("--skip-damage", &options->skip_damage, "Copy what can be read of a bad log");
  command.Callback([options, action] {
    *action = [options] {
      if (!IsSelectionSound(options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogCopy(*options, std::cout, std::cerr);
    };
  });
}

}  // namespace

void AddLogCommands(Command log, CommandAction* action) {
  log.RequireSubcommand();

  const Command info = log.AddSubcommand("info", "Channels, types, counts, rates, time span");
  auto info_options = std::make_shared<LogInfoOptions>();
  info.AddOption("LOG", &info_options->path, kLogArgument).Required();
  AddLogTypes(info, &info_options->types);
  info.Callback([info_options, action] {
    *action = [info_options] {
      ReadingBar bar(info_options->path);
      info_options->progress = [&](double share) { bar.Show(share); };
      return LogInfo(*info_options, std::cout, std::cerr);
    };
  });

  const Command cat = log.AddSubcommand("cat", "Messages as text, one line each");
  auto cat_options = std::make_shared<LogCatOptions>();
  cat.AddOption("LOG", &cat_options->path, kLogArgument).Required();
  AddLogSelection(cat, &cat_options->selection);
  cat.AddOption("--limit", &cat_options->limit, "Lines at most");
  cat.AddFlag("--skip-damage", &cat_options->skip_damage, "Print what can be read of a bad log");
  AddLogTypes(cat, &cat_options->types);
  cat.Callback([cat_options, action] {
    *action = [cat_options] {
      if (!IsSelectionSound(cat_options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogCat(*cat_options, std::cout, std::cerr);
    };
  });

  AddLogCopy(log, action);

  const Command diff = log.AddSubcommand("diff", "First difference between two logs");
  auto diff_options = std::make_shared<LogDiffOptions>();
  diff.AddOption("A", &diff_options->path_a, kLogArgument).Required();
  diff.AddOption("B", &diff_options->path_b, kLogArgument).Required();
  AddWithout(diff, &diff_options->without);
  AddLogTypes(diff, &diff_options->types);
  diff.Callback([diff_options, action] {
    *action = [diff_options] { return LogDiff(*diff_options, std::cout, std::cerr); };
  });

  const Command csv = log.AddSubcommand("csv", "One CSV file per channel");
  auto csv_options = std::make_shared<LogCsvOptions>();
  auto is_moos = std::make_shared<bool>(false);
  csv.AddOption("LOG", &csv_options->path, kLogArgument).Required();
  csv.AddOption("--out", &csv_options->out_dir, "Folder for the files").Required();
  AddLogSelection(csv, &csv_options->selection);
  csv.AddFlag("--skip-damage", &csv_options->skip_damage, "Convert what can be read of a bad log");
  csv.AddFlag("--moos", is_moos.get(),
              "Also write node reports as MOOS text, for alog tools: <CHANNEL>.alog");
  AddLogTypes(csv, &csv_options->types);
  csv.Callback([csv_options, is_moos, action] {
    if (*is_moos) csv_options->lines = NodeReportsAsAlog();
    *action = [csv_options] {
      if (!IsSelectionSound(csv_options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogCsv(*csv_options, std::cout, std::cerr);
    };
  });

  const Command comms = log.AddSubcommand(
      "comms", "Show what was delivered and lost per link, why, and the age of information");
  auto comms_options = std::make_shared<LogCommsOptions>();
  comms.AddOption("LOG", &comms_options->path, kLogArgument).Required();
  comms.AddOption("--csv", &comms_options->csv_dir, "Also write tables into this folder");
  comms.AddFlag("--all", &comms_options->all, "Show all links, however many there are");
  comms.AddFlag("--skip-damage", &comms_options->skip_damage, "Read what can be read of a bad log");
  comms.Callback([comms_options, action] {
    *action = [comms_options] { return LogComms(*comms_options, std::cout, std::cerr); };
  });

  const Command helm =
      log.AddSubcommand("helm", "Show why a helm with behaviors steered as it did");
  auto helm_options = std::make_shared<LogHelmOptions>();
  helm.AddOption("LOG", &helm_options->path, kLogArgument).Required();
  helm.AddOption("--vehicle", &helm_options->vehicle, "Only this vehicle");
  helm.AddOption("--at", &helm_options->at_s, "In full: the decision at this time, seconds");
  helm.AddFlag("--changes", &helm_options->only_changes,
               "Leave out decisions that hardly differ from the line before");
  helm.AddFlag("--skip-damage", &helm_options->skip_damage, "Read what can be read of a bad log");
  helm.Callback([helm_options, action] {
    *action = [helm_options] { return LogHelm(*helm_options, std::cout, std::cerr); };
  });
  AddLogEncounters(log, action);
  ListToolCommands(log, "log");
}

int RunShoalLog(int argc, char** argv) {
  if (const auto code = StartToolCommand(argc, argv, "log")) return *code;
  return RunToolCommand("log", argc, argv, AddLogCommands);
}

}  // namespace shoal
