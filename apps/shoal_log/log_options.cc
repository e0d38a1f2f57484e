#include "apps/shoal_log/log_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "apps/shoal_log/log_comms.h"
#include "apps/shoal_log/log_encounters.h"
#include "apps/shoal_log/log_helm.h"
#include "lib/base/check/result.h"
#include "lib/bus/record/log_commands.h"
#include "lib/run/moos_text/alog.h"
#include "lib/tools/mcap/log_mcap.h"
#include "lib/tools/sqlite/log_sqlite.h"

namespace shoal {

namespace {

void AddSelection(CLI::App* command, LogSelection* selection) {
  command->add_option("--channel", selection->channels, "Only these channels; * and ? are wild")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--from", selection->from_s, "From this time on, seconds");
  command->add_option("--to", selection->to_s, "Up to this time, seconds");
}

void AddTypes(CLI::App* command, std::vector<std::string>* types) {
  command->add_option("--types", *types, "A .lcm file of message types that are not shoal's")
      ->take_all()
      ->allow_extra_args(false);
}

void AddLogEncounters(CLI::App* log, CommandAction* action) {
  CLI::App* command = log->add_subcommand(
      "encounters", "Show the encounters of vessels, and how well each kept to the rules");
  auto options = std::make_shared<LogEncountersOptions>();
  command->add_option("LOG", options->path, "LCM event log")->required();
  CLI::Option* csv = command->add_flag("--csv", options->csv, "Every number, as CSV");
  command->add_flag("--explain", options->explain, "Every number, in words")->excludes(csv);
  command->add_flag("--all", options->all, "Show all encounters, however many there are");
  command->add_flag("--skip-damage", options->skip_damage,
                    "Read what can be read of a damaged log");
  const auto distance = [command](const char* name, double* value_m, const char* what) {
    constexpr double kShortest_m = 0.1;
    constexpr double kLongest_m = 1e6;
    command->add_option(name, *value_m, fmt::format("{}; default: {:g} m", what, *value_m))
        ->check(CLI::Range(kShortest_m, kLongest_m));
  };
  EncounterOptions& encounter = options->encounter;
  distance("--entry-range", &encounter.entry_range_m, "Encounters begin nearer than this");
  distance("--risk", &encounter.risk_m, "Where holding on would take them nearer than this");
  distance("--end-range", &encounter.end_range_m, "They end farther apart than this");
  distance("--preferred", &encounter.preferred_m, "Passing at this distance is scored in full");
  distance("--acceptable", &encounter.acceptable_m, "Nearer than this is not safe");
  distance("--near-miss", &encounter.near_miss_m, "Nearer than this is a near miss");
  command->callback([options, action] {
    *action = [options] { return LogEncounters(*options, std::cout, std::cerr); };
  });
}

void AddLogMcap(CLI::App* log, CommandAction* action) {
  CLI::App* command =
      log->add_subcommand("mcap", "One MCAP file, for Foxglove, Rerun and PlotJuggler");
  auto options = std::make_shared<LogMcapOptions>();
  command->add_option("LOG", options->path, "LCM event log")->required();
  command->add_option("--out", options->out_path, "The file")->required();
  AddSelection(command, &options->selection);
  command->add_flag("--skip-damage", options->skip_damage, "Convert what can be read of a bad log");
  command->add_flag("--only-log", options->only_log,
                    "Leave out the poses, places and lines of text that are made of the log");
  AddTypes(command, &options->types);
  command->callback([options, action] {
    *action = [options] {
      if (!IsSelectionSound(options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogMcap(*options, std::cout, std::cerr);
    };
  });
}

void AddLogSqlite(CLI::App* log, CommandAction* action) {
  CLI::App* command =
      log->add_subcommand("sqlite", "One SQLite database: a table per channel, fates, mission");
  auto options = std::make_shared<LogSqliteOptions>();
  command->add_option("LOG", options->path, "LCM event log")->required();
  command->add_option("--out", options->out_path, "The file")->required();
  AddSelection(command, &options->selection);
  command->add_flag("--skip-damage", options->skip_damage, "Convert what can be read of a bad log");
  AddTypes(command, &options->types);
  command->callback([options, action] {
    *action = [options] {
      if (!IsSelectionSound(options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogSqlite(*options, std::cout, std::cerr);
    };
  });
}

}  // namespace

void AddLogCommands(CLI::App* log, CommandAction* action) {
  log->require_subcommand(1);

  CLI::App* info = log->add_subcommand("info", "Channels, types, counts, rates, time span");
  auto info_options = std::make_shared<LogInfoOptions>();
  info->add_option("LOG", info_options->path, "LCM event log")->required();
  AddTypes(info, &info_options->types);
  info->callback([info_options, action] {
    *action = [info_options] { return LogInfo(*info_options, std::cout, std::cerr); };
  });

  CLI::App* cat = log->add_subcommand("cat", "Messages as text, one line each");
  auto cat_options = std::make_shared<LogCatOptions>();
  cat->add_option("LOG", cat_options->path, "LCM event log")->required();
  AddSelection(cat, &cat_options->selection);
  cat->add_option("--limit", cat_options->limit, "Lines at most");
  cat->add_flag("--skip-damage", cat_options->skip_damage, "Print what can be read of a bad log");
  AddTypes(cat, &cat_options->types);
  cat->callback([cat_options, action] {
    *action = [cat_options] {
      if (!IsSelectionSound(cat_options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogCat(*cat_options, std::cout, std::cerr);
    };
  });

  CLI::App* diff = log->add_subcommand("diff", "First difference between two logs");
  auto diff_options = std::make_shared<LogDiffOptions>();
  diff->add_option("A", diff_options->path_a, "LCM event log")->required();
  diff->add_option("B", diff_options->path_b, "LCM event log")->required();
  diff->add_option("--without", diff_options->without, "Leave out these channels; * and ? are wild")
      ->take_all()
      ->allow_extra_args(false);
  AddTypes(diff, &diff_options->types);
  diff->callback([diff_options, action] {
    *action = [diff_options] { return LogDiff(*diff_options, std::cout, std::cerr); };
  });

  CLI::App* csv = log->add_subcommand("csv", "One CSV file per channel");
  auto csv_options = std::make_shared<LogCsvOptions>();
  csv->add_option("LOG", csv_options->path, "LCM event log")->required();
  csv->add_option("--out", csv_options->out_dir, "Folder for the files")->required();
  AddSelection(csv, &csv_options->selection);
  csv->add_flag("--skip-damage", csv_options->skip_damage, "Convert what can be read of a bad log");
  csv->add_flag_callback(
      "--moos", [csv_options] { csv_options->lines = NodeReportsAsAlog(); },
      "Also write node reports as MOOS text, for alog tools: <CHANNEL>.alog");
  AddTypes(csv, &csv_options->types);
  csv->callback([csv_options, action] {
    *action = [csv_options] {
      if (!IsSelectionSound(csv_options->selection, std::cerr)) return static_cast<int>(kExitUsage);
      return LogCsv(*csv_options, std::cout, std::cerr);
    };
  });

  CLI::App* comms = log->add_subcommand(
      "comms", "Show what was delivered and lost per link, why, and the age of information");
  auto comms_options = std::make_shared<LogCommsOptions>();
  comms->add_option("LOG", comms_options->path, "LCM event log")->required();
  comms->add_option("--csv", comms_options->csv_dir, "Also write tables into this folder");
  comms->add_flag("--all", comms_options->all, "Show all links, however many there are");
  comms->add_flag("--skip-damage", comms_options->skip_damage,
                  "Read what can be read of a bad log");
  comms->callback([comms_options, action] {
    *action = [comms_options] { return LogComms(*comms_options, std::cout, std::cerr); };
  });

  CLI::App* helm = log->add_subcommand("helm", "Show why a helm with behaviors steered as it did");
  auto helm_options = std::make_shared<LogHelmOptions>();
  helm->add_option("LOG", helm_options->path, "LCM event log")->required();
  helm->add_option("--vehicle", helm_options->vehicle, "Only this vehicle");
  helm->add_option("--at", helm_options->at_s, "In full: the decision at this time, seconds");
  helm->add_flag("--skip-damage", helm_options->skip_damage, "Read what can be read of a bad log");
  helm->callback([helm_options, action] {
    *action = [helm_options] { return LogHelm(*helm_options, std::cout, std::cerr); };
  });
  AddLogEncounters(log, action);
  AddLogMcap(log, action);
  AddLogSqlite(log, action);
}

}  // namespace shoal
