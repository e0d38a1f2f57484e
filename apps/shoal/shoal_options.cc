#include "apps/shoal/shoal_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/shoal/check_command.h"
#include "apps/shoal/docs_command.h"
#include "apps/shoal/doctor.h"
#include "apps/shoal/group_options.h"
#include "apps/shoal/host_doctor.h"
#include "apps/shoal/host_options.h"
#include "apps/shoal/send_command.h"
#include "apps/shoal/spy_command.h"
#include "apps/shoal/status_command.h"
#include "lib/base/check/result.h"
#include "lib/mission/file/drawn_seed.h"
#include "lib/mission/file/print_errors.h"
#include "lib/run/command_line/command.h"
#include "lib/run/command_line/command_line.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/launch/launcher.h"
#include "lib/run/launch/run_viewer.h"
#include "lib/run/orders/order_words.h"
#include "lib/run/run/app_options.h"
#include "lib/run/run/log_arguments.h"
#include "lib/run/run/log_plan.h"
#include "sim/app_factory.h"
#include "sim/run_sim.h"

namespace shoal {

namespace {

Option AddMission(Command command, std::string* file, std::vector<std::string>* overrides) {
  command
      .AddOption("--set", overrides,
                 "Override a key of the mission file, e.g. comms.comms_range=100")
      .Repeatable();
  return command.AddOption("FILE", file, "Mission file").Required();
}

Option AddPort(Command command, int* port_base) {
  return command
      .AddOption("--port", port_base,
                 "First port of the mission; default: the one started in this folder")
      .InRange(1024, 65535);
}

constexpr char kQuiet[] = "No line of progress";

constexpr char kAllowTiles[] =
    "Let the page load tiles of a map from this address, https://HOST/{z}/{x}/{y}.png";
constexpr char kAllowCommands[] =
    "The page may command vehicles, broker and clock, with the token in its address";

constexpr char kExport[] =
    "Write the recorded mission as one file of HTML, to be opened without a viewer, and end";
constexpr char kExportEmpty[] = "it is empty: name the page to write, such as berta.html";
constexpr char kExportStep[] =
    "Seconds between the page's frames, 0.05 to 600; default: at most 2000 frames";

/// Where the viewer listens. `needed`: an option that these require.
void AddAddress(Command command, const std::string& http, const std::string& listen,
                ViewOptions* view, std::optional<Option> needed) {
  constexpr int kLastPort = 65535;
  const Option port =
      command
          .AddOption(http, &view->http_port,
                     "TCP port of the page; 0: any; default: the first free one from 8765 on")
          .InRange(0, kLastPort);
  const Option address = command.AddOption(
      listen, &view->listen, "Address to listen at; default: 127.0.0.1, this machine only");
  if (!needed) return;
  port.Needs(*needed);
  address.Needs(*needed);
}

void AddView(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("view", "Show a recorded mission, or the one that runs, in a browser");
  auto options = std::make_shared<ViewOptions>();
  auto example = std::make_shared<bool>(false);
  const Option log = command.AddOption("LOG", &options->log,
                                       "A log, the folder of a recording, or a mission file "
                                       "(.toml) to plan; default: the mission that "
                                       "runs");
  log.Check([](const std::string& text) {
    return text.empty() ? "it is empty: name a log, or the folder of a recording" : "";
  });
  const Option wants_example = command.AddFlag("--example", example.get(),
                                               "Show the recorded mission that comes with shoal");
  wants_example.Excludes(log);
  command
      .AddOption("--mission", &options->mission_file,
                 "The log's mission file; default: the one beside it")
      .Needs(log);
  AddPort(command, &options->port_base).Excludes(log).Excludes(wants_example);
  command.AddFlag("--allow-commands", &options->allow_commands, kAllowCommands)
      .Excludes(wants_example);
  command.AddOption("--allow-tiles", &options->outside_tiles, kAllowTiles);
  AddAddress(command, "--http", "--listen", options.get(), std::nullopt);
  const Option page = command.AddOption("--export", &options->export_path, kExport);
  page.Needs(log).Check([](const std::string& text) { return text.empty() ? kExportEmpty : ""; });
  command.AddOption("--export-step", &options->export_step, kExportStep).Needs(page);
  command.Callback([options, example, action] {
    *action = [options, example] {
      return *example ? RunViewOfExample(*options) : RunView(*options);
    };
  });
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

void AddRun(Command shoal, CommandAction* action) {
  const Command command = shoal.AddSubcommand("run", "Run a mission: one process per participant");
  struct Parsed {
    RunOptions options;
    std::string warp = "1";
    std::string layout;
    std::string grouping = "app";
    std::vector<std::string> on;
    bool compress = false;
    bool plain = false;
    bool view = false;
    ViewOptions view_options;
  };
  auto parsed = std::make_shared<Parsed>();
  RunOptions& options = parsed->options;
  AddMission(command, &options.mission_file, &options.overrides);
  command
      .AddOption("--warp", &parsed->warp,
                 "Mission seconds per wall second, or max: as fast as the machine can")
      .TakeLast()
      .Check([](const std::string& text) -> std::string {
        if (ParseWarp(text)) return "";
        return fmt::format("'{}' is neither a number from 1e-6 to 1e6 nor max", text);
      });
  const Option record =
      command.AddOption("--record", &options.record_dir,
                        "Record into this folder: mission.lcm, the mission file, logs, summary");
  const Option compress =
      command.AddFlag("--compress", &parsed->compress, "Compress the log by zstd: mission.lcm.zst");
  compress.Needs(record);
  command
      .AddFlag("--plain", &parsed->plain,
               fmt::format("The log is mission.lcm; default: compressed where {} are expected",
                           BytesText(kPlainLog_bytes)))
      .Needs(record)
      .Excludes(compress);
  AddChannelChoice(command, &options.log_channels);
  command.AddFlag("--lcm-logger", &options.lcm_logger,
                  "Run lcm-logger on each bus as well (wall times; it may lose bursts)");
  command
      .AddOption("--layout", &parsed->layout,
                 "shared: one LCM port; communities: one per vehicle (default from 10 vehicles)")
      .OneOf({"shared", "communities"});
  AddGrouping(command, &parsed->grouping);
  AddPort(command, &options.port_base).Description("First port of the block to use");
  command.AddFlag("--quiet", &options.quiet, kQuiet);
  ViewOptions& view = parsed->view_options;
  const Option wants_view = command.AddFlag("--view", &parsed->view,
                                            "Run shoal-viewer beside it: the mission in a browser");
  command.AddFlag("--allow-commands", &view.allow_commands, kAllowCommands).Needs(wants_view);
  command.AddOption("--allow-tiles", &view.outside_tiles, kAllowTiles).Needs(wants_view);
  AddAddress(command, "--view-http", "--view-listen", &view, wants_view);
  command
      .AddOption("--lose", &options.lose,
                 "Fault injection: every participant loses this share of its datagrams")
      .InRange(0.0, 1.0);
  command.AddOption("--lose-forever", &options.lose_forever,
                    "Fault injection: every datagram of this channel is lost");
  command.AddOption("--key", &options.key_file,
                    "This computer's key for hosts; default: $SHOAL_KEY, or "
                    "~/.config/shoal/host.key");
  command
      .AddOption("--on", &parsed->on,
                 "Vehicles for a [[host]] of the mission: NAME=alpha,bravo (NAME= for none)")
      .Repeatable()
      .Check([](const std::string& text) {
        return PlacementOverride(text) ? "" : "it has the form NAME=alpha,bravo";
      });
  command.Callback([parsed, action] {
    *action = [parsed] {
      RunOptions& run = parsed->options;
      for (const std::string& each : parsed->on) run.overrides.push_back(*PlacementOverride(each));
      run.warp = *ParseWarp(parsed->warp);
      run.grouping = *ParseGrouping(parsed->grouping);
      if (parsed->view) run.view = parsed->view_options;
      if (parsed->compress || parsed->plain) run.compress = parsed->compress;
      if (!parsed->layout.empty()) {
        run.layout = parsed->layout == "shared" ? Layout::kShared : Layout::kCommunities;
      }
      if (!run.log_channels.TakesAll() && run.record_dir.empty()) {
        fmt::print(stderr,
                   "shoal: --channels and --without need --record DIR: they are of its log\n");
        return static_cast<int>(kExitUsage);
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

void AddSim(Command shoal, CommandAction* action) {
  const Command command = shoal.AddSubcommand(
      "sim", "Run a mission in one process, as fast as possible; the same result");
  auto options = std::make_shared<SimOptions>();
  AddMission(command, &options->mission_file, &options->overrides);
  command.AddOption("--log", &options->log_path,
                    "Write a log of the mission, in place of a file of this name; FILE.lcm.zst: "
                    "compressed");
  AddChannelChoice(command, &options->log_channels);
  command.AddFlag("--quiet", &options->quiet, kQuiet);
  command.Callback([options, action] {
    *action = [options] {
      if (!options->log_channels.TakesAll() && options->log_path.empty()) {
        fmt::print(stderr,
                   "shoal: --channels and --without need --log FILE: they are of that log\n");
        return static_cast<int>(kExitUsage);
      }
      return RunSim(*options);
    };
  });
}

void AddCheck(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("check", "Show all that is wrong with a mission file");
  struct Parsed {
    std::string file;
    std::vector<std::string> overrides;
    bool explain = false;
    bool keys = false;
  };
  auto parsed = std::make_shared<Parsed>();
  AddMission(command, &parsed->file, &parsed->overrides);
  const Option explain = command.AddFlag("--explain", &parsed->explain,
                                         "Print the mission with every default filled in");
  command.AddFlag("--keys", &parsed->keys, "Print the keys that --set can change, one per line")
      .Excludes(explain);
  command.Callback([parsed, action] {
    *action = [parsed] {
      if (parsed->keys) return RunKeys(parsed->file, parsed->overrides);
      return RunCheck(parsed->file, parsed->overrides, parsed->explain);
    };
  });
}

void AddSend(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("send", "Send a command to a vehicle, the broker or the clock");
  auto options = std::make_shared<SendOptions>();
  AddPort(command, &options->port_base);
  command.Footer(SendCommandsText());
  command
      .AddOption("TARGET", &options->target,
                 "A vehicle, group:NAME, all, clock, a rule, or an [[order]] of the mission")
      .Required();
  command.AddOption("WORDS", &options->words, "Command and arguments, or vehicle and value");
  // Negative numbers are values here, not options.
  command.PrefixCommand();
  command.Callback([options, command, action] {
    for (const std::string& word : command.Remaining()) options->words.push_back(word);
    *action = [options] { return RunSend(*options); };
  });
}

/// The same as `shoal send FROM message TO VAR VALUE`, with options that name each part.
void AddMessage(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("message", "Send a node message from one vehicle to others");
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
  command.AddOption("--from", &parsed->from, "The vehicle that sends it, or all").Required();
  command.AddOption("--to", &parsed->to, "Vehicles joined by ':', all, or group:NAME").Required();
  command.AddOption("VAR", &parsed->var, "The variable; HELM_COMMAND: an order to the helm")
      .Required();
  command.AddOption("VALUE", &parsed->value, "Its value; of HELM_COMMAND: deploy, speed=1.2, ...")
      .Required();
  command.AddFlag("--double", &parsed->is_double, "VALUE is a number");
  command.AddFlag("--ack", &parsed->wants_ack, "Sent again until it is acknowledged");
  command.Callback([parsed, action] {
    SendOptions options{.port_base = parsed->port_base,
                        .target = parsed->from,
                        .words = {"message", parsed->to, parsed->var, parsed->value}};
    if (parsed->is_double) options.words.emplace_back("--double");
    if (parsed->wants_ack) options.words.emplace_back("--ack");
    *action = [options] { return RunSend(options); };
  });
}

void AddStatus(Command shoal, CommandAction* action) {
  const Command status =
      shoal.AddSubcommand("status", "Show the status pages of a running mission");
  auto options = std::make_shared<StatusOptions>();
  AddPort(status, &options->port_base);
  status.AddOption("APP", &options->app,
                   "A participant, such as helm_alpha; all; default: a line for each");
  status.Callback([options, action] { *action = [options] { return RunStatus(*options); }; });

  const Command url = shoal.AddSubcommand("url", "Print the LCM URL of a running mission");
  struct Parsed {
    int port_base = 0;
    std::string vehicle;
  };
  auto parsed = std::make_shared<Parsed>();
  AddPort(url, &parsed->port_base);
  url.AddOption("VEHICLE", &parsed->vehicle, "Of this vehicle's community; default: the shore");
  url.Callback([parsed, action] {
    *action = [parsed] { return RunUrl(parsed->port_base, parsed->vehicle); };
  });
}

void AddSpy(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("spy", "Start lcm-spy on a running mission, with shoal's message types");
  auto options = std::make_shared<SpyOptions>();
  const Option port = AddPort(command, &options->port_base);
  const Option vehicle = command.AddOption("VEHICLE", &options->vehicle,
                                           "Of this vehicle's community; default: the shore");
  command
      .AddOption("--url", &options->url,
                 "Any LCM bus instead, e.g. 'udpm://239.255.76.67:7667?ttl=0'")
      .Excludes(port)
      .Excludes(vehicle);
  command.AddOption("--types", &options->types, "A jar of message types that are not shoal's")
      .Repeatable();
  command.Callback([options, action] { *action = [options] { return RunSpy(*options); }; });
}

void AddDoctor(Command shoal, CommandAction* action) {
  const Command command =
      shoal.AddSubcommand("doctor", "Show what keeps missions from running on this machine");
  auto options = std::make_shared<HostDoctorOptions>();
  HostDoctorOptions& host = *options;
  const Option address = command.AddOption(
      "--host", &host.address, "Measure the way to a `shoal host` at tcp://ADDRESS:PORT instead");
  command.AddOption("--host-key", &host.public_key, "Its public key, or a file with it")
      .Needs(address);
  command
      .AddOption("--key", &host.key_file,
                 "This computer's key; default: $SHOAL_KEY, or ~/.config/shoal/host.key")
      .Needs(address);
  command.AddOption("--tick", &host.tick_s, "Seconds of a mission's step, for the warp")
      .InRange(0.001, 10.0)
      .Needs(address);
  command.Callback([options, action] {
    *action = [options] {
      return options->address.empty() ? RunDoctor() : RunHostDoctor(*options);
    };
  });
}

void AddDocs(Command shoal, CommandAction* action) {
  const Command command = shoal.AddSubcommand(
      "docs", "Print what the pages state about a key of a mission file, or a word");
  auto options = std::make_shared<DocsOptions>();
  command.AddOption(
      "WORDS", &options->words,
      "A key (comms_range), a table ([[event]]) or words; default: the list of pages");
  command.AddFlag("--open", &options->open, "Open the page in a browser instead");
  command.Callback([options, action] { *action = [options] { return RunDocs(*options); }; });
}

}  // namespace

int RunShoalCommand(int argc, char** argv) {
  if (const auto code = StartToolCommand(argc, argv)) return *code;
  Program shoal = MakeShoalCommand();
  CommandAction action;
  AddRun(shoal, &action);
  AddGroup(shoal, &action);
  AddSim(shoal, &action);
  AddCheck(shoal, &action);
  AddMessage(shoal, &action);
  AddSend(shoal, &action);
  AddStatus(shoal, &action);
  AddSpy(shoal, &action);
  AddView(shoal, &action);
  AddHostCommands(shoal, &action);
  ListToolCommands(shoal, "");
  AddDoctor(shoal, &action);
  AddDocs(shoal, &action);
  shoal.AddSubcommand("channels", "Print the table of all channels (docs/reference/channels.md)")
      .Callback([&action] {
        action = [] {
          fmt::print("{}", ChannelsMarkdown());
          return static_cast<int>(kExitOk);
        };
      });
  return RunCommandLine(shoal, &action, {argv, argv + argc});
}

}  // namespace shoal
