#include "apps/shoal/shoal_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/shoal/check_command.h"
#include "apps/shoal/doctor.h"
#include "apps/shoal/group_options.h"
#include "apps/shoal/host_doctor.h"
#include "apps/shoal/host_options.h"
#include "apps/shoal/send_command.h"
#include "apps/shoal/status_command.h"
#include "lib/mission/file/drawn_seed.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/command_line/command_line.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/launch/launcher.h"
#include "lib/run/launch/run_viewer.h"
#include "lib/run/orders/order_words.h"
#include "sim/app_factory.h"
#include "sim/run_sim.h"

namespace shoal {

namespace {

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
      ->add_option("--port", *port_base,
                   "First port of the mission; default: the one started in this folder")
      ->check(CLI::Range(1024, 65535));
}

constexpr char kQuiet[] = "No line of progress";

constexpr char kAllowCommands[] =
    "The page may command vehicles, broker and clock, with the token in its address";

/// Where the viewer listens. `needed`: an option that these require, or nullptr.
void AddAddress(CLI::App* command, const std::string& http, const std::string& listen,
                ViewOptions* view, CLI::Option* needed) {
  constexpr int kLastPort = 65535;
  CLI::Option* port =
      command->add_option(http, view->http_port,
                          "TCP port of the page; 0: any; default: the first free one from 8765 on");
  port->check(CLI::Range(0, kLastPort));
  CLI::Option* address = command->add_option(
      listen, view->listen, "Address to listen at; default: 127.0.0.1, this machine only");
  if (needed == nullptr) return;
  port->needs(needed);
  address->needs(needed);
}

void AddView(CLI::App& cli, CommandAction* action) {
  CLI::App* command =
      cli.add_subcommand("view", "Show a recorded mission, or the one that runs, in a browser");
  auto options = std::make_shared<ViewOptions>();
  CLI::Option* log = command->add_option(
      "LOG", options->log, "A log, or the folder of a recording; default: the mission that runs");
  log->check([](const std::string& text) {
    return text.empty() ? "it is empty: name a log, or the folder of a recording" : "";
  });
  command
      ->add_option("--mission", options->mission_file,
                   "The log's mission file; default: the one beside it")
      ->needs(log);
  AddPort(command, &options->port_base)->excludes(log);
  command->add_flag("--allow-commands", options->allow_commands, kAllowCommands)->excludes(log);
  AddAddress(command, "--http", "--listen", options.get(), nullptr);
  command->callback([options, action] { *action = [options] { return RunView(*options); }; });
}

/// Returns the override that "lab2=alpha,bravo" stands for; nothing for other forms.
std::optional<std::string> PlacementOverride(const std::string& text) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || text.find('"') != std::string::npos) {
    return std::nullopt;
  }
  std::string list;
  for (size_t begin = equals + 1; begin < text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", text.substr(begin, end - begin));
    begin = end + 1;
  }
  return fmt::format("host.\"{}\".vehicles=[{}]", text.substr(0, equals), list);
}

void AddRun(CLI::App& cli, CommandAction* action) {
  CLI::App* command = cli.add_subcommand("run", "Run a mission: one process per participant");
  struct Parsed {
    RunOptions options;
    std::string warp = "1";
    std::string layout;
    std::string grouping = "app";
    std::vector<std::string> on;
    bool view = false;
    ViewOptions view_options;
  };
  auto parsed = std::make_shared<Parsed>();
  RunOptions& options = parsed->options;
  AddMission(command, &options.mission_file, &options.overrides);
  command
      ->add_option("--warp", parsed->warp,
                   "Mission seconds per wall second, or max: as fast as the machine can")
      ->take_last()
      ->check([](const std::string& text) -> std::string {
        if (ParseWarp(text)) return "";
        return fmt::format("'{}' is neither a number from 1e-6 to 1e6 nor max", text);
      });
  command->add_option("--record", options.record_dir,
                      "Record into this folder: mission.lcm, the mission file, logs, summary");
  command->add_flag("--lcm-logger", options.lcm_logger,
                    "Run lcm-logger on each bus as well (wall times; it may lose bursts)");
  command
      ->add_option("--layout", parsed->layout,
                   "shared: one LCM port; communities: one per vehicle (default from 10 vehicles)")
      ->check(CLI::IsMember({"shared", "communities"}));
  AddGrouping(command, &parsed->grouping);
  AddPort(command, &options.port_base)->description("First port of the block to use");
  command->add_flag("--quiet", options.quiet, kQuiet);
  ViewOptions& view = parsed->view_options;
  CLI::Option* wants_view = command->add_flag(
      "--view", parsed->view, "Run shoal-viewer beside it: the mission in a browser");
  command->add_flag("--allow-commands", view.allow_commands, kAllowCommands)->needs(wants_view);
  AddAddress(command, "--view-http", "--view-listen", &view, wants_view);
  command
      ->add_option("--lose", options.lose,
                   "Fault injection: every participant loses this share of its datagrams")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--lose-forever", options.lose_forever,
                      "Fault injection: every datagram of this channel is lost");
  command->add_option("--key", options.key_file,
                      "This computer's key for hosts; default: $SHOAL_KEY, or "
                      "~/.config/shoal/host.key");
  command
      ->add_option("--on", parsed->on,
                   "Vehicles for a [[host]] of the mission: NAME=alpha,bravo (NAME= for none)")
      ->take_all()
      ->allow_extra_args(false)
      ->check([](const std::string& text) {
        return PlacementOverride(text) ? "" : "it has the form NAME=alpha,bravo";
      });
  command->callback([parsed, action] {
    *action = [parsed] {
      RunOptions& run = parsed->options;
      for (const std::string& each : parsed->on) run.overrides.push_back(*PlacementOverride(each));
      run.warp = *ParseWarp(parsed->warp);
      run.grouping = *ParseGrouping(parsed->grouping);
      if (parsed->view) run.view = parsed->view_options;
      if (!parsed->layout.empty()) {
        run.layout = parsed->layout == "shared" ? Layout::kShared : Layout::kCommunities;
      }
      if (run.lcm_logger && run.record_dir.empty()) {
        fmt::print(stderr, "shoal: --lcm-logger needs --record DIR, for a place to write to\n");
        return static_cast<int>(kExitUsage);
      }
      const LoadedMission loaded = LoadMissionToRun(run.mission_file, DrawSeed, &run.overrides);
      if (!LoadedWithoutErrors(loaded)) return static_cast<int>(kExitUsage);
      return RunMission(run, loaded.mission, AppsToLaunch());
    };
  });
}

void AddSim(CLI::App& cli, CommandAction* action) {
  CLI::App* command = cli.add_subcommand(
      "sim", "Run a mission in one process, as fast as possible; the same result");
  auto options = std::make_shared<SimOptions>();
  AddMission(command, &options->mission_file, &options->overrides);
  command->add_option("--log", options->log_path,
                      "Write a log of the mission, in place of a file of this name");
  command->add_flag("--quiet", options->quiet, kQuiet);
  command->callback([options, action] { *action = [options] { return RunSim(*options); }; });
}

void AddCheck(CLI::App& cli, CommandAction* action) {
  CLI::App* command = cli.add_subcommand("check", "Show all that is wrong with a mission file");
  struct Parsed {
    std::string file;
    std::vector<std::string> overrides;
    bool explain = false;
    bool keys = false;
  };
  auto parsed = std::make_shared<Parsed>();
  AddMission(command, &parsed->file, &parsed->overrides);
  CLI::Option* explain = command->add_flag("--explain", parsed->explain,
                                           "Print the mission with every default filled in");
  command->add_flag("--keys", parsed->keys, "Print the keys that --set can change, one per line")
      ->excludes(explain);
  command->callback([parsed, action] {
    *action = [parsed] {
      if (parsed->keys) return RunKeys(parsed->file, parsed->overrides);
      return RunCheck(parsed->file, parsed->overrides, parsed->explain);
    };
  });
}

void AddSend(CLI::App& cli, CommandAction* action) {
  CLI::App* command =
      cli.add_subcommand("send", "Send a command to a vehicle, the broker or the clock");
  auto options = std::make_shared<SendOptions>();
  AddPort(command, &options->port_base);
  command->footer(SendCommandsText());
  command->add_option("TARGET", options->target, "A vehicle, group:NAME, all, clock, or a rule")
      ->required();
  command->add_option("WORDS", options->words, "Command and arguments, or vehicle and value");
  // Negative numbers are values here, not options.
  command->prefix_command();
  command->callback([options, command, action] {
    for (const std::string& word : command->remaining()) options->words.push_back(word);
    *action = [options] { return RunSend(*options); };
  });
}

/// The same as `shoal send FROM message TO VAR VALUE`, with options that name each part.
void AddMessage(CLI::App& cli, CommandAction* action) {
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
  command->add_option("VAR", parsed->var, "The variable; HELM_COMMAND: an order to the helm")
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

void AddStatus(CLI::App& cli, CommandAction* action) {
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

void AddDoctor(CLI::App& cli, CommandAction* action) {
  CLI::App* command =
      cli.add_subcommand("doctor", "Show what keeps missions from running on this machine");
  auto options = std::make_shared<HostDoctorOptions>();
  HostDoctorOptions& host = *options;
  CLI::Option* address = command->add_option(
      "--host", host.address, "Measure the way to a `shoal host` at tcp://ADDRESS:PORT instead");
  command->add_option("--host-key", host.public_key, "Its public key, or a file with it")
      ->needs(address);
  command
      ->add_option("--key", host.key_file,
                   "This computer's key; default: $SHOAL_KEY, or ~/.config/shoal/host.key")
      ->needs(address);
  command->add_option("--tick", host.tick_s, "Seconds of a mission's step, for the warp")
      ->check(CLI::Range(0.001, 10.0))
      ->needs(address);
  command->callback([options, action] {
    *action = [options] {
      return options->address.empty() ? RunDoctor() : RunHostDoctor(*options);
    };
  });
}

}  // namespace

int RunShoalCommand(int argc, char** argv) {
  if (const auto code = StartToolCommand(argc, argv)) return *code;
  const std::shared_ptr<CLI::App> shoal = MakeShoalCommand();
  CLI::App& cli = *shoal;
  CommandAction action;
  AddRun(cli, &action);
  AddGroup(cli, &action);
  AddSim(cli, &action);
  AddCheck(cli, &action);
  AddMessage(cli, &action);
  AddSend(cli, &action);
  AddStatus(cli, &action);
  AddView(cli, &action);
  AddHostCommands(cli, &action);
  for (const char* name : {"log", "import", "plot", "rebroker", "encounters", "campaign"}) {
    ListToolCommand(cli, name);
  }
  AddDoctor(cli, &action);
  cli.add_subcommand("channels", "Print the table of all channels (docs/channels.md)")
      ->callback([&action] {
        action = [] {
          fmt::print("{}", ChannelsMarkdown());
          return static_cast<int>(kExitOk);
        };
      });
  return RunCommandLine(cli, &action, {argv, argv + argc});
}

}  // namespace shoal
