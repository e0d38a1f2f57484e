#include "apps/shoal/host_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

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

void AddHostCommands(CLI::App& cli, std::function<int()>* action) {
  CLI::App* command = cli.add_subcommand(
      "host", "Run vehicles of missions that other computers start (docs/many_machines.md)");
  auto options = std::make_shared<HostAgentOptions>();
  CLI::Option* listen =
      command
          ->add_option("--listen", options->listen,
                       "Where to listen, tcp://ADDRESS:PORT; nothing listens without it")
          ->check([](const std::string& text) {
            return text.starts_with("tcp://") ? "" : "an address has the form tcp://ADDRESS:PORT";
          });
  command->add_option("--key", options->key_file,
                      "This computer's key; default: $SHOAL_KEY, or ~/.config/shoal/host.key");
  command
      ->add_option("--allow", options->allow,
                   "Public key, or a file with it, of a computer that may run missions here")
      ->allow_extra_args(false)
      ->take_all();
  command->add_flag("--allow-programs", options->allow_programs,
                    "Missions may bring participants with commands of their own");
  command->add_flag("--once", options->once, "End after one mission");
  command
      ->add_option("--port", options->port_base,
                   "First UDP port, on loopback, of missions here; default: the first free block")
      ->check(CLI::Range(1024, 65535));

  CLI::App* keygen = command->add_subcommand("keygen", "Make this computer's key");
  auto prefix = std::make_shared<std::string>(DefaultKeyPrefix());
  keygen->add_option("--out", *prefix, "Writes PREFIX.key and PREFIX.pub; default: " + *prefix)
      ->option_text("PREFIX");
  keygen->callback([prefix, action] { *action = [prefix] { return RunKeygen(*prefix); }; });

  command->callback([options, keygen, listen, action] {
    if (keygen->parsed()) return;
    if (listen->count() == 0 || options->allow.empty()) {
      throw CLI::ValidationError(
          "shoal host",
          "needs --listen tcp://ADDRESS:PORT and --allow KEY, so that nothing listens "
          "without being asked to, and no unknown computer gets in");
    }
    *action = [options] { return RunHostAgent(*options); };
  });
}

}  // namespace shoal
