#include "apps/shoal_mpi/mpi_options.h"

#include <CLI/CLI.hpp>
#include <cstdlib>

#include "lib/base/check/result.h"
#include "lib/run/command_line/version_text.h"

namespace shoal {

namespace {

constexpr char kFooter[] =
    "Started by mpirun -n N shoal-mpi FILE, or by srun -n N --mpi=pmix shoal-mpi FILE. Log, "
    "verdict "
    "and\nsummary are those of `shoal sim FILE`, for any number of ranks: docs/many_machines.md\n"
    "Exit codes: 0 pass, 1 fail, 2 command line or mission file, 3 the machine: a rank is lost.";

void AddOptions(CLI::App& cli, MpiOptions* options) {
  cli.set_version_flag("--version", VersionText("shoal-mpi"));
  cli.footer(kFooter);
  cli.add_option("FILE", options->mission_file, "Mission file, the same on every host")->required();
  cli.add_option("--set", options->overrides,
                 "Override a key of the mission file, e.g. comms.comms_range=100")
      ->take_all()
      ->allow_extra_args(false);
  cli.add_option("--log", options->log_path,
                 "Rank 0 writes a log of the mission, in place of a file of this name");
  cli.add_option("--place", options->placed,
                 "Vehicles that go to a rank, e.g. 0=alpha,bravo or 1=group:north, or "
                 "1=shore_broker; the others are "
                 "shared out by cost")
      ->take_all()
      ->allow_extra_args(false);
  cli.add_option("--timeout", options->give_up_after_s,
                 "Seconds until a rank that does not answer is lost and the job ends (60)")
      ->check(CLI::Range(1.0, 86'400.0));
  cli.add_flag("--times", options->shows_times,
               "At the end, where the wall time of each rank went, on standard error");
  cli.add_flag("--quiet", options->quiet, "No line for each rank at the start");
}

}  // namespace

MpiOptions ParseMpiOptionsOrExit(int argc, char** argv) {
  CLI::App cli("shoal-mpi runs one mission by all ranks of an MPI job.", "shoal-mpi");
  MpiOptions options;
  AddOptions(cli, &options);
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::exit(cli.exit(error) == 0 ? kExitOk : kExitUsage);
  }
  return options;
}

}  // namespace shoal
