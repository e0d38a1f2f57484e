#include "apps/shoal_play/play_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <limits>
#include <memory>
#include <string>

#include "apps/shoal_play/play_command.h"
#include "lib/base/check/result.h"
#include "lib/run/command_line/tool_commands.h"
#include "lib/run/orders/order_words.h"
#include "lib/run/run/log_arguments.h"

namespace shoal {

void AddPlayOptions(Command command, CommandAction* action) {
  struct Parsed {
    PlayOptions options;
    std::string speed = "1";
  };
  auto parsed = std::make_shared<Parsed>();
  PlayOptions& options = parsed->options;
  constexpr int kFirstPort = 1024;
  constexpr int kLastPort = 65535;
  constexpr double kLongest_s = 1e12;
  command.Footer(fmt::format("Keys: {}", kPlayKeys));
  command.AddOption("LOG", &options.path, kLogArgument).Required();
  command
      .AddOption("--speed", &parsed->speed,
                 "Seconds of the log per second, or max: as fast as the receivers; default 1")
      .TakeLast()
      .Check([](const std::string& text) -> std::string {
        if (ParseWarp(text)) return "";
        return fmt::format("'{}' is neither a number from 1e-6 to 1e6 nor max", text);
      });
  command.AddOption("--from", &options.from_s, "Begin this many seconds behind the log's begin")
      .InRange(0.0, kLongest_s);
  const Option loop =
      command.AddFlag("--loop", &options.loop, "At the end, begin again, until it is ended");
  AddChannelChoice(command, &options.channels, "Play");
  command.AddFlag("--paused", &options.paused,
                  "Wait before the first step for `shoal send clock resume`, or space");
  const Option participant = command.AddOption(
      "--participant", &options.participants,
      "A participant of this name, which you start, takes part; playback waits for its answers");
  participant.Repeatable().Excludes(loop);
  command
      .AddOption("--answers", &options.answers_path,
                 "Write what participants and others publish into this log")
      .Excludes(loop);
  command.AddOption("--port", &options.port_base, "First port of the block to use")
      .InRange(kFirstPort, kLastPort);
  command.AddFlag("--quiet", &options.quiet, "No line of progress");
  command.Callback([parsed, action] {
    *action = [parsed] {
      parsed->options.warp = *ParseWarp(parsed->speed);
      return RunPlay(parsed->options);
    };
  });
}

int RunShoalPlay(int argc, char** argv) {
  return RunToolCommand("play", argc, argv, AddPlayOptions);
}

}  // namespace shoal
