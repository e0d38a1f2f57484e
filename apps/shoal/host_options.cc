#include "apps/shoal/host_options.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "lib/base/check/result.h"
#include "lib/run/hosts/host_keys.h"
#include "lib/run/launch/host_agent.h"

namespace shoal {

namespace {

int RunKeygen(const std::string& prefix) {
  const HostKey key = MakeHostKey();
  if (const auto written = WriteHostKey(key, prefix); !written.ok()) {
    fmt::print(stderr, "shoal host keygen: {}\n", written.error());
    return kExitEnvironment;
  }
  fmt::print(
      "{0}.key holds this computer's secret key: it stays here, readable by you alone\n"
      "{0}.pub holds its public key, for the other computers: {1}\n",
      prefix, key.public_key);
  return kExitOk;
}

}  // namespace

void AddHostCommands(Command shoal, CommandAction* action) {
  const Command command = shoal.AddSubcommand(
      "host",
      "Run vehicles of missions that other computers start (docs/missions/many_machines.md)");
  auto options = std::make_shared<HostAgentOptions>();
  const Option listen =
      command
          .AddOption("--listen", &options->listen,
                     "Where to listen, tcp://ADDRESS:PORT; nothing listens without it")
          .Check([](const std::string& text) {
            return text.starts_with("tcp://") ? "" : "an address has the form tcp://ADDRESS:PORT";
          });
  command.AddOption("--key", &options->key_file,
                    "This computer's key; default: $SHOAL_KEY, or ~/.config/shoal/host.key");
  command
      .AddOption("--allow", &options->allow,
                 "Public key, or a file with it, of a computer that may run missions here")
      .Repeatable();
  command.AddFlag("--allow-programs", &options->allow_programs,
                  "Missions may bring participants with commands of their own");
  command.AddFlag("--once", &options->once, "End after one mission");
  command
      .AddOption("--port", &options->port_base,
                 "First UDP port, on loopback, of missions here; default: the first free block")
      .InRange(1024, 65535);

  const Command keygen = command.AddSubcommand("keygen", "Make this computer's key");
  auto prefix = std::make_shared<std::string>(DefaultKeyPrefix());
  keygen.AddOption("--out", prefix.get(), "Writes PREFIX.key and PREFIX.pub; default: " + *prefix)
      .OptionText("PREFIX");
  keygen.Callback([prefix, action] { *action = [prefix] { return RunKeygen(*prefix); }; });

  command.CheckedCallback([options, keygen, listen, action] {
    if (keygen.IsParsed()) return "";
    if (!listen.IsGiven() || options->allow.empty()) {
      return "shoal host: needs --listen tcp://ADDRESS:PORT and --allow KEY, so that nothing "
             "listens without being asked to, and no unknown computer gets in";
    }
    *action = [options] { return RunHostAgent(*options); };
    return "";
  });
}

}  // namespace shoal
