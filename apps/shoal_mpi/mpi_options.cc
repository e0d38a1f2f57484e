#include "apps/shoal_mpi/mpi_options.h"

#include "apps/shoal_mpi/watched_process.h"
#include "lib/run/command_line/command.h"
#include "lib/run/run/log_arguments.h"

namespace shoal {

namespace {

constexpr char kFooter[] =
    "Started by mpirun -n N shoal-mpi FILE, or by srun -n N --mpi=pmix shoal-mpi FILE. Log, "
    "verdict "
    "and\nsummary are those of `shoal sim FILE`, for any number of ranks: "
    "docs/missions/many_machines.md\n"
    "Exit codes: 0 pass, 1 fail, 2 command line or mission file, 3 the machine: a rank is lost.";

void AddOptions(Command program, MpiOptions* options) {
  program.Footer(kFooter);
  program.AddOption("FILE", &options->mission_file, "Mission file, the same on every host")
      .Required();
  program
      .AddOption("--set", &options->overrides,
                 "Override a key of the mission file, e.g. comms.comms_range=100")
      .Repeatable();
  program.AddOption("--log", &options->log_path,
                    "Rank 0 writes a log of the mission, in place of a file of this name; "
                    "FILE.lcm.zst: compressed");
  AddChannelChoice(program, &options->log_channels);
  program
      .AddOption("--place", &options->placed,
                 "Vehicles that go to a rank, e.g. 0=alpha,bravo or 1=group:north, or "
                 "1=shore_broker; the others are "
                 "shared out by cost")
      .Repeatable();
  program
      .AddOption("--timeout", &options->give_up_after_s,
                 "Seconds until a rank that does not answer is lost and the job ends (60)")
      .InRange(1.0, 86'400.0);
  program.AddFlag("--times", &options->shows_times,
                  "At the end, where the wall time of each rank went, on standard error");
  program.AddFlag("--quiet", &options->quiet, "No line for each rank at the start");
}

}  // namespace

MpiOptions ParseMpiOptionsOrExit(int argc, char** argv) {
  Program program("shoal-mpi", "shoal-mpi runs one mission by all ranks of an MPI job.");
  MpiOptions options;
  AddOptions(program, &options);
  program.ParseOrExit(argc, argv);
  return options;
}

int RunShoalMpi(int argc, char** argv) {
  const MpiOptions options = ParseMpiOptionsOrExit(argc, argv);
  return RunWatched([&] { return RunMpiMission(options); });
}

}  // namespace shoal
