#include "apps/shoal/shoal_options.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <iostream>
#include <system_error>

#include "apps/shoal/check_command.h"
#include "apps/shoal/doctor.h"
#include "apps/shoal/import_command.h"
#include "apps/shoal/launcher.h"
#include "apps/shoal/log_comms.h"
#include "apps/shoal/plot_command.h"
#include "apps/shoal/rebroker_command.h"
#include "apps/shoal/send_command.h"
#include "apps/shoal/send_words.h"
#include "apps/shoal/sim_command.h"
#include "apps/shoal/status_command.h"
#include "lib/mission/load.h"
#include "lib/record/log_commands.h"
#include "lib/run/version.h"

namespace shoal {

namespace {

/// What the chosen subcommand does; returns the exit code.
using Action = std::function<int()>;

CLI::Option* AddMission(CLI::App* command, std::string* file, std::vector<std::string>* overrides) {
  command
      ->add_option("--set", *overrides,
                   "Override a key of the mission file, e.g. comms.comms_range=100")
      ->take_all()
      ->allow_extra_args(false);
  return command->add_option("FILE", *file, "Mission file")->required();
}

CLI::Option* AddPort(CLI::App* command, int* port_base) {
  return command
      ->add_option("--port", *port_base, "First port of the mission, where several are running")
      ->check(CLI::Range(1024, 65535));
}

void AddRun(CLI::App& cli, Action* action) {
  CLI::App* command = cli.add_subcommand("run", "Run a mission: one process per participant");
  struct Parsed {
    RunOptions options;
    std::string warp = "1";
    std::string layout;
  };
  auto parsed = std::make_shared<Parsed>();
  RunOptions& options = parsed->options;
  AddMission(command, &options.mission_file, &options.overrides);
  command
      ->add_option("--warp", parsed->warp,
                   "Mission seconds per wall second, or max: as fast as the machine can")
      ->take_last()
      ->check([](const std::string& text) -> std::string {
        char* end = nullptr;
        const double warp = std::strtod(text.c_str(), &end);
        const bool ok = text == "max" || (!text.empty() && *end == '\0' && warp > 0 && warp <= 1e6);
        return ok ? "" : fmt::format("'{}' is neither a number in (0, 1e6] nor max", text);
      });
  command->add_option("--record", options.record_dir,
                      "Record into this folder: mission.lcm, the mission file, logs, summary");
  command->add_flag("--lcm-logger", options.lcm_logger,
                    "Run lcm-logger on each bus as well (wall times; it may lose bursts)");
  command
      ->add_option("--layout", parsed->layout,
                   "shared: one LCM port; communities: one per vehicle (default from 10 vehicles)")
      ->check(CLI::IsMember({"shared", "communities"}));
  AddPort(command, &options.port_base)->description("First port of the block to use");
  command->add_flag("--quiet", options.quiet, "No line of progress");
  command
      ->add_option("--lose", options.lose,
                   "Fault injection: every participant loses this share of its datagrams")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--lose-forever", options.lose_forever,
                      "Fault injection: every datagram of this channel is lost");
  command->callback([parsed, action] {
    *action = [parsed] {
      RunOptions& run = parsed->options;
      run.warp = parsed->warp == "max" ? 0 : std::stod(parsed->warp);
      if (!parsed->layout.empty()) {
        run.layout = parsed->layout == "shared" ? Layout::kShared : Layout::kCommunities;
      }
      if (run.lcm_logger && run.record_dir.empty()) {
        fmt::print(stderr, "shoal: --lcm-logger needs --record DIR, for a place to write to\n");
        return static_cast<int>(kExitUsage);
      }
      const LoadedMission loaded = LoadMission(run.mission_file, run.overrides);
      if (!LoadedWithoutErrors(loaded)) return static_cast<int>(kExitUsage);
      return RunMission(run, loaded.mission);
    };
  });
}

void AddSim(CLI::App& cli, Action* action) {
  CLI::App* command = cli.add_subcommand(
      "sim", "Run a mission in one process, as fast as it goes; the same result");
  auto options = std::make_shared<SimOptions>();
  AddMission(command, &options->mission_file, &options->overrides);
  command->add_option("--log", options->log_path, "Write a log of the mission");
  command->add_flag("--quiet", options->quiet, "Print PASS or FAIL and nothing else");
  command->callback([options, action] { *action = [options] { return RunSim(*options); }; });
}

void AddCheck(CLI::App& cli, Action* action) {
  CLI::App* command = cli.add_subcommand("check", "Say all that is wrong with a mission file");
  struct Parsed {
    std::string file;
    std::vector<std::string> overrides;
    bool explain = false;
  };
  auto parsed = std::make_shared<Parsed>();
  AddMission(command, &parsed->file, &parsed->overrides);
  command->add_flag("--explain", parsed->explain, "Print the mission with every default filled in");
  command->callback([parsed, action] {
    *action = [parsed] { return RunCheck(parsed->file, parsed->overrides, parsed->explain); };
  });
}

void AddSend(CLI::App& cli, Action* action) {
  CLI::App* command = cli.add_subcommand("send", "Tell a vehicle, or the broker, what to do");
  auto options = std::make_shared<SendOptions>();
  AddPort(command, &options->port_base);
  command->footer(SendCommandsText());
  command->add_option("TARGET", options->target, "A vehicle, all, or a rule")->required();
  command->add_option("WORDS", options->words, "What to do, and with what");
  // Negative numbers are values here, not options.
  command->prefix_command();
  command->callback([options, command, action] {
    for (const std::string& word : command->remaining()) options->words.push_back(word);
    *action = [options] { return RunSend(*options); };
  });
}

/// The same as `shoal send FROM message TO VAR VALUE`, in words that say who is who.
void AddMessage(CLI::App& cli, Action* action) {
  CLI::App* command =
      cli.add_subcommand("message", "Send a node message from one vehicle to others");
  struct Parsed {
    int port_base = 0;
    std::string from;
    std::string to;
    std::string var;
    std::string value;
    bool is_double = false;
    bool wants_ack = false;
  };
  auto parsed = std::make_shared<Parsed>();
  AddPort(command, &parsed->port_base);
  command->add_option("--from", parsed->from, "The vehicle that sends it, or all")->required();
  command->add_option("--to", parsed->to, "Vehicles joined by ':', all, or group:NAME")->required();
  command->add_option("VAR", parsed->var, "What is told; HELM_COMMAND: an order to the helm")
      ->required();
  command->add_option("VALUE", parsed->value, "Its value; of HELM_COMMAND: deploy, speed=1.2, ...")
      ->required();
  command->add_flag("--double", parsed->is_double, "VALUE is a number");
  command->add_flag("--ack", parsed->wants_ack, "Sent again until it is acknowledged");
  command->callback([parsed, action] {
    SendOptions options{.port_base = parsed->port_base,
                        .target = parsed->from,
                        .words = {"message", parsed->to, parsed->var, parsed->value}};
    if (parsed->is_double) options.words.emplace_back("--double");
    if (parsed->wants_ack) options.words.emplace_back("--ack");
    *action = [options] { return RunSend(options); };
  });
}

void AddStatus(CLI::App& cli, Action* action) {
  CLI::App* status = cli.add_subcommand("status", "Show the status pages of a running mission");
  auto options = std::make_shared<StatusOptions>();
  AddPort(status, &options->port_base);
  status->add_option("APP", options->app,
                     "A participant, such as helm_alpha; all; default: a line for each");
  status->callback([options, action] { *action = [options] { return RunStatus(*options); }; });

  CLI::App* url = cli.add_subcommand("url", "Print the LCM URL of a running mission");
  struct Parsed {
    int port_base = 0;
    std::string vehicle;
  };
  auto parsed = std::make_shared<Parsed>();
  AddPort(url, &parsed->port_base);
  url->add_option("VEHICLE", parsed->vehicle, "Of this vehicle's community; default: the shore");
  url->callback([parsed, action] {
    *action = [parsed] { return RunUrl(parsed->port_base, parsed->vehicle); };
  });
}

void AddSelection(CLI::App* command, LogSelection* selection) {
  command->add_option("--channel", selection->channels, "Only these channels; * and ? are wild")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--from", selection->from_s, "From this time on, seconds");
  command->add_option("--to", selection->to_s, "Up to this time, seconds");
}

/// Prints what is wrong with a selection. Returns true where nothing is.
bool IsSelectionSound(const LogSelection& selection) {
  if (!selection.from_s || !selection.to_s || *selection.from_s <= *selection.to_s) return true;
  fmt::print(stderr, "shoal: --from {} is after --to {}: nothing lies between\n", *selection.from_s,
             *selection.to_s);
  return false;
}

void AddTypes(CLI::App* command, std::vector<std::string>* types) {
  command->add_option("--types", *types, "A .lcm file of message types that are not shoal's")
      ->take_all()
      ->allow_extra_args(false);
}

void AddLog(CLI::App& cli, Action* action) {
  CLI::App* log = cli.add_subcommand("log", "Read logs");
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
      if (!IsSelectionSound(cat_options->selection)) return static_cast<int>(kExitUsage);
      return LogCat(*cat_options, std::cout, std::cerr);
    };
  });

  CLI::App* diff = log->add_subcommand("diff", "First difference between two logs");
  auto diff_options = std::make_shared<LogDiffOptions>();
  diff->add_option("A", diff_options->path_a, "LCM event log")->required();
  diff->add_option("B", diff_options->path_b, "LCM event log")->required();
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
      if (!IsSelectionSound(csv_options->selection)) return static_cast<int>(kExitUsage);
      return LogCsv(*csv_options, std::cout, std::cerr);
    };
  });

  CLI::App* comms =
      log->add_subcommand("comms", "Who heard whom, what was lost and why, how old news are");
  auto comms_options = std::make_shared<LogCommsOptions>();
  comms->add_option("LOG", comms_options->path, "LCM event log")->required();
  comms->add_option("--csv", comms_options->csv_dir, "Also write tables into this folder");
  comms->add_flag("--all", comms_options->all, "Show all links, however many there are");
  comms->add_flag("--skip-damage", comms_options->skip_damage,
                  "Read what can be read of a bad log");
  comms->callback([comms_options, action] {
    *action = [comms_options] { return LogComms(*comms_options, std::cout, std::cerr); };
  });
}

void AddImport(CLI::App& cli, Action* action) {
  CLI::App* command =
      cli.add_subcommand("import", "Make a mission of MOOS-IvP mission files (.moos)");
  auto options = std::make_shared<ImportOptions>();
  command->add_option("FILE", options->files, "All .moos files of one mission: shore and vehicles")
      ->required();
  command->add_option("--out", options->out_path,
                      "Mission file to write, one that is not there yet; default: standard output");
  command->callback([options, action] { *action = [options] { return RunImport(*options); }; });
}

void AddPlot(CLI::App& cli, Action* action) {
  CLI::App* command = cli.add_subcommand("plot", "Draw a log's tracks and curves (gnuplot)");
  auto options = std::make_shared<PlotOptions>();
  command->add_option("LOG", options->log, "LCM event log")->required();
  command->add_option("--out", options->out_dir,
                      "Folder for the figures; default: plots, beside LOG");
  CLI::Option* mission =
      command->add_option("--mission", options->mission_file,
                          "Mission file; default: mission.toml beside LOG, if there");
  command
      ->add_option("--set", options->overrides, "Override a key of the mission file, as in the run")
      ->take_all()
      ->allow_extra_args(false)
      ->needs(mission);
  command->add_option("--vehicle", options->vehicles, "Only these vehicles")->take_all();
  command->add_option("--from", options->from_s, "From this time on, seconds");
  command->add_option("--to", options->to_s, "Up to this time, seconds");
  command->add_flag("--png", options->png, "PNG instead of SVG");
  command->add_flag("--keep", options->keep, "Leave data and gnuplot scripts in OUT/gnuplot");
  command->callback([options, action] {
    *action = [options] {
      const LogSelection selection{.from_s = options->from_s, .to_s = options->to_s};
      if (!IsSelectionSound(selection)) return static_cast<int>(kExitUsage);
      const char* path = std::getenv("PATH");
      options->search_path = path == nullptr ? "" : path;
      return RunPlot(*options, std::cout, std::cerr);
    };
  });
}

void AddRebroker(CLI::App& cli, Action* action) {
  CLI::App* command =
      cli.add_subcommand("rebroker", "Who would have heard whom: a log's reports, other rules");
  auto options = std::make_shared<RebrokerOptions>();
  command->add_option("LOG", options->logs, "LCM event log; several: of loggers of one mission")
      ->required();
  command->add_option("--comms", options->comms_file,
                      "Rules: a mission file, or one with [comms] alone; default: the recorded");
  command->add_option("--log", options->out_path, "Write what was heard instead as an LCM log");
  command->add_flag("--no-controls", options->no_controls, "Leave out what was said on UNC_*");
  command->add_flag("--all", options->all_links, "Show all links, however many there are");
  command->add_flag("--skip-damage", options->skip_damage, "Read what can be read of a bad log");
  command->callback([options, action] {
    *action = [options] { return RunRebroker(*options, std::cout, std::cerr); };
  });
}

/// True where standard output is a pipe that nobody reads any more, as behind `| head`. (Where
/// SIGPIPE is not ignored, it has ended the process before anybody asks.)
bool ReaderHasLeft() {
  pollfd output{.fd = STDOUT_FILENO, .events = POLLOUT, .revents = 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

}  // namespace

int RunShoalCommand(int argc, char** argv) {
  CLI::App cli("shoal runs missions of several vehicles over a sea that loses what they say.",
               "shoal");
  cli.set_version_flag("--version", std::string("shoal ") + kVersion);
  cli.require_subcommand(1);
  Action action;
  AddRun(cli, &action);
  AddSim(cli, &action);
  AddCheck(cli, &action);
  AddMessage(cli, &action);
  AddSend(cli, &action);
  AddStatus(cli, &action);
  AddLog(cli, &action);
  AddImport(cli, &action);
  AddPlot(cli, &action);
  AddRebroker(cli, &action);
  cli.add_subcommand("doctor", "Say what keeps missions from running on this machine")
      ->callback([&action] { action = [] { return RunDoctor(); }; });
  cli.add_subcommand("channels", "Print the table of all channels (docs/channels.md)")
      ->callback([&action] {
        action = [] {
          fmt::print("{}", ChannelsMarkdown());
          return static_cast<int>(kExitOk);
        };
      });
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return cli.exit(error) == 0 ? kExitOk : kExitUsage;
  }
  // What was printed may not have reached its place: fmt throws, the streams only remember.
  bool written = true;
  int code = kExitEnvironment;
  try {
    code = action();
  } catch (const std::system_error& error) {
    written = false;
    if (std::ferror(stdout) == 0) {
      std::fputs((std::string("shoal: ") + error.what() + "\n").c_str(), stderr);
      return kExitEnvironment;
    }
  }
  std::cout.flush();
  written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good() && written;
  if (written || ReaderHasLeft()) return code;
  std::fputs("shoal: cannot write to standard output: is the disk full?\n", stderr);
  return kExitEnvironment;
}

}  // namespace shoal
